// Numbers, lists of them, and lines through points in the plane or in space.

export const rounded = (value) => Number(value.toPrecision(9));
export const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
export const mixed = (a, b, share) => (1 - share) * a + share * b;

/** Different numbers in ascending order. @param {Iterable<number>} values */
export const ascending = (values) => [...new Set(values)].sort((a, b) => a - b);

/** Whether two lists hold the same things. */
export const alike = (a, b) => a.length === b.length && a.every((each, i) => each === b[i]);

/** What a map holds for a key; what it does not hold yet is made of the key, and kept. */
export function known(map, key, make) {
  if (!map.has(key)) map.set(key, make(key));
  return map.get(key);
}

export function dot(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
}

export function unit(a) {
  const length = Math.hypot(...a);
  return a.map((value) => value / length);
}

/** Position on a line through points, at which `knots` ascend, at a value; beyond the ends the last pieces go on. */
export function alongTrack(knots, track, value) {
  if (knots.length === 1) return track[0];
  const [i, share] = shareAt(knots, value);
  return track[i].map((from, axis) => mixed(from, track[i + 1][axis], share));
}

/** Piece of ascending knots and share of it at a value; beyond the ends the outer pieces go on. */
export function shareAt(knots, value) {
  const i = pieceOf(knots, value);
  return [i, (value - knots[i]) / (knots[i + 1] - knots[i])];
}

export function pieceOf(knots, value) {
  let i = 0;
  while (i < knots.length - 2 && value >= knots[i + 1]) i++;
  return i;
}

export function lengthOf(track) {
  let total = 0;
  for (let k = 1; k < track.length; k++) total += Math.hypot(...track[k].map((to, axis) => to - track[k - 1][axis]));
  return total;
}
