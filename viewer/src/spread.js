// Handles in a crowd, moved apart on the screen: a lens that opens under the pointer and moves only what is near.

const ROUNDS = 160;
const LENS = 7; // the radius of the lens, in least distances

/**
 * Places at which no two of `points` ([x, y]) lie nearer than `apart`; those that `holds` says stay where they are.
 * What is moved is moved little, and the same points always move alike.
 * @param {(i: number) => boolean} holds
 */
export function spread(points, apart, holds = () => false) {
  const at = points.map(([x, y]) => [x, y]);
  const held = points.map((_, i) => holds(i));
  for (let round = 0; round < ROUNDS; round++) if (!pushed(at, held, apart * 1.02)) return at;
  return loosened(at, points, held, apart);
}

/** One round of pushing pairs apart; false when there was none to push. */
function pushed(at, held, apart) {
  let any = false;
  for (let i = 0; i < at.length; i++) {
    for (let j = 0; j < i; j++) {
      if (held[i] && held[j]) continue;
      const [dx, dy] = [at[i][0] - at[j][0], at[i][1] - at[j][1]];
      const off = Math.hypot(dx, dy);
      if (off >= apart) continue;
      any = true;
      const angle = 2.4 * (i + 1); // for those in one place: one direction each
      const [ux, uy] = off > 1e-6 ? [dx / off, dy / off] : [Math.cos(angle), Math.sin(angle)];
      const by = (apart - off) * (held[i] || held[j] ? 1 : 0.5);
      if (!held[i]) at[i] = [at[i][0] + by * ux, at[i][1] + by * uy];
      if (!held[j]) at[j] = [at[j][0] - by * ux, at[j][1] - by * uy];
    }
  }
  return any;
}

/** Where pushing comes to no end: all drawn away from their middle, until the nearest two are far enough. */
function loosened(at, points, held, apart) {
  const free = at.filter((_, i) => !held[i]);
  const least = leastDistance(free);
  const factor = least > 0 ? Math.max(1, apart / least) : 1;
  const middle = [0, 1].map((axis) => free.reduce((sum, each) => sum + each[axis], 0) / Math.max(1, free.length));
  return at.map((each, i) => (held[i] ? points[i] : each.map((value, axis) => middle[axis] + factor * (value - middle[axis]))));
}

export function leastDistance(points) {
  let least = Infinity;
  points.forEach(([x, y], i) => points.slice(0, i).forEach(([u, v]) => (least = Math.min(least, Math.hypot(x - u, y - v)))));
  return least;
}

/**
 * A lens at `pointer` over handles ([x, y] each, of which `aimed`, if any, is where it is to stay): {offsets} by index,
 * or null where no two handles under it lie nearer than `apart`.  Handles outside of it stay.
 */
export function lensAt(points, pointer, apart, aimed = -1) {
  const radius = LENS * apart;
  const off = ([x, y]) => Math.hypot(x - pointer[0], y - pointer[1]);
  const near = points.map((_, i) => i).filter((i) => off(points[i]) < radius + 2 * apart);
  if (leastDistance(near.filter((i) => off(points[i]) < radius).map((i) => points[i])) >= apart) return null;
  const placed = spread(near.map((i) => points[i]), apart, (k) => near[k] === aimed || off(points[near[k]]) > radius);
  return new Map(near.map((i, k) => [i, [placed[k][0] - points[i][0], placed[k][1] - points[i][1]]]));
}
