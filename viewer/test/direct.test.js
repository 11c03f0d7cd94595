// Pulls of the skin: one end of an axis at most, never farther from the target, the better ends found.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { boundedLeastSquares, fitPull, oneEndOfEach } from '../src/direct.js';
import { oppositesOf, twinsOf } from '../src/posing.js';
import { random, scene } from '../../tests/pulled_scenes.mjs';

const { questions } = JSON.parse(readFileSync(new URL('../../schemas/conformance/drags.json', import.meta.url)));
const VECTORS = Object.fromEntries(questions.map((each) => [each.element, each]));

function pulled(made, start, now, target, towards = null) {
  const targets = [...target, ...made.positions(start).slice(3)];
  const groups = made.controls.map((_, index) => [index]);
  const found = fitPull({ model: made, start, now, targets, groups, towards, locality: 0.1 });
  return { values: start.map((value, i) => found.get(i) ?? value), targets };
}

function check(made, values, said) {
  for (const [a, b] of made.pairs) {
    assert.ok(values[a] === made.off(a) || values[b] === made.off(b), `both ends: ${values[a]}, ${values[b]}; ${said}`);
  }
  values.forEach((value, i) => assert.ok(made.minimum(i) <= value && value <= made.maximum(i), `range: ${value}; ${said}`));
}

const missed = (made, values, targets) => Math.hypot(...made.positions(values).map((at, i) => targets[i] - at));

/** A drag of three moves from a random pose. */
function drags(made, rng, said) {
  const start = made.pose(rng);
  let now = start;
  for (let move = 0; move < 3; move++) {
    const target = made.positions(start).slice(0, 3).map((at) => at + 1.5 * (rng() - 0.5) * made.size);
    const { values, targets } = pulled(made, start, now, target);
    check(made, values, said);
    assert.ok(missed(made, values, targets) <= missed(made, start, targets) * (1 + 1e-9), `farther away; ${said}`);
    now = values;
  }
}

test('a pull of made scenes sets one end of an axis and comes nearer', () => {
  for (let seed = 1; seed <= 120; seed++) {
    const rng = random(seed);
    drags(scene(rng, 1 + (seed % 5), seed % 4, 1 + (seed % 3), 1 + (seed % 4)), rng, `seed ${seed}`);
  }
});

test('a pull of the tracks of real rigs sets one end of an axis and comes nearer', () => {
  const real = Object.entries(VECTORS).filter(([name, { axes }]) => name.includes('turned by') && axes.some((axis) => axis.length === 2));
  assert.ok(real.length > 9);
  real.forEach(([name, vector], number) => {
    const flat = (track) => [track.map(([x, y]) => [x, y, 0])];
    const ranges = vector.minimum.map((minimum, i) => ({ minimum, default: vector.default[i], maximum: vector.maximum[i] }));
    const rng = random(number + 1);
    const made = scene.of(ranges, vector.values, vector.tracks.map(flat), vector.axes.filter((axis) => axis.length === 2));
    for (let drag = 0; drag < 12; drag++) drags(made, rng, name);
  });
});

test('of ends that were both typed a pull keeps one', () => {
  const rng = random(3);
  const halfway = ({ minimum, maximum }) => (minimum + maximum) / 2;
  const made = scene(rng, 3, 1, 1, 1);
  const { values } = pulled(made, made.controls.map(halfway), made.controls.map(halfway), [0.2, 0.1, 0]);
  check(made, values, 'typed');
});

test('a pull back to where it began gives the pose at the start', () => {
  const rng = random(5);
  const made = scene(rng, 4, 3, 2, 3);
  const start = made.pose(rng);
  const away = pulled(made, start, start, [1, 1, 1]).values;
  assert.notDeepEqual(away, start);
  assert.deepEqual(pulled(made, start, away, made.positions(start).slice(0, 3)).values, start);
});

test('the ends are as good as those of an exhaustive search', () => {
  let rough = 0;
  for (let seed = 1; seed <= 150; seed++) {
    const problem = boundedProblem(random(seed), 1 + (seed % 5), seed % 3);
    const costOf = (x) => problem.columns[0].reduce((sum, _, i) => {
      const rest = problem.right[i] - problem.columns.reduce((way, column, k) => way + column[i] * x[k], 0);
      return sum + rest * rest;
    }, x.reduce((sum, value, k) => sum + problem.ridge[k] * value * value, 0));
    const costs = choices(problem.pairs).map((held) => {
      const [lower, upper] = [[...problem.lower], [...problem.upper]];
      for (const k of held) lower[k] = upper[k] = problem.off[k];
      return costOf(boundedLeastSquares({ ...problem, lower, upper }).x);
    });
    const least = Math.min(...costs);
    rough += costs.some((cost) => cost > 1.05 * least);
    const found = costOf(oneEndOfEach(problem).x);
    assert.ok(Math.abs(found - least) <= 1e-6 * least, `seed ${seed}: ${found}, best ${least}`);
  }
  assert.ok(rough > 100);
});

/** Every way to hold one end of each pair off. */
const choices = (pairs) => pairs.reduce((lists, pair) => lists.flatMap((list) => pair.map((k) => [...list, k])), [[]]);

/** Ends that go where they like, from poses at one end of each pair. */
function boundedProblem(rng, pairCount, singles) {
  const count = 2 * pairCount + singles;
  const start = Array.from({ length: count }, (_, k) => (k < 2 * pairCount && (k % 2 || rng() < 0.4) ? 0 : rng()));
  return {
    columns: start.map(() => Float64Array.from({ length: 6 }, () => rng() - 0.5)),
    right: Float64Array.from({ length: 6 }, () => 2 * (rng() - 0.5)),
    ridge: start.map(() => 0.01 * (1 + 3 * rng())),
    lower: start.map((value) => -value),
    upper: start.map((value) => 1 - value),
    off: start.map((value) => -value),
    pairs: Array.from({ length: pairCount }, (_, p) => [2 * p, 2 * p + 1]),
  };
}

test('opposed controls are no twins, nor are reversed members', () => {
  const both = { name: 'both', mirror: 'both', axes: [[1, 0]], members: [{ control: 0 }, { control: 1 }] };
  const one = (name, mirror, control, reversed) => ({ name, mirror, reversed, axes: [[0]], members: [{ control }] });
  const ends = [one('l', 'r', 0), one('r', 'l', 1)];
  const turning = [one('L', 'R', 2, [0]), one('R', 'L', 3, [0])];
  const plain = [one('a', 'b', 4), one('b', 'a', 5)];
  const opposites = oppositesOf([both, ...ends, ...turning, ...plain], 6);
  assert.deepEqual(opposites, [[1], [0], [], [], [], []]);
  assert.deepEqual([...twinsOf([both, ...ends, ...turning, ...plain], opposites)], [-1, -1, -1, -1, 5, 4]);
});

/** One control along x, and six that go a fifth as far, a little off that way each. */
function sparseScene() {
  const directions = [[1, 0, 0], ...[-3, -2, -1, 1, 2, 3].map((k) => [0.2, 0.06 * k, 0])];
  const ranges = directions.map(() => ({ minimum: 0, default: 0, maximum: 1 }));
  return scene.of(ranges, directions.map(() => [0, 1]), directions.map((way) => [[[0, 0, 0], way]]), []);
}

test('a pull takes few controls, in reach and out of it', () => {
  const made = sparseScene();
  const start = made.controls.map(() => 0);
  for (const target of [[0.4, 0, 0], [0.9, 0.02, 0], [30, 0, 0]]) {
    const { values } = pulled(made, start, start, target);
    assert.equal(values.filter((value) => value !== 0).length, 1, `${target}: ${values}`);
    assert.ok(Math.abs(values[0] - Math.min(1, target[0])) < 0.03, `${target}: ${values}`);
  }
});

test('controls come in from nothing: a little farther pull changes little', () => {
  const made = sparseScene();
  const start = made.controls.map(() => 0);
  let before = start;
  for (let step = 1; step <= 300; step++) {
    const { values } = pulled(made, start, start, [0.01 * step, 0.006 * step, 0]);
    values.forEach((value, i) => assert.ok(Math.abs(value - before[i]) < 0.12, `step ${step}: ${before} to ${values}`));
    before = values;
  }
  assert.ok(before.filter((value) => value !== 0).length > 1);
});
