import assert from 'node:assert/strict';
import { test } from 'node:test';
import { doubled, texturing } from '../src/surface.js';

test('a point at which the texture is cut is a vertex at each of its places', () => {
  // Two triangles that share the points 1 and 2, at other places of the image each; the third has no image.
  const steps = (numbers) => numbers.map((value) => Math.round(65535 * value));
  const own = { images: [0, 0, -1], uv: steps([0, 0.75, 0, 0.25, 1, 0, 0, 0.75, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0]) };
  const mesh = { start: 1, triangles: Uint32Array.of(0, 1, 2, 1, 3, 2, 0, 2, 3), visible: true, texture: own };
  const found = texturing({ meshes: [mesh], pointCount: 5, texture: { width: 11, height: 11, boxes: [[0, 0, 11, 11]] } });
  assert.deepEqual([...found.on], [1, 1, 0]);
  assert.deepEqual([...found.corners.subarray(0, 6)], [1, 2, 3, 5, 4, 6]);
  assert.deepEqual(found.doubles, [2, 3, 1, 3, 4]);
  const place = (vertex) => [found.places[2 * vertex], found.places[2 * vertex + 1]].map((value) => Math.round(1000 * value) / 1000);
  assert.deepEqual([1, 2, 3].map(place), [[0.045, 0.955], [0.273, 0.955], [0.045, 0.045]]);
  assert.ok([...found.corners.subarray(6)].every((vertex) => found.places[2 * vertex] < 0));
  assert.deepEqual([...doubled(Float32Array.of(0, 1, 2, 3, 4), 1, found.doubles)], [0, 1, 2, 3, 4, 2, 3, 1, 3, 4]);
});
