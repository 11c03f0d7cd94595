// Keys and values by the names of controls, as files hold them, and back: a new layout or a changed rig can take them up.

import { WAYS, wayOf } from './interpolation.js';
import { rounded } from './vectors.js';

/** Keys and constant values by names of controls, in the controls' order, and the frames as set by hand.  A file calls constants `standing`. */
export function sayKeys({ controls }, { keys, constants, span = null }) {
  const byNames = (map, say) => Object.fromEntries([...map].sort(([a], [b]) => a - b).map(([control, value]) => [controls[control].name, say(value)]));
  return {
    keys: byNames(keys, (track) => track.map(([frame, value, ...way]) => [rounded(frame), rounded(value), ...way])),
    standing: byNames(constants, rounded),
    ...(span ? { span } : {}),
  };
}

/** The opposite of `sayKeys`; controls that the character lacks and values that are none are left out. */
export function keysFrom({ keys, standing, span }, { controls, animation }) {
  const own = animation.isFree && isSpan(span) ? span : null;
  return { keys: byControl(keys, controls, isTrack), constants: byControl(standing, controls, Number.isFinite), span: own };
}

/** Values by names of controls, and back; what the character lacks and what is no number is left out. */
export const valuesByName = (session, values) => sayKeys(session, { keys: new Map(), constants: values }).standing;
export const byName = (values, controls) => byControl(values, controls, Number.isFinite);

function byControl(entries, controls, isValid) {
  const index = new Map(controls.map(({ name }, i) => [name, i]));
  const known = Object.entries(entries ?? {}).filter(([name, value]) => index.has(name) && isValid(value));
  return new Map(known.map(([name, value]) => [index.get(name), value]));
}

/** What JSON text says, or `otherwise` where it is none. */
export function parsed(text, otherwise = null) {
  try {
    return JSON.parse(text);
  } catch {
    return otherwise;
  }
}

const isSpan = (span) => Array.isArray(span) && span.length === 2 && span.every(Number.isInteger) && span[0] < span[1];
const isKey = (key) =>
  Array.isArray(key) && [2, 3, 4].includes(key.length) && key.slice(0, 2).every(Number.isFinite) && WAYS.includes(wayOf(key)) && Number.isFinite(key[3] ?? 0);
const isTrack = (track) => Array.isArray(track) && track.length > 0 && track.every(isKey);
