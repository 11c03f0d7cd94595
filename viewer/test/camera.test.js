// A camera that looks through one of a shot, and leaves it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrbitCamera } from '../src/camera.js';

const COLUMN = { left: 0, top: 0, width: 400, height: 100 };
const ROLLED = [[0.6, 0.8, 0], [-0.8, 0.6, 0], [0, 0, 1], [1, 2, 10], [0.5, 0.25]];

const near = (found, wanted) => found.forEach((value, i) => assert.ok(Math.abs(value - wanted[i]) < 1e-9, `${found} is not ${wanted}`));

test('through the camera of a shot its whole picture is seen, rolled as it is', () => {
  const camera = new OrbitCamera([0, 1, 0], [0, 0, 1]);
  camera.lookThrough(ROLLED, COLUMN);
  // Half of its picture is 0.5 by 0.25 at a distance of 1; its height fills the wide column.
  near(camera.projector(COLUMN)([1 + 0.6 * 5 - 0.8 * 2.5, 2 + 0.8 * 5 + 0.6 * 2.5, 0]), [300, 0, 10]);
  const narrow = { ...COLUMN, width: 100 };
  camera.lookThrough(ROLLED, narrow);
  near(camera.projector(narrow)([1 + 0.6 * 5, 2 + 0.8 * 5, 0]), [100, 50, 10]);
  near(camera.unproject(narrow, 100, 50, 10), [1 + 0.6 * 5, 2 + 0.8 * 5, 0]);
});

test('who looks elsewhere has the own lens again, and the face as large as it was', () => {
  for (const move of [(camera) => camera.turn(camera.azimuth, camera.elevation), (camera) => camera.zoom(1), (camera) => camera.pan(0, 0, 100)]) {
    const camera = new OrbitCamera([0, 1, 0], [0, 0, 1]);
    const { half } = camera;
    camera.lookThrough(ROLLED, COLUMN);
    const [size, target] = [camera.pixelSize(100), camera.target];
    move(camera);
    assert.equal(camera.half, half);
    near([camera.pixelSize(100), ...camera.target], [size, ...target]);
    near(camera.above, [0, 1, 0]);
  }
});
