import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inRows } from '../src/dock.js';

test('the board has its headings in the order of the layout, words of other tools last and each by itself', () => {
  const rows = [['theirs', 10], ['composite', 3], ['alien', 10], ['theirs', 10], ['global', 0]];
  const elements = rows.map(([category, rank], index) => ({ category, rank, index }));
  assert.deepEqual(elements.sort(inRows).map(({ index }) => index), [4, 1, 2, 0, 3]);
});
