// The work on one character: its keys, kept poses, notes and sound over time, and every change as a step that can be undone.
// Everything on the page reads the session and changes it through these methods; listeners hear of it.

import { Animation } from './animation.js';
import { History } from './history.js';
import { flipped, mirroredFrom, removedKeys, tweened, withKeys } from './keying.js';
import { Posing } from './posing.js';

export class Session extends Posing {
  constructor(character) {
    super(character);
    this.animation = new Animation(character, this.rest);
    this.history = new History();
    this.frame = this.animation.first;
    this.neutral = true; // the layout's base pose is under the values, not the frame's
    this.keys = new Map(); // control index -> [[frame, value, way]], ascending
    this.constants = new Map(); // control index -> value of what neither keys nor the clip animate
    this.shelf = []; // kept poses: {name, values: control index -> value, picture}
    this.notes = []; // of a review (notes.js)
    this.arrived = this.notes; // those of them that came with the page
    this.received = []; // ids of all that came from others
    this.sent = this.notes; // those of the last saved review
    this.note = null; // id of the note whose strokes are shown
    this.sound = null; // {name, start: the frame at which it begins, seconds}
    this.given = Float64Array.from(this.rest); // the values before any change at this frame
    this.moved = new Map(); // element index -> where it was put by hand
    this.present = null; // the values, while others are shown
    this.looks = false; // at a note's pose, until an edit goes on from it or time moves
    this.show(0);
    this.reshape();
  }

  /** Forget who listens, and what the pointer does: another character comes to be shown. */
  leave() {
    this.compare(false);
    this.listeners.clear();
    Object.assign(this, { hover: null, dragging: null, affected: new Map() });
  }

  /** Do `change` as one undoable step, if it changes any value. @param {string | null} [merge] */
  edit(label, change, merge = null) {
    const before = this.beginEdit();
    change();
    this.endEdit(label, before, merge);
  }

  /** The values before an edit that begins now; it goes on from the pose shown, a note's too. */
  beginEdit() {
    const own = this.looks ? this.present : null;
    if (own) Object.assign(this, { present: null, looks: false });
    this.compare(false);
    this.emit('editing');
    return own ?? Float64Array.from(this.values);
  }

  /** @param {string | null} [merge] */
  endEdit(label, values, merge = null) {
    const changed = [...values.keys()].filter((i) => this.values[i] !== values[i]);
    if (!changed.length) return;
    const before = { ...this.snapshot(), values };
    if (this.options.autoKey) this.setKeys(changed);
    this.step(label, before, merge);
    this.emit('edited');
  }

  /** Every control to its default. */
  zero(indices = this.controls.keys()) {
    this.settleAt('Zero', [...indices], (index) => this.controls[index].default);
  }

  /** Every control to the pose in which the layout was made. */
  reset(indices = this.controls.keys()) {
    this.settleAt('Reset', [...indices], (index) => this.rest[index]);
  }

  /** Controls to values; all of them together leave the clip's frame too, whose pose may hold what no control says. */
  settleAt(label, indices, value) {
    const before = { ...this.snapshot(), values: this.beginEdit() };
    if (indices.length === this.controls.length) {
      this.neutral = true;
      this.showBase();
    }
    this.set(indices.map((index) => [index, value(index)]));
    const changed = this.values.some((each, i) => each !== before.values[i]);
    if (!changed && this.neutral === before.neutral) return;
    if (this.options.autoKey && changed) this.setKeys(indices.filter((index) => !this.locks.has(index)));
    this.step(label, before);
    this.emit('edited');
  }

  undo() {
    return this.history.undo();
  }

  redo() {
    return this.history.redo();
  }

  /** All that undo gives back. */
  snapshot() {
    if (!this.looks) this.compare(false);
    const { frame, neutral, keys, constants, shelf, notes, sound, span } = this;
    return { frame, neutral, keys, constants, shelf, notes, sound, span, values: Float64Array.from(this.own), given: this.given };
  }

  restore({ values, ...state }) {
    this.emit('editing');
    Object.assign(this, state, { present: null, looks: false });
    this.values.set(values);
    this.showBase();
    this.reshape();
    this.emit('time');
  }

  /** Show the layout's base pose, without any keys; not an edit. */
  clear() {
    const rest = Float64Array.from(this.rest);
    this.restore({ ...this.snapshot(), neutral: true, keys: new Map(), constants: new Map(), values: rest, given: rest });
  }

  /** Record what has happened since `before` as one undoable step. @param {string | null} [merge] */
  step(label, before, merge = null) {
    const after = this.snapshot();
    this.history.push(label, () => this.restore(before), () => this.restore(after), merge, [before, after]);
    this.emit('changed');
    this.emit('time');
  }

  // --- time ------------------------------------------------------------------------------------------

  /** Controls whose values are not what the keys and the clip give here. */
  changed() {
    const { own, given } = this;
    return [...own.keys()].filter((index) => own[index] !== given[index]);
  }

  /** Changed controls that are lost on leaving the frame, as keys or the clip say what they are at every other. */
  unkeyed() {
    return this.changed().filter((index) => this.animation.isAnimated(index, this.keys));
  }

  /**
   * Show a frame, or the neutral pose.  What is changed here and in time neither by keys nor by the clip stays as it is; other changes
   * without keys end with the frame, as one undoable step.  Returns their control indices.
   */
  go(frame, neutral = false) {
    this.compare(false);
    const lost = this.unkeyed();
    const before = lost.length ? this.snapshot() : null;
    this.constants = this.allConstants();
    Object.assign(this, { frame, neutral });
    this.given = neutral ? Float64Array.from(this.rest) : this.animation.at(frame, this).values;
    this.values.set(this.given);
    this.showBase();
    this.reshape();
    if (before) this.step(`Leave frame ${before.frame} with changes`, before);
    else this.emit('time');
    return lost;
  }

  /** The values that stand at all frames, those changed at this one among them; of the present state or another. */
  allConstants({ keys, constants, values, given } = { ...this, values: this.own }) {
    const stands = ([index, value]) => value !== given[index] && !this.animation.isAnimated(index, keys);
    return new Map([...constants, ...[...values.entries()].filter(stands)]);
  }

  /** Key controls at this frame, at their present values. */
  key(controls) {
    this.record(`Key frame ${this.frame}`, () => this.setKeys(controls));
  }

  setKeys(controls) {
    const way = (index) => (this.keys.has(index) ? undefined : this.options.interpolation);
    this.takeKeys(withKeys(this.keys, controls.map((index) => [index, [this.frame, this.values[index], way(index)]])), this.constants);
  }

  /** Take away the keys of controls at this frame; false where there are none. */
  unkey(controls) {
    const keys = removedKeys(this.keys, controls.map((index) => [index, this.frame]));
    const gone = controls.filter((index) => keys.get(index)?.length !== this.keys.get(index)?.length);
    if (!gone.length) return false;
    this.record(`Delete keys at frame ${this.frame}`, () => {
      gone.forEach((index) => (this.values[index] = this.given[index]));
      this.takeKeys(keys, this.constants);
    });
    return true;
  }

  /** Other keys at this frame, as one undoable step. */
  rekey(label, keys) {
    this.record(label, () => this.takeKeys(keys, this.constants));
  }

  /** Another shelf, other notes, another sound or span, as one undoable step. @param {string | null} [merge] */
  put(label, what, merge = null) {
    this.record(label, () => Object.assign(this, what), merge);
  }

  /** Do a change of anything but values as one undoable step. @param {string | null} [merge] */
  record(label, change, merge = null) {
    const before = this.snapshot();
    change();
    this.step(label, before, merge);
  }

  /** First and last frame of the clip, the keys and the sound. */
  get range() {
    const [first, last] = this.animation.range(this.keys);
    const { start, seconds } = this.sound ?? { start: first, seconds: 0 };
    return [Math.min(first, start), Math.max(last, Math.ceil(start + seconds * this.animation.rate))];
  }

  /** First and last frame as set by hand, null where none were. */
  get span() {
    return this.animation.span;
  }

  set span(span) {
    this.animation.span = span;
  }

  /** Another first and last frame, as one undoable step; false where they are none or a clip says them. */
  respan(first, last) {
    if (!this.animation.isFree || !(Number.isInteger(first) && Number.isInteger(last) && first < last)) return false;
    this.put('Set the frames', { span: [first, last] });
    return true;
  }

  // --- poses -----------------------------------------------------------------------------------------

  /** Values of the chosen controls; `paste` gives them back. */
  copy() {
    this.copied = new Map(this.chosenControls.map((index) => [index, this.values[index]]));
    return this.copied;
  }

  paste() {
    if (this.copied) this.asWritten('Paste the pose', this.copied);
  }

  /** The pose seen in a mirror. */
  flip() {
    this.asWritten('Flip the pose', flipped({ ...this.sides, crosses: (index) => this.crosses(index) }));
  }

  /** The pose of one of the character's sides on the other, too. */
  mirror(side) {
    this.asWritten(`Mirror the ${side}`, mirroredFrom(side, this.sides));
  }

  /** The chosen controls between their keys before and after this frame; false where none has both. */
  tween(share) {
    const found = tweened(this.keys, this.chosenControls, this.frame, share);
    if (found.length) this.edit('Tween', () => this.set(found), 'tween');
    return found.length > 0;
  }

  get sides() {
    const values = Float64Array.from(this.values);
    const { controls, rest, twins, opposites } = this;
    const sideOf = (index) => this.elements.byControl.get(index)?.side;
    const mirrored = (from, to) => this.mirrored(from, to, values);
    return { values, controls, rest, twins, opposites, sideOf, mirrored };
  }

  /** Set values as they are, whatever symmetry says. */
  asWritten(label, values) {
    const { symmetric } = this.options;
    this.options.symmetric = false;
    this.edit(label, () => this.set(values));
    this.options.symmetric = symmetric;
  }

  // --- keys from elsewhere ---------------------------------------------------------------------------

  /** Other keys and constant values, as one undoable step; shows the first frame keyed, or the present one. */
  load(label, keys, constants) {
    const frames = [...keys.values()].map(([[frame]]) => frame);
    this.record(label, () => {
      if (frames.length) this.frame = Math.min(...frames);
      this.given = Float64Array.from(this.values); // what was changed at the frame before gives way
      this.takeKeys(keys, constants);
    });
  }

  /** Show this frame with other keys and constant values; changes that are not keyed stay shown. */
  takeKeys(keys, constants) {
    this.compare(false);
    const kept = this.changed().map((index) => [index, this.values[index]]);
    Object.assign(this, { keys, constants, neutral: false });
    this.given = this.animation.at(this.frame, this).values;
    this.values.set(this.given);
    for (const [index, value] of kept) this.values[index] = value;
    this.showBase();
    this.reshape();
  }

  /**
   * Let `change` make other keys and constant values ({keys, constants}) of the present ones, and of all that undo and redo
   * give back: what others have changed is no step of one's own.
   */
  rebase(change) {
    this.compare(false);
    for (const state of this.history.states) Object.assign(state, this.rebased(state, change));
    const { values, ...state } = this.rebased(this.snapshot(), change);
    Object.assign(this, state);
    this.values.set(values);
    this.reshape();
    this.emit('time');
  }

  rebased(state, change) {
    const own = { keys: state.keys, constants: this.allConstants(state), span: state.span };
    const next = change(own);
    const [before, after] = [own, next].map((work) => this.animation.at(state.frame, work).values);
    const isLoose = (index) => state.values[index] !== state.given[index] && this.animation.isAnimated(index, state.keys);
    const other = (index) => before[index] !== after[index];
    const given = state.given.map((value, index) => (other(index) ? after[index] : value));
    const values = state.values.map((value, index) => (other(index) && !isLoose(index) ? after[index] : value));
    return { ...state, ...next, given, values };
  }

  /** Show the frame as it was before any change here while `on`, and the present values again. */
  compare(on) {
    if (on === Boolean(this.present)) return;
    if (on) this.emit('editing');
    const shown = /** @type {Float64Array} */ (on ? this.given : this.present);
    this.present = on ? Float64Array.from(this.values) : null;
    this.looks = false;
    this.values.set(shown);
    this.reshape();
  }

  /** The values that are the work, whatever is shown for now. */
  get own() {
    return this.present ?? this.values;
  }

  /** Make the note's pose that is shown one's own. */
  adopt() {
    this.edit('Take the pose of a note', () => {});
  }

  /** Show a pose at this frame that is no work of one's own: time takes it away, an edit goes on from it. */
  look(values) {
    this.compare(false);
    if (values.every((value, index) => value === this.values[index])) return;
    this.present = Float64Array.from(this.values);
    this.looks = true;
    this.values.set(values);
    this.reshape();
  }

  /** Follow elements that stand elsewhere now. */
  relayout() {
    this.showBase(); // finding where elements stand has put the base pose there
    this.reshape();
    this.emit('layout');
    this.emit('changed');
  }

  /** What `use` makes of the values at another frame, over its base pose; what is shown stays as it is. */
  atFrame(frame, use) {
    const { values, weights, locals } = this.animation.at(frame, { keys: this.keys, constants: this.allConstants() });
    this.deformer.setBase(weights, locals);
    const made = use(values);
    this.showBase();
    this.deformer.drive(this.values);
    return made;
  }

  /** Put the frame's pose, or the layout's base pose, under the values. */
  showBase() {
    const { weights, locals } = this.neutral ? { weights: null, locals: null } : this.animation.clipAt(this.frame);
    this.deformer.setBase(weights, locals);
  }
}
