// Poses as a USD layer, and back: below /Poses a Scope for each, with its name, its picture, and a SkelAnimation of default
// values for each animation of the character that it reaches.  A pose of some controls lists the channels of these alone.

import { poseAnimations } from './animation_layer.js';
import { byName, valuesByName } from './by_name.js';
import { keeping, layerText, quoted, stringsNamed } from './usda.js';

/** The layer of `poses` ({name, values: control index -> value, picture}) as usda text, and controls that it cannot hold. */
export function posesLayer(session, poses) {
  const lost = new Set();
  /** @type {Map<string, object>} */
  const prims = new Map([['/Poses', { type: 'def Scope' }]]);
  for (const { name, values, picture } of poses) {
    const { animations, unwritten } = poseAnimations(session, values);
    unwritten.forEach((control) => lost.add(control));
    const stored = { name, values: valuesByName(session, values), picture };
    const home = freePath('/Poses', name, prims);
    const metadata = [`displayName = ${quoted(name)}`, ...keeping('customData', `string pose = ${quoted(JSON.stringify(stored))}`)].join('\n');
    prims.set(home, { type: 'def Scope', metadata });
    for (const { path, lines } of animations) prims.set(freePath(home, path.split('/').at(-1), prims), { type: 'def SkelAnimation', lines });
  }
  return { text: layerText(prims, ['defaultPrim = "Poses"']), unwritten: [...lost] };
}

/** Poses from such a layer; throws an Error for people where there is none of this character. */
export function posesFromLayer(text, session) {
  if (!text.startsWith('#usda') || !stringsNamed('pose', text).length) throw new Error('This layer holds no poses saved by the viewer.');
  const known = posesOf(text, session);
  if (!known.length) throw new Error('No control of this character is named in the poses.');
  return known;
}

/** Those of its poses that name a control of this character. */
export const posesOf = (text, session) => stringsNamed('pose', text).map((stored) => poseFrom(JSON.parse(stored), session)).filter(Boolean);

/** A pose of the session's controls from one by names; null where it says nothing of them. */
export function poseFrom({ name, values, picture }, session) {
  const known = byName(values, session.controls);
  const shown = typeof picture === 'string' && picture.startsWith('data:image/') ? picture : '';
  return known.size ? { name: String(name), values: known, picture: shown } : null;
}

/** A path below another with a name that USD allows, and that no prim has taken. */
function freePath(home, name, prims) {
  const plain = `${home}/${name.replace(/[^A-Za-z0-9_]/g, '_').replace(/^(?=[0-9]|$)/, '_')}`;
  let free = plain;
  for (let number = 2; prims.has(free); number++) free = `${plain}_${number}`;
  return free;
}
