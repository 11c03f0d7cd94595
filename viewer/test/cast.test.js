// Two characters of two points each, whose brow rises by a key: one that is posed, and one that walks beside it, turned round.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Cast } from '../src/cast.js';
import { withKeys } from '../src/keying.js';
import { Session } from '../src/session.js';

const identity = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
const walking = (x) => [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, x, 0, 0, 1];

function posing(root, toWorld) {
  const drive = { values: [0, 1], channels: [0], weights: [[0], [1]], joints: [], rotations: [[], []], translations: [[], []], scales: [[], []] };
  const shape = { channel: 0, weights: [1], step: 1, points: [0], offsets: [0, 100, 0] };
  const mesh = { path: `${root}/M`, start: 0, count: 2, points: Float32Array.from([0, 0, 0, 9, 0, 0]), triangles: [0, 1, 1], visible: true, toRoot: identity, shapes: [shape] };
  return new Session({
    root, toWorld, timeCodes: [1, 3, 24], clip: null, up: [0, 1, 0], meshes: [mesh], joints: [], pointCount: 2, bind: [], base: new Float64Array(0), skeletons: [], baseWeights: [0],
    channels: [{ token: 'brow', index: 0, animation: '' }],
    controls: [{ name: 'brow', label: 'brow', kind: 'blendShape', minimum: 0, default: 0, maximum: 1, attribute: null, drive, reading: null }],
    layout: { sections: [{ elements: [], handleWidth: 1, view: [0, 0, 1] }], elements: [], baseValues: [0], colours: {}, planeNormal: [1, 0, 0] },
  });
}

/** [cast, the session that is posed, the other one, its two points as the cast has them]. */
function onStage(place = walking(50)) {
  const [session, other] = [posing('/A', [place]), posing('/B', [1, 2, 3].map((frame) => identity.flat().map((value, i) => (i === 12 ? 10 * frame : value))))];
  const cast = new Cast(session, [other]);
  return [cast, session, other, () => Array.from(cast.points.subarray(6))];
}

test('another character stands where its stage has it at the frame shown, in the space of the one that is posed', () => {
  const [cast, session, , there] = onStage();
  assert.deepEqual(cast.character.meshes.map(({ start }) => start), [0, 2]);
  session.go(1);
  cast.follow();
  assert.deepEqual(there(), [40, 0, 0, 31, 0, 0]);
  session.go(3);
  cast.follow();
  assert.deepEqual(there(), [20, 0, 0, 11, 0, 0]);
  session.go(9); // as long as the shot is
  cast.follow();
  assert.deepEqual(there(), [20, 0, 0, 11, 0, 0]);
});

test('it moves by its own keys and what stands at all frames; the one that is posed moves in the same points', () => {
  const [cast, session, other, there] = onStage();
  other.rekey('Key', withKeys(new Map(), [[0, [1, 0]], [0, [3, 1]]]));
  session.go(2);
  cast.follow();
  assert.deepEqual(there(), [30, 50, 0, 21, 0, 0]);
  session.set([[0, 1]]);
  assert.deepEqual(Array.from(cast.points.subarray(0, 6)), [0, 100, 0, 9, 0, 0]);
  assert.deepEqual(there(), [30, 50, 0, 21, 0, 0]);
  other.rekey('Take away', new Map());
  other.set([[0, 0.25]]);
  session.go(3);
  cast.follow();
  assert.deepEqual(there(), [20, 25, 0, 11, 0, 0]);
});

test('one that was seen beside another has its own pose again when it is posed', () => {
  const [, session, other] = onStage();
  other.set([[0, 0.5]]);
  session.go(2);
  const back = new Cast(other, [session]);
  assert.deepEqual(Array.from(back.points.subarray(0, 6)), [0, 50, 0, 9, 0, 0]);
});

test('beside one that its stage shrinks to nothing the other stands in the world', () => {
  const [, , , there] = onStage(new Array(16).fill(0));
  assert.deepEqual(there(), [10, 0, 0, 19, 0, 0]);
});
