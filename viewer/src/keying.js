// What is done to keys and poses: pure functions from keys (control -> [[frame, value]], ascending) or values to others.

import { withKey, withoutKey } from './animation.js';

/** Keys with those `picked` ([control, frame] each) `by` frames later, in place of what was there; `copies` leaves the old. */
export function movedKeys(keys, picked, by, copies = false) {
  const found = picked.map(([control, frame]) => [control, frame, valueAt(keys, control, frame)]).filter(([, , value]) => value !== undefined);
  const out = copies ? new Map(keys) : removedKeys(keys, picked);
  for (const [control, frame, value] of found) out.set(control, withKey(out.get(control) ?? [], frame + by, value));
  return out;
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

const valueAt = (keys, control, frame) => keys.get(control)?.find(([when]) => when === frame)?.[1];

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
