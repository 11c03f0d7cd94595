import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Animation } from '../src/animation.js';

test('without a clip the frames are as set by hand, and keys reach beyond them', () => {
  const animation = new Animation({ controls: [], clip: null }, Float64Array.of());
  assert.deepEqual(animation.range(new Map()), [1, 48]);
  animation.span = [101, 120];
  assert.deepEqual(animation.range(new Map()), [101, 120]);
  assert.deepEqual(animation.range(new Map([[0, [[99.5, 1], [130, 0]]]])), [99, 130]);
});

test('without a clip the frames are those of the stage', () => {
  const animation = new Animation({ controls: [], clip: null, timeCodes: [101, 148, 30] }, Float64Array.of());
  assert.deepEqual(animation.range(new Map()), [101, 148]);
  assert.equal(animation.rate, 30);
});
