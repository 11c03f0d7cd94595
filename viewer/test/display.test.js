import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Display } from '../src/display.js';

/** Two sections of one element each, and an element of neither; nothing of the character itself. */
function display() {
  const list = ['smile', 'fist', 'loose'].map((name, index) => ({ name, index, inner: [], members: [] }));
  const sections = [['face', 'smile', 0.1], ['hand', 'fist', 0.2]].map(([title, name, handleWidth]) => ({ title, handleWidth, elements: [name] }));
  const parts = { character: { layout: { sections } }, elements: { list }, levels: { shows: () => true } };
  const made = Object.assign(Object.create(Display.prototype), parts, { selection: new Set(), hidden: new Set(), listeners: new Map() });
  made.show(0);
  return made;
}

test('an element that is chosen brings its section, and one of no section none', () => {
  const shown = display();
  const [, fist, loose] = shown.elements.list;
  shown.reveal(fist);
  assert.equal(shown.section.title, 'hand');
  assert.equal(shown.elements.width, 0.2);
  assert.deepEqual(shown.selectedElements, [fist]);
  shown.reveal(loose);
  assert.equal(shown.section.title, 'hand');
  assert.deepEqual(shown.elements.list.filter((each) => shown.isShown(each)), [fist]);
});
