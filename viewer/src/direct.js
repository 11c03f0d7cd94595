// Direct manipulation: pull the skin, and the controls take the best fit.
//
// After J. P. Lewis and K. Anjyo, "Direct manipulation blendshapes", IEEE Computer Graphics and
// Applications 30(4), 2010.  With x_j the change of control j since the drag began as a share of its
// range, J x the motion of the grabbed place and the pins, and r what is left to their targets:
//
//   minimise  |W (J x - r)|^2 / L^2 + STAY sum_j (1 + ELSEWHERE (1 - s_j)^2) x_j^2   within the ranges,
//
// L the longest path that a control gives the grabbed place, s_j the share of control j's longest path
// anywhere that it gives there, W counting the direction to the viewer less: a pointer moves in the plane
// of the screen.  Bends (in-betweens, joints) are met by linearising again at the answer.

const STAY = 0.01;
const ELSEWHERE = 3;
const DEPTH = 0.15;
const ROUNDS = 2;

/**
 * Values that bring the grabbed point to `target`, as a Map of control index to value.
 *
 * `model`: {minimum(i), maximum(i), linearise(values) -> {at: 3 numbers per constraint, motion(i) -> the
 * same per unit of control i}, peak(i) -> longest way that control i moves anything}; `start`: values at the start of the drag; `now`: where to linearise;
 * `targets`: 3 numbers per constraint, the grabbed point first; `groups`: lists of controls that move
 * together; `towards`: unit direction to the viewer; `locality`: share of the strongest influence on the
 * grabbed point below which a control is left alone.
 */
export function fitPull({ model, start, now, targets, groups, towards, locality }) {
  const weights = rowWeights(targets.length, towards);
  let current = Float64Array.from(now);
  let acting = null;
  for (let round = 0; round < ROUNDS; round++) {
    const here = model.linearise(current);
    const columns = groups.map((group) => columnOf(model, here, group, targets.length));
    acting ??= local(groups, columns, locality);
    if (!acting.length) return new Map();
    const problem = pullProblem(model, here.at, start, current, targets, groups, columns, acting, weights);
    const step = boundedLeastSquares(problem);
    acting.forEach((g, k) => {
      for (const control of groups[g]) {
        current[control] = clamp(start[control] + step[k], model.minimum(control), model.maximum(control));
      }
    });
  }
  return new Map(acting.flatMap((g) => groups[g].map((control) => [control, current[control]])));
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

/** Groups that matter at the grabbed point (the first three rows). */
function local(groups, columns, locality) {
  const strength = columns.map(({ paths }) => Math.max(...paths));
  const least = locality * strength.reduce((most, value) => Math.max(most, value), 0);
  return groups.map((_, g) => g).filter((g) => strength[g] > 0 && strength[g] >= least);
}

const rangeOf = (model, group) => Math.max(...group.map((control) => model.maximum(control) - model.minimum(control)));

/** Per constraint the direction that counts less: that to the viewer, for the grabbed place only. */
function rowWeights(rows, towards) {
  return Array.from({ length: rows / 3 }, (_, i) => (i === 0 && towards ? towards : null));
}

function weighted(rows, weights) {
  const out = Float64Array.from(rows);
  weights.forEach((towards, i) => {
    if (!towards) return;
    const deep = out[3 * i] * towards[0] + out[3 * i + 1] * towards[1] + out[3 * i + 2] * towards[2];
    for (let axis = 0; axis < 3; axis++) out[3 * i + axis] -= (1 - DEPTH) * deep * towards[axis];
  });
  return out;
}

/** The bounded problem in the controls' own units: x in values, not in shares of the range. */
function pullProblem(model, at, start, current, targets, groups, columns, acting, weights) {
  const left = Float64Array.from(targets, (target, i) => target - at[i]);
  acting.forEach((g) => {
    const taken = current[groups[g][0]] - start[groups[g][0]];
    for (let i = 0; i < left.length; i++) left[i] += columns[g].column[i] * taken;
  });
  const ranges = acting.map((g) => rangeOf(model, groups[g]));
  const longest = Math.max(...acting.flatMap((g) => columns[g].paths));
  const stay = acting.map((g) => groups[g].reduce((sum, control, k) => {
    const share = Math.min(1, columns[g].paths[k] / Math.max(model.peak(control), 1e-30));
    return sum + STAY * (1 + ELSEWHERE * (1 - share) ** 2);
  }, 0));
  return {
    columns: acting.map((g) => weighted(columns[g].column, weights)),
    right: weighted(left, weights),
    ridge: ranges.map((range, k) => (stay[k] * longest ** 2) / range ** 2),
    lower: acting.map((g) => Math.max(...groups[g].map((control) => model.minimum(control) - start[control]))),
    upper: acting.map((g) => Math.min(...groups[g].map((control) => model.maximum(control) - start[control]))),
  };
}

/**
 * min |A x - b|^2 + sum ridge_k x_k^2 subject to lower <= x <= upper, by Bertsekas' projected Newton
 * method: variables held at a bound by their gradient are fixed, the others take a Newton step, which by
 * the Woodbury identity needs a system of as many equations as A has rows only.
 */
export function boundedLeastSquares({ columns, right, ridge, lower, upper }) {
  const count = columns.length;
  let x = Float64Array.from({ length: count }, (_, k) => clamp(0, lower[k], upper[k]));
  let value = cost(columns, right, ridge, x);
  for (let round = 0; round < 100; round++) {
    const rest = residual(columns, right, x);
    const gradient = columns.map((column, k) => -dot(column, rest) + ridge[k] * x[k]);
    const free = [];
    for (let k = 0; k < count; k++) {
      const held = (x[k] <= lower[k] && gradient[k] > 0) || (x[k] >= upper[k] && gradient[k] < 0);
      if (!held && upper[k] > lower[k]) free.push(k);
    }
    const step = newtonStep(columns, ridge, gradient, free);
    let moved = null;
    for (let length = 1; length > 1e-10 && !moved; length /= 2) {
      const next = Float64Array.from(x);
      free.forEach((k, i) => (next[k] = clamp(x[k] + length * step[i], lower[k], upper[k])));
      const nextValue = cost(columns, right, ridge, next);
      if (nextValue < value) moved = [next, nextValue];
    }
    if (!moved) break;
    const gained = value - moved[1];
    [x, value] = moved;
    if (gained <= 1e-14 * Math.max(1e-300, value)) break;
  }
  return x;
}

/** -(D + A'A)^-1 g on the free variables, with D the ridge: (D + A'A)^-1 = D^-1 - D^-1 A' (I + A D^-1 A')^-1 A D^-1. */
function newtonStep(columns, ridge, gradient, free) {
  if (!free.length) return [];
  const rows = columns[0].length;
  const small = Array.from({ length: rows }, (_, i) => Float64Array.from({ length: rows }, (_, j) => (i === j ? 1 : 0)));
  const right = new Float64Array(rows);
  for (const k of free) {
    const column = columns[k];
    for (let i = 0; i < rows; i++) {
      right[i] += (column[i] * gradient[k]) / ridge[k];
      for (let j = 0; j < rows; j++) small[i][j] += (column[i] * column[j]) / ridge[k];
    }
  }
  const inner = solveSymmetric(small, right);
  return free.map((k) => -(gradient[k] - dot(columns[k], inner)) / ridge[k]);
}

/** Cholesky solution of a small positive definite system. */
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

function residual(columns, right, x) {
  const rest = Float64Array.from(right);
  columns.forEach((column, k) => {
    if (x[k] !== 0) for (let i = 0; i < rest.length; i++) rest[i] -= column[i] * x[k];
  });
  return rest;
}

function cost(columns, right, ridge, x) {
  const rest = residual(columns, right, x);
  return dot(rest, rest) + ridge.reduce((sum, weight, k) => sum + weight * x[k] * x[k], 0);
}

function dot(a, b) {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i] * b[i];
  return sum;
}

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
