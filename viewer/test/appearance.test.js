import assert from 'node:assert/strict';
import { test } from 'node:test';
import { onEyes, tints } from '../src/eye.js';

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
