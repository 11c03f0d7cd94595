// What is done to keys and poses: pure functions from keys (control -> [[frame, value, way, slope]], ascending) or values to others.

import { wayOf, withKey, withoutKey } from './interpolation.js';

const LONG = 1e6; // frames, beside which it is nothing that each comes to a whole one

/** Keys of `picked` ([control, frame] each) that there are, as [control, key]. */
const found = (keys, picked) =>
  picked.flatMap(([control, frame]) => (keys.get(control) ?? []).filter(([when]) => when === frame).map((key) => [control, key]));

/**
 * @typedef {Map<number, any[][]>} Keys
 *
 * Keys with those `picked` as `change` has them, [frame, value] to [frame, value], in place of what was there, and which these
 * are, 'control frame' each; `copies` leaves the old.  Slopes are as much less steep as time is slower.
 */
export function changedKeys(keys, picked, change, copies = false) {
  const changed = found(keys, picked).map(([control, key]) => {
    const [frame, value] = change(key, control);
    const pace = (change([key[0] + LONG, key[1]], control)[0] - frame) / LONG;
    return [control, [frame, value, wayOf(key), key.length > 3 && pace ? key[3] / pace : null]];
  });
  return { keys: withKeys(copies ? keys : removedKeys(keys, picked), changed), picked: new Set(changed.map(([control, [frame]]) => `${control} ${frame}`)) };
}

/** Keys with others, [control, [frame, value, way, slope]] each, in place of what was there. */
export function withKeys(keys, added) {
  const out = new Map(keys);
  for (const [control, key] of added) out.set(control, withKey(out.get(control) ?? [], ...key));
  return out;
}

/**
 * Where frames come as the key at `held` moves `by` frames: as much later, or within a `span` scaled about the end of it that is
 * farther away.
 * @param {number} by @param {number} held @param {number[] | null} span
 */
export function retimed(by, held, span) {
  if (!span) return (frame) => frame + by;
  const fixed = held - span[0] > span[1] - held ? span[0] : span[1];
  return (frame) => Math.round(fixed + ((frame - fixed) * (held + by - fixed)) / (held - fixed));
}

export function removedKeys(keys, picked) {
  const out = new Map(keys);
  for (const [control, frame] of picked) {
    const left = withoutKey(out.get(control) ?? [], frame);
    if (left.length) out.set(control, left);
    else out.delete(control);
  }
  return out;
}

/** Keys with those picked going to their next ones in another way, without slopes of their own. */
export const keysGoing = (way, keys, picked) => withKeys(keys, found(keys, picked).map(([control, [frame, value]]) => [control, [frame, value, way, null]]));

/** Picked keys to be pasted elsewhere: [control, key], from frame 0. */
export function copiedKeys(keys, picked) {
  const first = Math.min(...picked.map(([, frame]) => frame));
  return found(keys, picked).map(([control, key]) => [control, [key[0] - first, ...key.slice(1)]]);
}

/** Keys with copied ones from a frame on. */
export const pastedKeys = (keys, copied, first) => withKeys(keys, copied.map(([control, [frame, value, way = 'linear', slope = null]]) => [control, [first + frame, value, way, slope]]));

/** [control, frame] of the keys of some controls between two frames, or of all. */
export const keysWithin = (keys, controls, [first, last] = [-Infinity, Infinity]) =>
  controls.flatMap((control) => (keys.get(control) ?? []).filter(([frame]) => frame >= first && frame <= last).map(([frame]) => [control, frame]));

/**
 * Values between the keys before and after a frame: [control, value] with share 0 at the one before, 1 at the one
 * after, less and more beyond.  Controls that have no key on one of the two sides are left out.
 */
export function tweened(keys, controls, frame, share) {
  return controls.flatMap((control) => {
    const track = keys.get(control) ?? [];
    const [before, after] = [track.findLast(([when]) => when < frame), track.find(([when]) => when > frame)];
    return before && after ? [[control, before[1] + share * (after[1] - before[1])]] : [];
  });
}

// --- poses of one side and the other -------------------------------------------------------------------

/**
 * The pose seen in a mirror: [control, value] of all that changes.  `twins` is each control's partner or -1, `opposites`
 * the other ends of its axes, `crosses` whether one moves the face to one side, `mirrored` the partner's like value.
 */
export function flipped({ values, controls, rest, twins, opposites, crosses, mirrored }) {
  return controls.flatMap(({ minimum, maximum }, index) => {
    if (twins[index] >= 0) return [[index, mirrored(twins[index], index)]];
    if (!crosses(index)) return [];
    const [other] = opposites[index];
    if (other !== undefined && crosses(other)) return [[index, mirrored(other, index)]];
    const both = minimum < rest[index] && maximum > rest[index];
    return both ? [[index, 2 * rest[index] - values[index]]] : [];
  });
}

/** The pose with one side's values on the other, too: [control, value] of the other side. */
export function mirroredFrom(side, { twins, sideOf, mirrored }) {
  return [...twins.entries()].filter(([control, twin]) => twin >= 0 && sideOf(control) === side).map(([control, twin]) => [twin, mirrored(control, twin)]);
}
