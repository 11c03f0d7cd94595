import assert from 'node:assert/strict';
import { test } from 'node:test';
import { keysAround } from '../src/onion.js';
import { entryAt, loudness } from '../src/sound.js';

test('a sound is waited for before its first frame, and entered in its middle after', () => {
  assert.deepEqual(entryAt(1, 13, 24), { delay: 0.5, offset: 0 });
  assert.deepEqual(entryAt(13, 13, 24), { delay: 0, offset: 0 });
  assert.deepEqual(entryAt(37, 13, 24), { delay: 0, offset: 1 });
});

test('a wave is the loudest sample of each stretch, and nothing outside the sound', () => {
  const samples = Float32Array.from([0, 0.5, -0.75, 0.25, 0, -0.125, 0, 0]);
  assert.deepEqual(loudness(samples, 4, [-1, 0, 1, 2, 3]), [0, 0.75, 0.125, 0]);
});

test('onion skin shows the keys around a frame, of the selection where that is keyed', () => {
  const keys = new Map([[0, [[1, 0], [9, 1]]], [1, [[4, 0], [6, 1]]]]);
  const at = (frame, chosen) => keysAround({ keys, frame, selection: new Set(chosen), chosenControls: chosen });
  assert.deepEqual(at(5, []), { before: 4, after: 6 });
  assert.deepEqual(at(5, [0]), { before: 1, after: 9 });
  assert.deepEqual(at(5, [7]), { before: 4, after: 6 });
  assert.deepEqual(at(9, []), { before: 6, after: null });
});
