// Axes of elements; drags are those of the conformance suite, which the Python rule and the Blender extension pass too.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { OrbitCamera } from '../src/camera.js';
import { axisToward, beginDrag, dragTo, movedAlong } from '../src/drag.js';

const { questions } = JSON.parse(readFileSync(new URL('../../schemas/conformance/drags.json', import.meta.url)));

/** The element of a vector and its controls, as the viewer has them. */
function records(vector) {
  const members = vector.values.map((values, control) => ({ control, values }));
  const controls = members.map((_, i) => ({ minimum: vector.minimum[i], default: vector.default[i], maximum: vector.maximum[i] }));
  return { element: { members, tracks: vector.tracks, axes: vector.axes }, controls };
}

function check(vector, step, values) {
  const said = `${values} at ${step.to}`;
  values.forEach((value, i) => assert.ok(vector.minimum[i] <= value && value <= vector.maximum[i], `out of range: ${said}`));
  const pairs = vector.axes.filter((axis) => axis.length === 2);
  for (const pair of pairs) assert.ok(pair.some((i) => values[i] === vector.default[i]), `both ends: ${said}`);
}

test('an axis moved by a share of its range sets one end', () => {
  for (const vector of questions) {
    const { element, controls } = records(vector);
    vector.axes.forEach((axis, number) => {
      for (const by of [0.3, -0.7, Infinity, -Infinity]) {
        const values = [...vector.base];
        for (const [control, value] of movedAlong(element, number, by, controls, vector.base, values)) values[control] = value;
        check({ ...vector, axes: [axis] }, { to: by }, values);
      }
    });
  }
  const { element, controls } = records(questions.find((each) => each.element === 'straight two-way slider'));
  const along = (by, values) => movedAlong(element, 0, by, controls, [0, 0], values).map(([, value]) => value);
  assert.deepEqual(along(0.5, [0.25, 0]), [0, 0.25]);
  assert.deepEqual(along(-0.5, [0.25, 0]), [0.75, 0]);
  assert.deepEqual(along(-Infinity, [0, 0.5]), [1, 0]);
});

test('an arrow key takes the axis that carries the handle its way', () => {
  const controls = [0, 1].map(() => ({ minimum: -1, default: 0, maximum: 1 }));
  const values = [-1, 1];
  const members = controls.map((_, control) => ({ control, values }));
  const tracks = [[[0, -9], [0, 9]], [[40, 1], [-40, -1]]]; // the first goes down the screen, the second to the left
  const drag = beginDrag({ members, tracks, axes: [[0], [1]] }, controls, [0, 0], [0, 0], (point) => point);
  const found = [[0, -1], [0, 1], [1, 0], [-1, 0]].map((arrow) => axisToward(drag, arrow));
  assert.deepEqual(found, [[0, -1], [0, 1], [1, -1], [1, 1]]);
});

test('a handle on a track that comes toward the viewer stays under the pointer', () => {
  const camera = new OrbitCamera([0, 1, 0], [0, 0, 1]);
  const column = { left: 0, top: 0, width: 800, height: 600 };
  camera.frame([[-1, -1, -1], [1, 1, 1]], 800, 600);
  const project = camera.projector(column);
  const controls = [{ minimum: 0, default: 0, maximum: 1 }];
  const track = [[0.35, 0.2, -1.5], [0.5, 0.3, camera.distance - 4]];
  const element = { members: [{ control: 0, values: [0, 1] }], tracks: [track], axes: [[0]] };
  const at = (value) => project(track[0].map((from, axis) => from + value * (track[1][axis] - from)));
  const drag = beginDrag(element, controls, [0], [0], project);
  const [start, end] = [at(0), at(1)];
  for (let step = 0; step <= 10; step++) {
    const goal = [0, 1].map((axis) => (step / 10) * (end[axis] - start[axis]));
    const [x, y] = at(dragTo(drag, ...goal).get(0));
    const off = Math.hypot(x - start[0] - goal[0], y - start[1] - goal[1]);
    assert.ok(off < 0.6, `${off} pixels at step ${step}`);
  }
});
