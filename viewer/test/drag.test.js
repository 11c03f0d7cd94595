// The viewer's rule of drags on the vectors that the Python rule and the Blender extension run too.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { beginDrag, dragTo } from '../src/drag.js';

const VECTORS = JSON.parse(readFileSync(new URL('../../tests/drag_vectors.json', import.meta.url)));

/** One drag from its start; calls `seen` with each step and the member values after it. */
function replayed(vector, { start, steps }, seen) {
  const members = vector.values.map((values, control) => ({ control, values }));
  const controls = members.map((_, i) => ({ minimum: vector.minimum[i], default: vector.default[i], maximum: vector.maximum[i] }));
  const element = { members, tracks: vector.tracks, axes: vector.axes };
  const drag = beginDrag(element, controls, vector.base, start, (point) => point);
  for (const step of steps) {
    const changed = dragTo(drag, ...step.to);
    seen(step, start.map((value, i) => changed.get(i) ?? value));
  }
}

function check(vector, step, values) {
  const said = `${values} at ${step.to}`;
  values.forEach((value, i) => assert.ok(vector.minimum[i] <= value && value <= vector.maximum[i], `out of range: ${said}`));
  const pairs = vector.axes.filter((axis) => axis.length === 2);
  for (const pair of pairs) assert.ok(pair.some((i) => values[i] === vector.default[i]), `both ends: ${said}`);
  step.values?.forEach((value, i) => assert.ok(Math.abs(values[i] - value) <= step.within[i], `${said}, not ${step.values}`));
}

for (const [name, vector] of Object.entries(VECTORS)) {
  test(name, () => {
    assert.ok(vector.drags.length);
    for (const drag of vector.drags) replayed(vector, drag, (step, values) => check(vector, step, values));
  });
}
