// The law of the lens: under the pointer no two handles overlap, what is aimed at stays, and so does what is far.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { leastDistance, lensAt, spread } from '../src/spread.js';

const APART = 13;

/** Numbers from 0 to 1, the same in every run. */
function numbers(seed) {
  let state = seed;
  return () => (state = (1103515245 * state + 12345) % 2147483648) / 2147483648;
}

const crowd = (seed, count, size) => {
  const random = numbers(seed);
  return Array.from({ length: count }, () => [300 + size * random(), 200 + size * random()]);
};

for (const [seed, count, size] of [[1, 2, 0], [2, 40, 80], [3, 90, 60], [4, 120, 400], [5, 30, 1]]) {
  test(`no two of ${count} handles within ${size} pixels overlap under the pointer`, () => {
    const points = crowd(seed, count, size);
    const aimed = 0;
    const offsets = lensAt(points, points[aimed], APART, aimed) ?? new Map();
    const moved = points.map(([x, y], i) => [x + (offsets.get(i)?.[0] ?? 0), y + (offsets.get(i)?.[1] ?? 0)]);
    const away = ([x, y]) => Math.hypot(x - points[aimed][0], y - points[aimed][1]);
    assert.ok(leastDistance(moved.filter((_, i) => away(points[i]) < 4 * APART)) >= APART - 1e-6);
    assert.deepEqual(moved[aimed], points[aimed]);
    points.forEach((point, i) => away(point) > 9 * APART && assert.deepEqual(moved[i], point));
  });
}

test('handles that are apart are left alone', () => {
  const points = [[0, 0], [20, 0], [0, 20]];
  assert.equal(lensAt(points, [1, 1], APART), null);
  assert.deepEqual(spread(points, APART), points);
});
