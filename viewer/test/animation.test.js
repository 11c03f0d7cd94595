// Keys as sparse opinions over a clip: one rule for what a control is at a time.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { keyedValue } from '../src/animation.js';
import { bendsOf, withKey, withoutKey } from '../src/interpolation.js';

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

test('a key keeps its way, a new one takes that of the key before', () => {
  const stepped = [[4, 0, 'stepped'], [8, 1]];
  assert.deepEqual(withKey(stepped, 4, 2), [[4, 2, 'stepped'], [8, 1]]);
  assert.deepEqual(withKey(stepped, 6, 5), [[4, 0, 'stepped'], [6, 5, 'stepped'], [8, 1]]);
  assert.deepEqual(withKey(stepped, 2, 5), [[2, 5, 'stepped'], [4, 0, 'stepped'], [8, 1]]);
  assert.deepEqual(withKey(stepped, 4, 2, 'linear'), [[4, 2], [8, 1]]);
});

test('a stepped key holds until the moment before the next, and is linear between the times told', () => {
  const stepped = [[4, 0, 'stepped'], [8, 1]];
  const [turn] = bendsOf(stepped);
  assert.ok(turn > 7.9 && turn < 8);
  assert.deepEqual([4, 6, 7.5, turn, (turn + 8) / 2, 8, 9].map((time) => keyedValue(stepped, time, null)), [0, 0, 0, 0, 0.5, 1, 1]);
});

test('smooth keys start and end flat, never leave the values of their neighbours, and meet at each key at one slope', () => {
  const smooth = [[0, 0, 'smooth'], [10, 0.2, 'smooth'], [20, 1, 'smooth'], [30, 0]];
  const at = (time) => keyedValue(smooth, time, null);
  const values = Array.from({ length: 301 }, (_, i) => at(i / 10));
  assert.ok(Math.min(...values) >= 0 && Math.max(...values) <= 1);
  assert.deepEqual([0, 10, 20, 30].map(at), [0, 0.2, 1, 0]);
  assert.ok(at(1) < 0.25 * 0.02 * 2 && at(29) < 0.1 * 0.5);
  const [before, after] = [at(10) - at(9), at(11) - at(10)];
  assert.ok(before > 0.02 && after < 1.7 * before, 'no corner at a key on the way, where lines have one of 4');
  assert.ok(values.slice(1, 201).every((value, i) => value >= values[i]), 'rising keys rise');
  assert.equal(at(5.5), (at(5) + at(6)) / 2); // as USD reads what is written at whole frames
});
