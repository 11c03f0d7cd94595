// Pulls leave whole-face controls alone: which controls those are, and that they take part only when asked for.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Influence } from '../src/heat.js';
import { Session } from '../src/session.js';

const POINTS = 10;

/** Influence of controls that move `moved` of ten points, those of `joints` by joints. */
function influence(moved, joints) {
  const controls = moved.map((_, index) => ({ drive: { joints: joints.includes(index) ? [index] : [] } }));
  const found = new Influence({ controls }, null, null);
  moved.forEach((count, index) => found.known.set(index, Uint8Array.from({ length: POINTS }, (_, at) => (at < count ? 255 : 0))));
  return found;
}

test('joints that move more than half of the points move the whole face; shapes never do', () => {
  const found = influence([10, 6, 5, 10], [0, 1, 2]);
  assert.deepEqual([0, 1, 2, 3].map((index) => found.isWide(index)), [true, true, false, false]);
});

test('a pull leaves joints of the whole head, and what the layout calls global or composite, alone', () => {
  const moved = influence([10, 3, 10, 3, 3], [0, 1]);
  const session = Object.assign(Object.create(Session.prototype), {
    controls: moved.character.controls,
    twins: [-1, -1, -1, -1, -1],
    opposites: [[], [], [], [], []],
    options: { symmetric: false },
    locks: new Set(),
    influence: moved,
    elements: { byControl: new Map([[3, { category: 'composite' }], [4, { category: 'hidden' }]]) },
  });
  assert.deepEqual(session.groups(false), [[1], [2], [4]]);
  assert.deepEqual(session.groups(true), [[0], [1], [2], [3], [4]]);
});

test('an end stays where it is while the other end, away from its default, may not change', () => {
  const session = (values, locks) => Object.assign(Object.create(Session.prototype), {
    controls: values.map(() => ({ default: 0 })),
    values,
    twins: [1, 0, 3, 2],
    opposites: [[2], [3], [0], [1]],
    options: { symmetric: true },
    locks: new Set(locks),
  });
  assert.deepEqual(session([0, 0, 0, 0], [3]).groups(true), [[0, 1]]);
  assert.deepEqual(session([0, 0, 0.5, 0.5], [3]).groups(true), []);
  assert.deepEqual(session([0, 0, 0.5, 0.5], []).groups(true), [[0, 1], [2, 3]]);
});
