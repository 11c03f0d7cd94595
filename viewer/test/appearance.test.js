import assert from 'node:assert/strict';
import { test } from 'node:test';
import { onEyes, tints } from '../src/eye.js';
import { openness } from '../src/openness.js';
import { sumNormals } from '../src/surface.js';

const EYE = { pupil: [0.1, 0.1, 0.1], iris: [0.4, 0.3, 0.2], white: [0.9, 0.9, 0.9], radii: [0.2, 0.5] };

test('an eye is dark in the middle, coloured around it and white beyond', () => {
  const { factors, perRadius, last } = tints(EYE);
  const at = (away) => factors[3 * Math.min(last, Math.floor(away * perRadius))];
  assert.ok(Math.abs(at(0.1) - 0.1 / 0.9) < 1e-6);
  assert.ok(at(0.3) > 0.4 && at(0.3) < 0.5);
  for (const away of [0.6, 1, 2]) assert.equal(at(away), 1);
});

test('a triangle is on an eye with all its corners, or not at all', () => {
  assert.deepEqual([...onEyes([0, 1, 2, 1, 2, 3], [0, 0, 1, 0, 0, 2, 9, 9])], [1, 0]);
});

/** A closed box inside another, as the inside of a mouth is: 8 points each, faces outward for both. */
function boxes() {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, i >> 2].map((bit) => 2 * bit - 1));
  const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  const triangles = faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
  const points = Float32Array.from([...corners, ...corners.map((corner) => corner.map((value) => 0.5 * value))].flat());
  return { points, triangles: Uint32Array.from([...triangles, ...triangles.map((corner) => corner + 8)]) };
}

test('what is outside is open to the light, what is inside is dark', () => {
  const { points, triangles } = boxes();
  const normals = new Float32Array(points.length);
  sumNormals(points, triangles, [], normals);
  const open = openness(points, normals, triangles);
  assert.ok(open.subarray(0, 8).every((value) => value > 0.95), `${open}`);
  assert.ok(open.subarray(8).every((value) => value < 0.2), `${open}`);
});
