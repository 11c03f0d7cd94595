// The review: notes at frames, each with a pose, a view, words and strokes over the face; sent and opened as a small USD layer
// (notes.js, docs/decisions/142).

import { actions, button, counted, download, hint, make, takeFile, toggle } from './dom.js';
import { minus } from './camera.js';
import { isSeenFrom, joined, lookOf, notesIn, notesOf, pairOf, placeOf, posed, reviewLayer, saidPose, thinned, titleOf } from './notes.js';
import { alike, dot } from './vectors.js';

const LEAST = 0.7; // pixels that a point of a stroke must be off the line between others

export class Review {
  /** `roots` are those of the page's characters; `partsOf` gives [session, notes] of every one. */
  constructor(session, view, timeline, say, roots, partsOf) {
    this.session = session;
    this.view = view;
    this.timeline = timeline;
    this.say = say;
    this.roots = roots;
    this.partsOf = partsOf;
    view.review = this;
    /** @type {any} */
    this.line = null; // the stroke being drawn, as pairs
    /** @type {any[]} */
    this.shown = []; // the notes and the chosen one that the list is made of
    this.list = make('div', { class: 'notes' });
    this.pen = toggle('Draw', 'Draw on the view: two fingers, the wheel and other buttons still move it', () => session.options.draw, () => this.setPen());
    this.back = button('Take back', 'Take away the last stroke of this note', () => this.takeBack());
    this.saving = button('Save review', 'Download the notes as a small USD layer, to send', () => this.save());
    this.node = make('aside', { class: 'review', 'aria-label': 'Review' },
      actions(
        button('Add note', 'A note on the frame, the pose and the view shown now', () => this.write()),
        this.pen, this.back, this.saving, button('Open…', 'Add the notes of a review that somebody sent', () => this.open())),
      this.list);
    for (const event of ['time', 'options', 'editing']) session.on(event, () => this.update());
    this.update();
  }

  get chosen() {
    return this.session.notes.find(({ id }) => id === this.session.note) ?? null;
  }

  /** Whether a note is of the frame shown. */
  isHere({ frame, neutral }) {
    return frame === this.session.frame && neutral === this.session.neutral;
  }

  /** The chosen note, where the view shows what its strokes were drawn over. */
  get seen() {
    const { chosen } = this;
    return chosen && this.isHere(chosen) && isSeenFrom(chosen.look, this.view.camera) ? chosen : null;
  }

  /** Strokes to draw over the view, as points of the screen. */
  lines() {
    const { view, seen, line } = this;
    if (!view.controlsColumn) return [];
    const project = view.camera.projector(view.controlsColumn);
    const strokes = [...(seen?.strokes.map((stroke) => [seen.look, stroke]) ?? []), ...(line ? [[line.look, line.pairs]] : [])];
    return strokes.map(([look, stroke]) => stroke.map((pair) => project(placeOf(look, pair))));
  }

  setPen(on = !this.session.options.draw) {
    this.session.setOption('draw', on);
  }

  // --- making ----------------------------------------------------------------------------------------

  /** A note of what is shown. */
  note(more = {}) {
    const { session } = this;
    const { frame, neutral, values, section } = session;
    const id = crypto.getRandomValues(new Uint32Array(2)).join('-');
    return { id, frame, neutral, text: '', done: false, values: saidPose(session, values), section: section.title, look: this.look(), strokes: [], ...more };
  }

  look() {
    this.view.camera.leaveShot();
    this.view.changed('camera');
    return lookOf(this.view.camera, this.view.controlsColumn);
  }

  add(label, note) {
    this.session.note = note.id;
    this.session.put(label, { notes: [...this.session.notes, note] });
  }

  write() {
    this.add('Add a note', this.note());
    this.list.querySelector('.chosen textarea')?.focus();
  }

  /** @param {string | null} [merge] */
  change(label, note, change, merge = null) {
    this.session.put(label, { notes: this.session.notes.map((each) => (each.id === note.id ? { ...each, ...change } : each)) }, merge);
  }

  remove(note) {
    this.session.put('Take away a note', { notes: this.session.notes.filter(({ id }) => id !== note.id) });
  }

  /** A gesture that draws a stroke: on the chosen note where the view is as it was, else on a new one. */
  drawing(at) {
    const { view, seen } = this;
    const { camera, controlsColumn: column } = view;
    const look = seen?.look ?? this.look();
    const depth = dot(minus(camera.position, look.target), camera.towards);
    const add = (places) => {
      this.line.pairs.push(...places.map(({ x, y }) => pairOf(look, camera.unproject(column, x, y, depth))));
      view.changed('overlay');
    };
    const drop = () => {
      const stroke = thinned(this.line.pairs, LEAST * camera.pixelSize(column.height)).map((pair) => pair.map((value) => Number(value.toPrecision(6))));
      this.line = null;
      if (seen) this.change('Draw', seen, { strokes: [...seen.strokes, stroke] });
      else this.add('Draw', this.note({ look, strokes: [stroke] }));
    };
    return {
      begin: () => {
        this.line = { look, pairs: [] };
        add([at]);
      },
      drag: (_, __, ___, trail) => add(trail),
      drop,
      click: drop,
      undo: () => {
        this.line = null;
        view.changed('overlay');
      },
    };
  }

  takeBack() {
    const { chosen } = this;
    if (chosen?.strokes.length) this.change('Take back a stroke', chosen, { strokes: chosen.strokes.slice(0, -1) });
  }

  // --- showing ---------------------------------------------------------------------------------------

  /** Go to a note: its part, frame, view and pose, which are shown and not taken over. */
  show(note) {
    const { session, view } = this;
    const { sections } = session.character.layout;
    const section = sections.findIndex(({ title }) => title === note.section);
    if (section >= 0 && sections[section] !== session.section) session.show(section);
    this.timeline.stop();
    if (!this.isHere(note)) this.timeline.go(note.frame, note.neutral);
    view.lookAs(note.look);
    session.note = note.id;
    session.look(posed(session, note));
    session.emit('options');
  }

  update() {
    const { session, chosen } = this;
    this.pen.update();
    this.back.disabled = !chosen?.strokes.length;
    this.saving.disabled = !session.notes.length;
    const state = [session.notes, session.note, chosen && this.isHere(chosen), session.looks];
    if (alike(state, this.shown)) return;
    this.shown = state;
    this.view.changed('overlay');
    if (this.typing) return; // into what stands there
    const none = hint('No notes yet. Pose the face or turn the view, then draw on it or add a note. Send the saved file back: `usdrigui view LAYER --review FILE` opens it.');
    this.list.replaceChildren(...(session.notes.length ? session.notes.map((note, index) => this.item(note, index)) : [none]));
  }

  item(note, index) {
    const isChosen = note.id === this.session.note;
    const strokes = note.strokes.length ? `, ${counted(note.strokes.length, 'stroke')}` : '';
    const done = make('input', { type: 'checkbox', checked: note.done, 'aria-label': `Note ${index + 1} is done`, title: 'Done', onchange: () => this.change('Tick a note', note, { done: done.checked }) });
    const text = make('textarea', {
      value: note.text, rows: isChosen ? 3 : 1, placeholder: 'Comment', 'aria-label': `Comment of note ${index + 1}`,
      oninput: () => this.type(note, text.value),
    });
    return make('div', { class: `note${isChosen ? ' chosen' : ''}${note.done ? ' done' : ''}`, 'data-note': note.id },
      make('div', { class: 'note-head' },
        button(`${index + 1} · ${titleOf(note)}${strokes}`, 'Go to its frame, view and pose', () => this.show(note), { class: 'note-go' }),
        done,
        button('×', 'Take this note away', () => this.remove(note), { class: 'note-away', 'aria-label': `Take note ${index + 1} away` })),
      text,
      isChosen ? this.poseActions(note) : null);
  }

  type(note, text) {
    this.typing = true;
    this.change('Write a comment', note, { text }, `comment ${note.id}`);
    this.typing = false;
  }

  /** What the pose of the chosen note and one's own give each other. */
  poseActions(note) {
    const { session } = this;
    if (session.looks) return actions(button('Take this pose', 'Set the controls to the pose of the note', () => session.adopt()));
    if (!this.isHere(note)) return null;
    const give = () => this.change('Give a note the pose', note, { values: saidPose(session, session.values) });
    return actions(button('Set pose', 'Give the note the pose shown now', give));
  }

  // --- files -----------------------------------------------------------------------------------------

  save() {
    download('review.usda', reviewLayer(this.partsOf()));
    for (const [session] of this.partsOf()) session.sent = session.notes;
    this.say(`Saved review.usda, ${counted(this.session.notes.length, 'note')}`);
  }

  open() {
    return takeFile('.usda', this.say, ({ name, text }) => {
      const found = notesOf(notesIn(text), this.session, this.roots);
      if (!found.length) throw new Error('The notes are of another character.');
      this.session.received = [...new Set([...this.session.received, ...found.map(({ id }) => id)])];
      this.session.put(`Open ${name}`, { notes: joined(this.session.notes, found) });
      this.say(`${counted(found.length, 'note')} opened`);
    });
  }
}
