import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Dock, inRows } from '../src/dock.js';

test('the board has its headings in the order of the layout, words of other tools last and each by itself', () => {
  const rows = [['theirs', 10], ['composite', 3], ['alien', 10], ['theirs', 10], ['global', 0]];
  const elements = rows.map(([category, rank], index) => ({ category, rank, index }));
  assert.deepEqual(elements.sort(inRows).map(({ index }) => index), [4, 1, 2, 0, 3]);
});

test('a heading stands in the column of its first row', () => {
  const member = { control: 0, values: [0, 1], track: [[0, 0, 0], [1, 0, 0]] };
  const list = Array.from({ length: 24 }, (_, index) => ({ index, category: `c${Math.floor(index / 4)}`, heading: '', rank: Math.floor(index / 4), onBoard: true, members: [member], axes: [[0]], label: '' }));
  const session = { elements: { list }, isShown: () => true, rest: [0], character: { up: [0, 1, 0] }, section: { view: [0, 0, 1] } };
  for (let height = 200; height < 600; height += 5) {
    const dock = new Dock(session);
    dock.arrange({ left: 0, top: 0, width: 4 * 184, height });
    const cells = [...dock.cells.values()];
    for (const heading of dock.headings) assert.ok(cells.some(({ left, top }) => left === heading.left && top === heading.top + 24), `at ${height}`);
  }
});
