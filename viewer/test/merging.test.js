import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NOTHING, differing, merged } from '../src/merging.js';

const work = (keys, standing = {}) => ({ keys, standing });
const BASE = work({ jaw: [[1, 0], [5, 1]], brow: [[3, 0.5]] }, { lid: 0.2 });

test('what one side changed is taken from it, whichever merges', () => {
  const mine = work({ jaw: [[1, 0], [5, 0.7], [9, 0]], brow: [[3, 0.5]] }, { lid: 0.2 });
  const theirs = work({ jaw: [[2, 0.1], [5, 1]], nose: [[1, 1, 'stepped']] }, { lid: 0.9 });
  const both = work({ jaw: [[2, 0.1], [5, 0.7], [9, 0]], nose: [[1, 1, 'stepped']] }, { lid: 0.9 });
  assert.deepEqual(merged(BASE, mine, theirs), { work: both, conflicts: [], taken: ['brow', 'jaw', 'nose', 'lid'] });
  assert.deepEqual(merged(BASE, theirs, mine).work, both);
  assert.deepEqual(merged(NOTHING, BASE, NOTHING).work, work({ brow: BASE.keys.brow, jaw: BASE.keys.jaw }, BASE.standing));
});

test('where both changed one thing mine stands and is told, and a key stands over its removal', () => {
  const mine = work({ jaw: [[1, 0.1]] }, { lid: 0.4 });
  const theirs = work({ jaw: [[1, 0.2], [5, 0.6]], brow: [[3, 0.6]] }, {});
  const { work: made, conflicts } = merged(BASE, mine, theirs);
  assert.deepEqual(made, work({ brow: [[3, 0.6]], jaw: [[1, 0.1], [5, 0.6]] }, { lid: 0.4 }));
  assert.deepEqual(conflicts, [['brow', 3], ['jaw', 1], ['jaw', 5], ['lid', null]]);
  assert.deepEqual(differing(made, merged(BASE, made, theirs).work), []);
});

test('first and last frame set by hand are merged as one thing', () => {
  const [mine, theirs] = [{ ...BASE, span: [1, 20] }, { ...BASE, span: [5, 30] }];
  assert.deepEqual(merged(BASE, BASE, theirs), { work: theirs, conflicts: [], taken: ['frames'] });
  assert.deepEqual(merged(BASE, mine, theirs).work, mine);
  assert.deepEqual(merged(BASE, mine, theirs).conflicts, [['frames', null]]);
  assert.deepEqual(merged(mine, mine, BASE).work, BASE);
});
