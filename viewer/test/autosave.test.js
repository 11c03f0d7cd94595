import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Autosave } from '../src/autosave.js';

/** What autosave and work.js read of a session without keys or poses. */
function session() {
  const listeners = new Map();
  const none = { keys: new Map(), constants: new Map(), moved: new Map(), locks: new Set(), shelf: [], received: [], sound: null, span: null };
  const notes = [];
  return {
    ...none, notes, arrived: notes, sent: notes, frame: 1, neutral: true, controls: [{ name: 'jaw' }], own: [0], rest: [0], given: [0],
    character: { identity: 'face' }, elements: { list: [] },
    on: (event, listener) => listeners.set(event, listener),
    emit: (event) => listeners.get(event)?.(),
  };
}

const note = { id: 'a', text: '', done: false, frame: 1, neutral: true, strokes: [], values: new Map() };

test('a saved review saves its notes and nothing else, a saved animation all but notes', () => {
  const one = session();
  const autosave = new Autosave(one, null);
  autosave.listen(() => undefined);
  assert.equal(autosave.isUnsaved, false);
  Object.assign(one, { keys: new Map([[0, [[1, 0.5]]]]), notes: [note] });
  one.sent = one.notes;
  assert.equal(autosave.isUnsaved, true);
  one.emit('saved');
  assert.equal(autosave.isUnsaved, false);
  one.notes = [note, { ...note, id: 'b' }];
  assert.equal(autosave.isUnsaved, true);
  one.emit('saved');
  assert.equal(autosave.isUnsaved, true);
  one.sent = one.notes;
  assert.equal(autosave.isUnsaved, false);
});
