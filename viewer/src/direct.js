// Direct manipulation: pull the skin, and the controls take the best fit.
//
// After J. P. Lewis and K. Anjyo, "Direct manipulation blendshapes", IEEE Computer Graphics and
// Applications 30(4), 2010.  With x_j the change of control j since the drag began as a share of its
// range, J x the motion of the grabbed place and the pins, and r what is left to their targets:
//
//   minimise  |W (J x - r)|^2 / L^2 + STAY sum_j (1 + ELSEWHERE (1 - s_j)^2) x_j^2 + SPARSE g sum_j |x_j|
//
// within the ranges, g the steepest slope that any control has at the start, and L the longest path that a control gives the grabbed place, s_j the share of control j's longest path
// anywhere that it gives there, W counting the direction to the viewer less: a pointer moves in the plane
// of the screen.  Bends (in-betweens, joints) are met by linearising again at the answer.
//
// The last term leaves out what helps little: a control comes in, from 0 on, only while its slope is more than SPARSE / 2 of
// the steepest.  It also leaves part of the way to go, which is put on top of r for a second solution (S. Osher et al.,
// "An iterative regularization method", 2005); of what is out of reach no more than that part is.
//
// Two opposed controls are the ends of one signed axis: of these one at most is away from its default.  Which
// one is found by branch and bound over the pairs that the fit without this rule would set at both ends.

import { clamp, dot } from './vectors.js';

const STAY = 0.01;
const SPARSE = 0.5;
const ELSEWHERE = 3;
const DEPTH = 0.15;
const ROUNDS = 2;
const WORK = 1000; // variables of the bounded problems solved in search of the better ends
const SAME = 1e-9; // shares of the range nearer to each other than this are one

/**
 * Values that bring the grabbed point to `target`, as a Map of control index to value.
 *
 * `model`: {minimum(i), maximum(i), linearise(values) -> {at: 3 numbers per constraint, motion(i) -> the
 * same per unit of control i}, peak(i) -> longest way that control i moves anything, opposites(i) -> controls of
 * which none is away from its off(i) where control i is}; `start`: values at the start of the drag; `now`: where to linearise;
 * `targets`: 3 numbers per constraint, the grabbed point first; `groups`: lists of controls that move
 * together; `towards`: unit direction to the viewer; `locality`: share of the strongest influence on the
 * grabbed point below which a control is left alone.
 */
export function fitPull({ model, start, now, targets, groups, towards, locality }) {
  const away = (at) => weighted(targets.map((target, i) => target - at[i]), towards);
  /** @type {any} */
  let problem = null;
  let acting = null;
  let solution = null;
  const found = [Float64Array.from(now)];
  for (let round = 0; round < ROUNDS; round++) {
    const here = model.linearise(found[round]);
    acting ??= local(model, groups, here, locality);
    if (!acting.length) return new Map();
    problem = pullProblem(model, here, start, found[round], away(here.at), acting, towards);
    solution = solution ? rounded(problem, solved(problem, solution.held, solution.rest)) : oneEndOfEach(problem);
    found.push(taken(model, start, acting, allTheWay(problem, solution).x));
  }
  const tried = [...(bothAway(model, start, acting) ? [] : [start]), ...found.slice(1)];
  const best = least(tried, (values) => costOf(problem, acting, start, values, away(model.linearise(values).at)));
  return new Map(groups.flat().map((control) => [control, best[control]]));
}

/** The solution once more, with what the cost of moving controls left of the way on top of it. */
function allTheWay(problem, { held, rest }) {
  const [pulled, most] = [rest.subarray(0, 3), 0.5 * SPARSE * norm(problem.right.subarray(0, 3))];
  const share = Math.min(1, most / Math.max(norm(pulled), 1e-30));
  const farther = { ...problem, right: problem.right.map((value, i) => value + (i < 3 ? share : 1) * rest[i]) };
  return rounded(farther, solved(farther, held, rest));
}

/** The pose at the start with a solution; an end that is as good as off is off to the last bit. */
function taken(model, start, acting, step) {
  const values = Float64Array.from(start);
  acting.forEach((group, k) => {
    for (const control of group) {
      const value = clamp(start[control] + step[k], model.minimum(control), model.maximum(control));
      values[control] = isOff(model, control, value) ? model.off(control) : value;
    }
  });
  return values;
}

const isOff = (model, control, value) =>
  model.opposites(control).length > 0 && Math.abs(value - model.off(control)) <= SAME * (model.maximum(control) - model.minimum(control));

/** Whether both ends of an axis are set, as an animator may have typed. */
function bothAway(model, values, acting) {
  const isAway = (control) => values[control] !== model.off(control);
  return acting.flat().some((control) => isAway(control) && model.opposites(control).some(isAway));
}

/** What is minimised, at the true motion rather than the linear one. */
function costOf({ ridge }, acting, start, values, rest) {
  return dot(rest, rest) + acting.reduce((sum, [control], k) => sum + ridge[k] * (values[control] - start[control]) ** 2, 0);
}

/** Motion per unit of a group's value, and each control's own path at the grabbed place over its range. */
function columnOf(model, here, group, rows) {
  const column = new Float64Array(rows);
  const paths = group.map((control) => {
    const motion = here.motion(control);
    motion.forEach((value, i) => (column[i] += value));
    return Math.hypot(motion[0], motion[1], motion[2]) * (model.maximum(control) - model.minimum(control));
  });
  return { column, paths };
}

/** Groups that matter at the grabbed point (the first three rows), and those of their opposite ends. */
function local(model, groups, here, locality) {
  const strength = groups.map((group) => Math.max(...columnOf(model, here, group, here.at.length).paths));
  const lowest = locality * strength.reduce((most, value) => Math.max(most, value), 0);
  const matter = groups.filter((_, g) => strength[g] > 0 && strength[g] >= lowest);
  const ends = new Set(matter.flat().flatMap((control) => model.opposites(control)));
  return groups.filter((group) => matter.includes(group) || group.some((control) => ends.has(control)));
}

const rangeOf = (model, group) => Math.max(...group.map((control) => model.maximum(control) - model.minimum(control)));

/** Rows of which those of the grabbed place, the first three, count less in the direction to the viewer. */
function weighted(rows, towards) {
  const deep = towards ? (1 - DEPTH) * dot(towards, rows) : 0;
  return Float64Array.from(rows, (value, i) => (deep && i < 3 ? value - deep * towards[i] : value));
}

/**
 * The bounded problem in the controls' own units: x in values, not in shares of the range.  Of each of `pairs`
 * one variable at most is away from its `off`.
 */
function pullProblem(model, here, start, current, away, acting, towards) {
  const made = acting.map((group) => columnOf(model, here, group, here.at.length));
  const columns = made.map(({ column }) => weighted(column, towards));
  const right = Float64Array.from(away);
  acting.forEach(([first], k) => {
    for (let i = 0; i < right.length; i++) right[i] += columns[k][i] * (current[first] - start[first]);
  });
  const longest = Math.max(...made.flatMap(({ paths }) => paths));
  const ridge = acting.map((group, k) => stayOf(model, group, made[k].paths) * (longest / rangeOf(model, group)) ** 2);
  const bounds = boundsOf(model, acting, start);
  return { columns, right, ridge, ...bounds, sparse: sparsityOf(model, acting, columns, right, bounds), pairs: pairsOf(model, acting) };
}

/** Cost of each variable's way off 0: a share of the steepest slope of the free ones, over their ranges. */
function sparsityOf(model, acting, columns, right, { lower, upper }) {
  const slope = (column, k) => {
    const along = dot(column, right);
    return (along > 0 ? upper[k] > 0 : lower[k] < 0) ? Math.abs(along) * rangeOf(model, acting[k]) : 0;
  };
  const steepest = Math.max(...columns.map(slope));
  return acting.map((group) => (SPARSE * steepest) / rangeOf(model, group));
}

function stayOf(model, group, paths) {
  return group.reduce((sum, control, k) => {
    const share = Math.min(1, paths[k] / Math.max(model.peak(control), 1e-30));
    return sum + STAY * (1 + ELSEWHERE * (1 - share) ** 2);
  }, 0);
}
/** Where each variable may go, and where it is off: at the bound that lets all of its controls be so. */
function boundsOf(model, acting, start) {
  const ways = (group, end) => group.map((control) => model[end](control) - start[control]);
  const lower = acting.map((group) => Math.max(...ways(group, 'minimum')));
  const upper = acting.map((group) => Math.min(...ways(group, 'maximum')));
  const off = acting.map((group, k) => {
    if (!model.opposites(group[0]).length) return 0;
    if (model.off(group[0]) === model.minimum(group[0])) return (lower[k] = Math.min(...ways(group, 'off')));
    return (upper[k] = Math.max(...ways(group, 'off')));
  });
  return { lower, upper, off };
}

function pairsOf(model, acting) {
  const places = new Map();
  acting.forEach((group, k) => group.forEach((control) => places.set(control, k)));
  const pairs = [];
  acting.forEach((group, k) => {
    const ends = new Set();
    for (const control of group) for (const end of model.opposites(control)) ends.add(places.get(end));
    for (const l of ends) if (l > k) pairs.push([k, l]);
  });
  return pairs;
}

/**
 * The best solution with one end of each pair off, as {x, rest, held, cost}: branch and bound, from one that puts the end off that moves
 * the places less.  The search ends after WORK at the best so far: five pairs and two more controls never take as much.
 */
export function oneEndOfEach(problem) {
  const relaxed = solved(problem, [], null);
  let best = rounded(problem, relaxed);
  let work = WORK;
  for (const open = [relaxed]; open.length && work > 0; ) {
    const here = /** @type {ReturnType<typeof solved>} */ (open.pop());
    if (here.cost >= best.cost) continue;
    const pair = mostBroken(problem, here.x);
    if (!pair) best = here;
    else open.push(...pair.map((k) => solved(problem, [...here.held, k], here.rest)).sort((p, q) => q.cost - p.cost));
    work -= 2 * problem.columns.length;
  }
  return best;
}

/** A solution with one end of each pair off, if not the best. */
function rounded(problem, from) {
  const broken = brokenPairs(problem, from.x);
  if (!broken.length) return from;
  const lesser = broken.map(([k, l]) => (wayOf(problem, from.x, k) < wayOf(problem, from.x, l) ? k : l));
  return rounded(problem, solved(problem, [...from.held, ...lesser], from.rest));
}

/** The bounded minimum with some variables held off. */
function solved(problem, held, from) {
  const [lower, upper] = [[...problem.lower], [...problem.upper]];
  for (const k of held) lower[k] = upper[k] = problem.off[k];
  const found = boundedLeastSquares({ ...problem, lower, upper }, from);
  return { held, ...found, cost: cost(problem, found.x) };
}

/** How far a variable away from off moves the places. */
const wayOf = ({ columns, off }, x, k) => Math.abs(x[k] - off[k]) * Math.sqrt(dot(columns[k], columns[k]));

const isAway = ({ lower, upper, off }, x, k) => Math.abs(x[k] - off[k]) > SAME * (upper[k] - lower[k]);

const brokenPairs = (problem, x) => problem.pairs.filter((pair) => pair.every((k) => isAway(problem, x, k)));

function mostBroken(problem, x) {
  const lesser = (pair) => Math.min(...pair.map((k) => wayOf(problem, x, k)));
  return least(brokenPairs(problem, x), (pair) => -lesser(pair));
}

/** The first of those that cost least; undefined where there are none. */
function least(all, costed) {
  /** @type {[any, number]} */
  let [best, lowest] = [undefined, Infinity];
  for (const each of all) {
    const own = costed(each);
    if (own < lowest) [best, lowest] = [each, own];
  }
  return best;
}

/**
 * min |A x - b|^2 + sum ridge_k x_k^2 + sum sparse_k |x_k| subject to lower <= x <= upper, as {x, rest}; `from` is the rest
 * of a like problem.
 *
 * The rest y = b - A x at the solution says all: x_k is a_k y / ridge_k, nearer to 0 by sparse_k / 2 ridge_k, within its bounds.  The dual problem, of as
 * many unknowns as A has rows, is convex and piecewise quadratic with the gradient y + A x(y) - b: Newton's method.
 */
export function boundedLeastSquares(problem, from = null) {
  const packed = pack(problem);
  const { rows, right } = packed;
  let rest = from ?? new Float64Array(rows);
  let here = dualAt(packed, rest);
  const enough = 1e-12 * (norm(right) + norm(here.gradient));
  for (let round = 0; round < 100 && norm(here.gradient) > enough; round++) {
    const step = solveSymmetric(curvature(packed, here.free), here.gradient.map((value) => -value));
    rest = alongStep(packed, rest, step, here);
    here = dualAt(packed, rest);
  }
  return { x: here.x, rest };
}

/** A bounded problem as arrays of numbers, columns one after the other: it is looked through some hundred times. */
function pack({ columns, right, ridge, sparse, lower, upper }) {
  const rows = right.length;
  const flat = new Float64Array(columns.length * rows);
  for (let k = 0, at = 0; k < columns.length; k++) for (let i = 0; i < rows; i++, at++) flat[at] = columns[k][i];
  const slack = sparse ? Float64Array.from(sparse, (value) => 0.5 * value) : new Float64Array(columns.length);
  return { rows, columns: flat, right, slack, ridge: Float64Array.from(ridge), lower: Float64Array.from(lower), upper: Float64Array.from(upper) };
}

/** How far each column goes along a direction. */
function allAlong({ rows, columns, ridge }, direction) {
  const along = new Float64Array(ridge.length);
  for (let k = 0, at = 0; k < along.length; k++) {
    let sum = 0;
    for (let i = 0; i < rows; i++, at++) sum += columns[at] * direction[i];
    along[k] = sum;
  }
  return along;
}

/** The dual at a rest: x, the gradient, each column along the rest, and the variables within their bounds. */
function dualAt(packed, rest) {
  const { rows, columns, right, slack, ridge, lower, upper } = packed;
  const along = allAlong(packed, rest);
  const x = new Float64Array(along.length);
  const gradient = new Float64Array(rows);
  const free = [];
  for (let i = 0; i < rows; i++) gradient[i] = rest[i] - right[i];
  for (let k = 0; k < x.length; k++) {
    const value = nearerToZero(along[k], slack[k]) / ridge[k];
    x[k] = clamp(value, lower[k], upper[k]);
    if (x[k] === value && value !== 0 && upper[k] > lower[k]) free.push(k);
    if (x[k] !== 0) for (let i = 0; i < rows; i++) gradient[i] += columns[k * rows + i] * x[k];
  }
  return { x, gradient, along, free };
}

/** I + A D^-1 A' of the free variables, with D the ridge. */
function curvature({ rows, columns, ridge }, free) {
  const matrix = Array.from({ length: rows }, () => new Float64Array(rows));
  matrix.forEach((row, i) => (row[i] = 1));
  for (const k of free) {
    const at = k * rows;
    for (let i = 0; i < rows; i++) {
      const row = matrix[i];
      const factor = columns[at + i] / ridge[k];
      for (let j = 0; j <= i; j++) row[j] += factor * columns[at + j];
    }
  }
  return matrix;
}

/** The rest after a step, or after the part of it at which the slope, which only rises, is nearly gone. */
function alongStep(packed, rest, step, { along, gradient }) {
  const pace = allAlong(packed, step); // each variable sees the step as one number
  const own = [dot(rest, step) - dot(packed.right, step), dot(step, step)];
  const enough = 0.1 * Math.abs(dot(gradient, step));
  let [low, high, length] = [0, Infinity, 1];
  for (let round = 0; round <= 40; round++) {
    const slope = own[0] + length * own[1] + slopeOf(packed, along, pace, length);
    if (Math.abs(slope) <= enough) break;
    if (slope > 0) high = length;
    else low = length;
    length = high < Infinity ? (low + high) / 2 : 2 * length;
  }
  return rest.map((value, i) => value + length * step[i]);
}

/** What the variables add to the slope after a part of a step. */
function slopeOf({ slack, ridge, lower, upper }, along, pace, length) {
  let slope = 0;
  for (let k = 0; k < pace.length; k++) {
    slope += pace[k] * clamp(nearerToZero(along[k] + length * pace[k], slack[k]) / ridge[k], lower[k], upper[k]);
  }
  return slope;
}

/** Cholesky solution of a small positive definite system, given by its lower half. */
function solveSymmetric(matrix, right) {
  const n = right.length;
  const l = matrix.map((row) => Float64Array.from(row));
  for (let j = 0; j < n; j++) {
    for (let k = 0; k < j; k++) for (let i = j; i < n; i++) l[i][j] -= l[i][k] * l[j][k];
    const pivot = Math.sqrt(Math.max(l[j][j], 1e-300));
    for (let i = j; i < n; i++) l[i][j] /= pivot;
  }
  const y = Float64Array.from(right);
  for (let i = 0; i < n; i++) {
    for (let k = 0; k < i; k++) y[i] -= l[i][k] * y[k];
    y[i] /= l[i][i];
  }
  for (let i = n - 1; i >= 0; i--) {
    for (let k = i + 1; k < n; k++) y[i] -= l[k][i] * y[k];
    y[i] /= l[i][i];
  }
  return y;
}

function cost({ columns, right, ridge, sparse }, x) {
  const rest = right.map((value, i) => columns.reduce((left, column, k) => left - column[i] * x[k], value));
  let sum = dot(rest, rest);
  for (let k = 0; k < x.length; k++) sum += (ridge[k] * Math.abs(x[k]) + (sparse?.[k] ?? 0)) * Math.abs(x[k]);
  return sum;
}

const nearerToZero = (value, by) => Math.sign(value) * Math.max(0, Math.abs(value) - by);
const norm = (a) => Math.sqrt(dot(a, a));
