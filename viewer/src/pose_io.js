// Poses out and in, as JSON for people and scripts.

import { rounded } from './vectors.js';

/** The pose as JSON text: values by control name, those away from their defaults only. */
export function poseToJson(session) {
  const values = {};
  session.controls.forEach((control, index) => {
    if (session.values[index] !== control.default) values[control.name] = rounded(session.values[index]);
  });
  return `${JSON.stringify({ usdrigui: 'pose', root: session.character.root, values }, null, 2)}\n`;
}

/**
 * Values by control index from JSON text; controls that it does not name take their defaults.
 * Throws an Error for people when the text is no pose.
 */
export function poseFromJson(text, session) {
  let found;
  try {
    found = JSON.parse(text);
  } catch {
    throw new Error('This is not JSON.');
  }
  const values = found?.values ?? found;
  if (values === null || typeof values !== 'object' || Array.isArray(values)) throw new Error('This JSON holds no pose.');
  const known = session.controls.filter(({ name }) => Number.isFinite(values[name]));
  if (!known.length && Object.keys(values).length) throw new Error('No control of this character is named in the pose.');
  return session.controls.map((control, index) => [index, Number.isFinite(values[control.name]) ? values[control.name] : control.default]);
}

