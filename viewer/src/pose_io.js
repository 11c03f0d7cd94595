// Poses out and in, as JSON for people and scripts.

import { byName, parsed, valuesByName } from './by_name.js';
import { posed, saidPose } from './notes.js';

/** The pose as JSON text: values by control name, those away from their defaults only. */
export function poseToJson(session) {
  const values = valuesByName(session, saidPose(session, session.values));
  return `${JSON.stringify({ usdrigui: 'pose', root: session.character.root, values }, null, 2)}\n`;
}

/**
 * Values by control index from JSON text; controls that it does not name take their defaults.
 * Throws an Error for people when the text is no pose.
 */
export function poseFromJson(text, session) {
  const found = parsed(text, undefined);
  if (found === undefined) throw new Error('This is not JSON.');
  const values = found?.values ?? found;
  if (values === null || typeof values !== 'object' || Array.isArray(values)) throw new Error('This JSON holds no pose.');
  const known = byName(values, session.controls);
  if (!known.size && Object.keys(values).length) throw new Error('No control of this character is named in the pose.');
  return posed(session, { values: known }).entries();
}

