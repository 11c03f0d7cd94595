// Poses as a USD layer, and back: below /Poses a Scope for each, with its name, its picture, and a SkelAnimation of default
// values for each animation of the character that it reaches.  A pose of some controls lists the channels of these alone.

import { poseAnimations } from './animation_layer.js';
import { byName, valuesByName } from './by_name.js';
import { quoted, stringsNamed } from './usda.js';

/** The layer of `poses` ({name, values: control index -> value, picture}) as usda text, and controls that it cannot hold. */
export function posesLayer(session, poses) {
  const lost = new Set();
  const taken = new Set();
  const prims = poses.flatMap((pose) => {
    const { animations, unwritten } = poseAnimations(session, pose.values);
    unwritten.forEach((name) => lost.add(name));
    return posePrim(pose, animations, session, taken);
  });
  const text = ['#usda 1.0', '(', '    defaultPrim = "Poses"', ')', '', 'def Scope "Poses"', '{', ...prims.map((line) => `    ${line}`), '}', ''].join('\n');
  return { text, unwritten: [...lost] };
}

function posePrim({ name, values, picture }, animations, session, taken) {
  const own = new Set();
  const stored = { name, values: valuesByName(session, values), picture };
  return [
    `def Scope ${quoted(identifier(name, taken))} (`,
    `    displayName = ${quoted(name)}`,
    '    customData = {',
    '        dictionary usdrigui = {',
    `            string pose = ${quoted(JSON.stringify(stored))}`,
    '        }',
    '    }',
    ')',
    '{',
    ...animations.flatMap(({ path, lines }) => [
      `    def SkelAnimation ${quoted(identifier(path.split('/').at(-1), own))}`,
      '    {',
      ...lines.map((line) => `        ${line}`),
      '    }',
    ]),
    '}',
  ];
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

/** A name that USD allows, and that none has taken. */
function identifier(name, taken) {
  const plain = name.replace(/[^A-Za-z0-9_]/g, '_').replace(/^(?=[0-9]|$)/, '_');
  let free = plain;
  for (let number = 2; taken.has(free); number++) free = `${plain}_${number}`;
  taken.add(free);
  return free;
}
