// Keys as sparse opinions over a clip: one rule for what a control is at a time.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { keyedValue, withKey, withoutKey } from '../src/animation.js';

const clip = (time) => 10 + time;
const track = [[4, 0], [8, 1]];

test('between keys the value is linear, and at a key it is the key', () => {
  for (const over of [clip, null]) {
    assert.deepEqual([4, 5, 6, 8].map((time) => keyedValue(track, time, over)), [0, 0.25, 0.5, 1]);
  }
});

test('a clip plays on outside the keys, from one frame away', () => {
  assert.deepEqual([1, 3, 9, 20].map((time) => keyedValue(track, time, clip)), [11, 13, 19, 30]);
  assert.deepEqual([3.5, 8.25].map((time) => keyedValue(track, time, clip)), [6.5, 0.75 + 0.25 * 19]);
});

test('where the clip does not move a control its first and last key hold', () => {
  assert.deepEqual([-5, 3.5, 8.25, 90].map((time) => keyedValue(track, time, null)), [0, 0, 1, 1]);
});

test('one key is one frame of a clip, and everything where there is none', () => {
  assert.deepEqual([5, 6, 7].map((time) => keyedValue([[6, 3]], time, clip)), [15, 3, 17]);
  assert.deepEqual([5, 6, 7].map((time) => keyedValue([[6, 3]], time, null)), [3, 3, 3]);
});

test('keys stay in order, one at a time', () => {
  assert.deepEqual(withKey(withKey(track, 6, 5), 4, 2), [[4, 2], [6, 5], [8, 1]]);
  assert.deepEqual(withoutKey(track, 4), [[8, 1]]);
});
