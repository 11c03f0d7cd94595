// From a drag in the plane of the screen to the values of an element's controls; usdrigui/pose/drag.py says the
// rule, and schemas/conformance/drags.json holds both to the same answers.
//
// An axis of the element is one control, with coordinates from 0 at its minimum to 1 at its maximum, or two
// opposed ones, the ends -1 and 1 of one signed axis: of these one at most is away from its default.

import { alongTrack, clamp, dot, lengthOf, mixed, pieceOf } from './vectors.js';

const LEAST = 24; // pixels that a track is given when it is shorter than a quarter of this on the screen
const FARTHER = 2; // a handle leaves its branch for another that is this many times nearer to the pointer...
const STRAY = 4; // ...and this many pixels besides
const STAY = 0.02; // pixels that a whole range costs: decides between axes that lie on one line
const TIE = 1.02;
const BENT = 0.25; // pixels by which half of a step may lie beside its middle
const FINEST = 6; // times that a step is halved at most
const SAME = 1e-9; // coordinates nearer to each other than this are one

/**
 * A drag of one element, begun at the present pose.  `project` maps a root-space point to [x, y] in pixels,
 * `rest` and `values` are all control values in the base pose and at the start.
 */
export function beginDrag(element, controls, rest, values, project) {
  const tracks = element.members.map(({ values: knots }, m) => onScreen(knots, element.tracks[m], (point) => project(point).slice(0, 2)));
  const axes = longEnough(element.axes.map((members) => screenAxis(element, members, tracks, controls, rest)));
  const start = axes.map(({ ends }) => coordinateOf(ends, (control) => values[control]));
  return { axes, start, current: start };
}

/** Control values, as a Map of control to value, for a handle [dx, dy] pixels from where it was at the start. */
export function dragTo(drag, dx, dy) {
  const follow = drag.axes.map((_, i) => i).filter((i) => drag.axes[i].follows);
  const [axes, start, last] = [drag.axes, drag.start, drag.current].map((list) => follow.map((i) => list[i]));
  const goal = axes.reduce((sum, axis, i) => plus(sum, pointAt(axis, start[i])), [dx, dy]);
  const found = axes.length > 2 ? onFan(axes, start, last, goal) : onPair(axes, start, last, goal);
  drag.current = [...drag.start];
  follow.forEach((i, k) => (drag.current[i] = found[k]));
  const changed = new Map();
  axes.forEach(({ ends }, k) => ends.forEach((end) => changed.set(end.control, valueOf(end, found[k]))));
  return changed;
}

/**
 * [control, value] pairs of one axis, moved by a share of its range from where it is; an opposed pair is two ranges
 * long, and one end of it at most is away from its default.
 */
export function movedAlong(element, axis, by, controls, rest, values) {
  const ends = endsOf(element, element.axes[axis], controls, rest);
  const at = coordinateOf(ends, (control) => values[control]) + by;
  return ends.map((end) => [end.control, valueOf(end, at)]);
}

/**
 * [axis, 1 or -1]: which axis of a drag just begun carries its handle nearest to the direction [x, y] of the screen
 * (y down), and which way along it.
 */
export function axisToward({ axes }, direction) {
  const shares = axes.map(({ points, follows }) => {
    const across = minus(points.at(-1), points[0]);
    const length = Math.hypot(...across);
    return follows && length ? (across[0] * direction[0] + across[1] * direction[1]) / length : 0;
  });
  const sizes = shares.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  return [axis, shares[axis] < 0 ? -1 : 1];
}

// --- axes ------------------------------------------------------------------------------------------

const endsOf = (element, members, controls, rest) =>
  members.map((m, k) => axisEnd(element.members[m].control, members.length > 1 ? 2 * k - 1 : 0, controls, rest));

/** A track in pixels: with more corners than its own where it comes so near to the viewer that its steps grow on the way. */
function onScreen(knots, track, project) {
  const places = track.map((point, i) => ({ value: knots[i], point, at: project(point) }));
  const found = [places[0]];
  const goTo = (from, to, finer) => {
    const point = from.point.map((value, axis) => mixed(value, to.point[axis], 0.5));
    const half = { value: mixed(from.value, to.value, 0.5), point, at: project(point) };
    const off = half.at.map((value, axis) => value - mixed(from.at[axis], to.at[axis], 0.5));
    if (!finer || Math.hypot(...off) <= BENT) found.push(to);
    else {
      goTo(from, half, finer - 1);
      goTo(half, to, finer - 1);
    }
  };
  places.slice(1).forEach((place, i) => goTo(places[i], place, FINEST));
  return { values: found.map(({ value }) => value), points: found.map(({ at }) => at) };
}

/** Corners of an axis: ascending coordinates `at`, and pixels from the handle's place in the base pose. */
function screenAxis(element, members, tracks, controls, rest) {
  const ends = endsOf(element, members, controls, rest);
  const base = coordinateOf(ends, (control) => rest[control]);
  const corners = ends.flatMap((end, k) => tracks[members[k]].values.map((value) => end.sign * shareOf(end, value)));
  const sorted = [base, ...ends.flatMap(({ sign }) => [0, sign]), ...corners].sort((a, b) => a - b);
  const at = sorted.filter((each, i) => i + 1 === sorted.length || sorted[i + 1] - each > SAME);
  const onTrack = (k, value) => alongTrack(tracks[members[k]].values, tracks[members[k]].points, value);
  const moved = (coordinate) => (sum, end, k) => plus(sum, minus(onTrack(k, valueOf(end, coordinate)), onTrack(k, end.base)));
  return { ends, base, at, points: at.map((each) => ends.reduce(moved(each), [0, 0])), follows: true };
}

/** A control on its axis, from `off` at 0 to `far` at `sign`; alone (`side` 0) over its whole range. */
function axisEnd(control, side, controls, rest) {
  const { minimum, default: middle, maximum } = controls[control];
  const base = rest[control];
  if (side === 0) return { control, sign: 1, off: minimum, far: maximum, base };
  return { control, sign: side, off: middle, far: farOf(controls[control]), base };
}

/** Where an end of a signed axis goes to from its default: the farther bound. */
export const farOf = ({ minimum, default: middle, maximum }) => (maximum - middle >= middle - minimum ? maximum : minimum);

/** Value of an end: `off` on the other side of 0, and in the base pose that value to the last bit. */
function valueOf({ sign, off, far, base }, coordinate) {
  const share = clamp(sign * coordinate, 0, 1);
  const found = mixed(off, far, share);
  return Math.abs(found - base) <= 1e-12 * Math.abs(far - off) ? base : found;
}

const shareOf = ({ off, far }, value) => (far === off ? 0 : clamp((value - off) / (far - off), 0, 1));

const coordinateOf = (ends, value) => ends.reduce((sum, end) => sum + end.sign * shareOf(end, value(end.control)), 0);

/** A slider seen from its end is given a length; of several axes, one seen from its end keeps its value. */
function longEnough(axes) {
  const lengths = axes.map(({ points }) => lengthOf(points));
  const longest = Math.max(...lengths);
  const follows = (i, length) => lengths[i] >= length / 4;
  if (longest >= LEAST / 4) return axes.map((axis, i) => ({ ...axis, follows: follows(i, LEAST) }));
  if (axes.length === 1) return [straightened(axes[0])];
  if (longest < 1) return axes.map((axis) => ({ ...axis, follows: false }));
  const longer = ([x, y]) => [(x * LEAST) / longest, (y * LEAST) / longest];
  return axes.map((axis, i) => ({ ...axis, points: axis.points.map(longer), follows: follows(i, longest) }));
}

/** LEAST pixels along what is left of the direction, or else upward. */
function straightened(axis) {
  const across = minus(axis.points.at(-1), axis.points[0]);
  const length = Math.hypot(...across);
  const [x, y] = length >= 1 ? [across[0] / length, across[1] / length] : [0, -1];
  const shares = axis.at.map((each) => (LEAST * (each - axis.base)) / (axis.at.at(-1) - axis.at[0]));
  return { ...axis, points: shares.map((share) => [share * x, share * y]) };
}

// --- the nearest point -------------------------------------------------------------------------------

const NONE = { ends: [], base: 0, at: [0, 1], points: [[0, 0], [0, 0]] }; // an axis that goes nowhere

/** Coordinates of one or two axes. */
function onPair(axes, start, last, goal) {
  if (axes.length === 2) return nearest(axes, start, last, goal).at;
  const [one = NONE] = axes;
  return nearest([one, NONE], [...start, 0, 0], [...last, 0, 0], goal).at.slice(0, axes.length);
}

/**
 * The point of two axes nearest to the goal: downhill from the parallelogram that holds the handle, so that a
 * curved track does not jump to another branch, unless that is nearer by far.
 */
function nearest([u, v], start, last, goal) {
  const rows = u.at.slice(1).map((_, i) => v.at.slice(1).map((__, j) => inCell(u, v, i, j, start, goal)));
  const every = rows.flat();
  const best = every.reduce((least, each) => (each.away < least.away ? each : least));
  let mine = rows[pieceOf(u.at, last[0])][pieceOf(v.at, last[1])];
  for (let next = leastAround(rows, mine); next !== mine; next = leastAround(rows, mine)) mine = next;
  return mine.away > FARTHER * best.away + STRAY ? best : mine;
}

function leastAround(rows, cell) {
  const around = rows.slice(Math.max(0, cell.i - 1), cell.i + 2).flatMap((row) => row.slice(Math.max(0, cell.j - 1), cell.j + 2));
  return around.reduce((least, each) => (each.away < least.away ? each : least), cell);
}

/** Nearest point of the parallelogram of two pieces: the free minimum, or else one on the four sides. */
function inCell(u, v, i, j, start, goal) {
  const a = [...minus(u.points[i + 1], u.points[i]), STAY * (u.at[i + 1] - u.at[i]), 0];
  const b = [...minus(v.points[j + 1], v.points[j]), 0, STAY * (v.at[j + 1] - v.at[j])];
  const off = minus(plus(u.points[i], v.points[j]), goal);
  const r = [...off, STAY * (u.at[i] - start[0]), STAY * (v.at[j] - start[1])];
  const [aa, bb, ab, ra, rb] = [dot(a, a), dot(b, b), dot(a, b), dot(r, a), dot(r, b)];
  const area = Math.max(aa * bb - ab * ab, 1e-300);
  const tried = [
    [(ab * rb - bb * ra) / area, (ab * ra - aa * rb) / area],
    [-ra / aa, 0],
    [-(ra + ab) / aa, 1],
    [0, -rb / bb],
    [1, -(rb + ab) / bb],
  ];
  let best = { away: Infinity };
  for (const free of tried) {
    const [x, y] = free.map((each) => clamp(each, 0, 1));
    const away = Math.hypot(...r.map((each, k) => each + x * a[k] + y * b[k]));
    if (away < best.away) best = { away, i, j, at: [mixed(u.at[i], u.at[i + 1], x), mixed(v.at[j], v.at[j + 1], y)] };
  }
  return best;
}

/** Of more axes: the nearest of the pairs of arms that are neighbours by angle; all other axes at rest. */
function onFan(axes, start, last, goal) {
  const inUse = (i, sign) => Math.abs(last[i] - axes[i].base) > SAME && last[i] > axes[i].base === sign;
  const count = axes.filter((_, i) => inUse(i, true) || inUse(i, false)).length;
  const held = (pair) => pair.filter(({ i, arm }) => inUse(i, arm.at.at(-1) > axes[i].base)).length === count;
  const pairs = armPairs(axes);
  let best = { away: Infinity, set: last };
  for (const pair of [...pairs.filter(held), ...pairs.filter((each) => !held(each))]) {
    const chosen = pair.map(({ i }) => i);
    const others = axes.filter((_, i) => !chosen.includes(i));
    const left = others.reduce((sum, axis) => minus(sum, pointAt(axis, axis.base)), goal);
    const from = pair.map(({ i, arm }) => clamp(last[i], arm.at[0], arm.at.at(-1)));
    const found = nearest(pair.map(({ arm }) => arm), chosen.map((i) => start[i]), from, left);
    if (found.away * TIE + 1e-6 >= best.away) continue;
    const set = axes.map((axis, i) => (chosen.includes(i) ? found.at[chosen.indexOf(i)] : axis.base));
    best = { away: found.away, set };
  }
  return best.set;
}

/** Arms (the parts of an axis on either side of the base pose) next to each other, less than 180 degrees apart. */
function armPairs(axes) {
  const arms = axes.flatMap((axis, i) => armsOf(axis).map((arm) => ({ i, arm, angle: armAngle(arm, pointAt(axis, axis.base)) })));
  const order = arms.sort((p, q) => p.angle - q.angle);
  const pairs = order.map((arm, k) => [arm, order[(k + 1) % order.length]]);
  return pairs.filter(([p, q]) => p.i !== q.i && (q.angle - p.angle + 2 * Math.PI) % (2 * Math.PI) < Math.PI);
}

function armsOf(axis) {
  const away = axis.at.map((each) => Math.abs(each - axis.base));
  const middle = away.indexOf(Math.min(...away));
  const part = (from, to) => ({ at: axis.at.slice(from, to), points: axis.points.slice(from, to) });
  return [part(0, middle + 1), part(middle)].filter(({ at }) => at.length > 1);
}

/** Angle of an arm's farthest point. */
function armAngle(arm, origin) {
  const away = arm.points.map((point) => minus(point, origin));
  const far = away.reduce((most, each) => (dot(each, each) > dot(most, most) ? each : most));
  return Math.atan2(far[1], far[0]);
}

// --- polylines ---------------------------------------------------------------------------------------

const pointAt = (axis, coordinate) => alongTrack(axis.at, axis.points, coordinate);

const plus = (a, b) => [a[0] + b[0], a[1] + b[1]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
