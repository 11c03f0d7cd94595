// All keys, in rows (one for all controls and one for each keyed one) or as curves: picked one by one or by a range, moved,
// copied, pasted, taken away, and told how to go on to the next.

import { Curves, REACH, WIDE, roundFrames } from './curves.js';
import { along, button, capitalised, counted, hint, make, segmented } from './dom.js';
import { WAYS, wayOf } from './interpolation.js';
import { changedKeys, copiedKeys, keysGoing, keysWithin, pastedKeys, removedKeys, retimed } from './keying.js';
import { clamp, known } from './vectors.js';

const MARKS = { linear: 'dope-key', smooth: 'dope-key round', stepped: 'dope-key square' };

export class DopeSheet {
  constructor(session, say, sound) {
    this.session = session;
    this.say = say;
    this.sound = sound;
    this.picked = new Set(); // 'control frame'
    /** @type {{keys: Map<number, any[][]>, picked: Set<string>} | null} */
    this.preview = null; // keys as they are while some are dragged
    this.copied = null;
    /** @type {any[]} */
    this.rows = [];
    /** @type {{controls: number[], frames: number[], corners?: number[][]} | null} */
    this.range = null; // that a drag from an empty place picks, and among curves its corners
    this.shows = 'rows';
    this.body = make('div', { class: 'dope-rows', onpointerdown: (event) => this.press(event) });
    this.curves = new Curves(this);
    this.node = make('section', { class: 'dope', hidden: true, tabIndex: 0, 'aria-label': 'Keys', onkeydown: (event) => this.key(event) }, this.makeHead(), this.body, this.curves.node);
    session.on('time', () => this.update());
    session.on('selection', () => this.update());
    session.on('options', () => this.head.update());
  }

  toggle(open = this.node.hidden) {
    this.node.hidden = !open;
    this.update();
  }

  get pickedKeys() {
    return [...this.picked].map((each) => each.split(' ').map(Number));
  }

  get keys() {
    return this.preview?.keys ?? this.session.keys;
  }

  isPicked(control, frame) {
    return (this.preview ?? this).picked.has(`${control} ${frame}`);
  }

  /** First and last frame of the picked keys, where these are not one. */
  get span() {
    const frames = this.pickedKeys.map(([, frame]) => frame);
    const [first, last] = [Math.min(...frames), Math.max(...frames)];
    return first < last ? [first, last] : null;
  }

  // --- head ------------------------------------------------------------------------------------------

  makeHead() {
    const shows = segmented('Keys as', [['rows', 'Rows', 'All keys in rows'], ['curves', 'Curves', 'The curves of the selected controls, or of all that have keys']],
      () => this.shows, (value) => { this.shows = value; this.update(); });
    const ways = segmented('How keys go to the next', WAYS.map((way) => [way, capitalised(way), `${capitalised(way)}: the picked keys, or all, and the first key of a control from now on`]),
      () => this.way, (way) => this.go(way));
    const count = make('output', { class: 'hint' });
    // After a click the keys of the keyboard are the sheet's again: Space plays.
    const back = (event) => event.detail && this.node.focus({ preventScroll: true });
    this.head = make('div', { class: 'dope-head', onclick: back }, shows, ways,
      button('Copy', 'Copy the picked keys (Ctrl+C)', () => this.copy()),
      button('Paste', 'Paste the copied keys from this frame on (Ctrl+V)', () => this.paste()),
      button('Reverse', 'Turn the picked keys round in time', () => this.reverse()),
      button('Delete', 'Delete the picked keys (Delete)', () => this.remove()),
      count);
    this.head.update = () => {
      shows.update();
      ways.update();
      count.textContent = this.counted();
    };
    this.head.update();
    return this.head;
  }

  /** How the picked keys go on, or without any how a first key will; null where they differ. */
  get way() {
    const ways = new Set(this.pickedKeys.map(([control, frame]) => wayOf(this.session.keys.get(control).find(([when]) => when === frame))));
    if (!ways.size) return this.session.options.interpolation;
    return ways.size > 1 ? null : [...ways][0];
  }

  counted() {
    if (!this.picked.size) return 'Drag a key to move it (Alt scales those picked), an empty place to pick a range';
    const where = this.span ? `frames ${this.span.join(' to ')}` : `frame ${this.pickedKeys[0][1]}`;
    return `${counted(this.picked.size, 'key')} picked, ${where}`;
  }

  // --- rows ------------------------------------------------------------------------------------------

  /** Rows: all keyed controls together, then each of them. */
  update() {
    if (this.node.hidden) return;
    const { session } = this;
    if (this.shown === session.keys && this.heard === session.sound && !this.preview && !this.range && this.moveNow()) return;
    this.shown = session.keys;
    this.heard = session.sound;
    this.scale = session.range;
    const before = this.picked;
    this.picked = new Set(this.everyKey.map((key) => key.join(' ')).filter((each) => before.has(each)));
    this.draw();
  }

  /** What is to be shown of the keys. */
  get asked() {
    return [...this.picked, this.shows, ...this.session.selection].join();
  }

  /** Only time has gone on. */
  moveNow() {
    if (this.look !== this.asked) return false;
    for (const node of this.body.querySelectorAll('.dope-now')) node.style.left = this.along(this.session.frame);
    this.curves.moveNow();
    return true;
  }

  draw() {
    const { session } = this;
    session.emit('picked');
    this.look = this.asked;
    this.body.hidden = this.shows !== 'rows';
    this.curves.node.style.display = this.shows === 'curves' ? '' : 'none';
    this.head.update();
    if (this.shows === 'curves') return this.curves.draw();
    const tracks = [...this.keys];
    this.rows = [{ name: 'All', controls: tracks.map(([control]) => control) }, ...tracks.map(([control]) => ({ name: session.controls[control].label, controls: [control] }))];
    const none = hint('No keys yet: K keys what is selected or changed, Auto-key every drag.');
    return this.body.replaceChildren(this.ruler(), ...this.waveRow(), ...(tracks.length ? this.rows.map((row) => this.row(row)) : [none]));
  }

  /** The numbers of round frames. */
  ruler() {
    const frames = roundFrames(this.scale, this.body.clientWidth / WIDE);
    const marks = frames.map((frame) => make('i', { style: { left: this.along(frame) } }, String(frame)));
    return make('div', { class: 'dope-row', 'aria-hidden': 'true' }, make('span'), make('div', { class: 'dope-ruler' }, ...marks));
  }

  waveRow() {
    if (!this.sound.isReady) return [];
    const wave = make('div', { class: 'dope-wave' }, this.sound.wave(this.scale[0], this.scale[1], 36));
    return [make('div', { class: 'dope-row heard' }, make('span', {}, this.sound.name), wave)];
  }

  row({ name, controls }) {
    const frames = new Map();
    for (const control of controls) for (const key of this.keys.get(control)) known(frames, key[0], () => []).push([control, key]);
    const marks = [...frames].map(([frame, keys]) => this.mark(name, frame, keys));
    const now = make('i', { class: 'dope-now', style: { left: this.along(this.session.frame) } });
    return make('div', { class: 'dope-row' }, make('span', { title: name }, name), make('div', { class: 'dope-line' }, ...this.band(controls), ...marks, now));
  }

  /** The range that is being picked. */
  band(controls) {
    const { range } = this;
    if (!range || !controls.some((control) => range.controls.includes(control))) return [];
    const [from, to] = range.frames.map((frame) => this.along(frame));
    return [make('i', { class: 'dope-band', style: { left: from, width: `calc(${to} - ${from})` } })];
  }

  along(frame) {
    return along(frame, this.scale);
  }

  /** A mark stands for one key, or for all at a frame. */
  mark(name, frame, keys) {
    const on = keys.every(([control]) => this.isPicked(control, frame));
    const way = wayOf(keys[0][1]);
    const words = `${name}, frame ${frame}${way === 'linear' ? '' : `, ${way}`}`;
    return make('button', {
      type: 'button', class: MARKS[way], tabIndex: -1, style: { left: this.along(frame) }, title: words, 'aria-label': words, 'aria-pressed': String(on),
    });
  }

  // --- hand ------------------------------------------------------------------------------------------

  /** The row and the frame, not a whole one, at a place of the page. */
  at({ clientX, clientY }) {
    const nodes = [...this.body.querySelectorAll('.dope-line')];
    const boxes = nodes.map((node) => node.getBoundingClientRect());
    const below = boxes.findIndex(({ bottom }) => clientY <= bottom);
    const row = below < 0 ? boxes.length - 1 : below;
    const [first, last] = this.scale;
    const perPixel = (last - first) / boxes[row].width;
    return { row, frame: first + (clientX - boxes[row].left) * perPixel, perPixel };
  }

  /** On a key: pick it (shift: with those picked before) and move; elsewhere: pick a range. */
  press(event) {
    if (event.button || !this.session.keys.size) return;
    const at = this.at(event);
    const { controls } = this.rows[at.row];
    const reach = at.perPixel * (event.pointerType === 'touch' ? REACH.touch : REACH.mouse);
    const near = keysWithin(this.session.keys, controls, [at.frame - reach, at.frame + reach]);
    const frame = near.reduce((best, [, each]) => (Math.abs(each - at.frame) < Math.abs(best - at.frame) ? each : best), Infinity);
    const hit = near.filter(([, each]) => each === frame);
    if (hit.length) this.moving(event, at, hit);
    else this.ranging(event, at);
    this.node.focus({ preventScroll: true });
    event.preventDefault();
  }

  /** Pick keys; those picked already stay so when one of them is pressed. */
  pick(keys, adds) {
    const names = keys.map((key) => key.join(' '));
    if (!adds && !names.every((name) => this.picked.has(name))) this.picked.clear();
    names.forEach((name) => this.picked.add(name));
  }

  moving(event, start, hit) {
    this.pick(hit, event.shiftKey);
    this.draw();
    this.dragging(event, (moved) => {
      const by = Math.round((moved.clientX - event.clientX) * start.perPixel);
      const to = retimed(by, hit[0][1], moved.altKey ? this.span : null);
      return by ? ([frame, value]) => [to(frame), value] : null;
    });
  }

  /** Picked keys as a drag has them; `change` says how, null where nothing changes. */
  dragging(event, change) {
    const copies = (moved) => moved.ctrlKey || moved.metaKey;
    this.follow(event, (moved) => {
      const how = change(moved);
      this.preview = how && this.changed(how, copies(moved));
      this.draw();
    }, (released) => {
      const how = change(released);
      if (how) this.change(copies(released) ? 'Copy' : released.altKey ? 'Scale' : 'Move', how, copies(released));
    });
  }

  ranging(event, start) {
    this.selecting(event, (moved) => {
      const end = this.at(moved);
      const controls = this.rows.slice(Math.min(start.row, end.row), Math.max(start.row, end.row) + 1).flatMap((row) => row.controls);
      /** @type {[number, number]} */
      const frames = [Math.min(start.frame, end.frame), Math.max(start.frame, end.frame)];
      this.range = { controls, frames };
      return keysWithin(this.session.keys, controls, frames);
    });
  }

  /** Pick the keys that a drag has `within` it, beside those picked before with Shift. */
  selecting(event, within) {
    const before = event.shiftKey ? [...this.picked] : [];
    const take = (keys) => {
      this.picked = new Set([...before, ...keys.map((key) => key.join(' '))]);
      this.draw();
    };
    this.follow(event, (moved) => take(within(moved)), () => {});
    take([]);
  }

  /** A drag: `move` hears of each step, `drop` of the end; nothing happens when it is broken off. */
  follow(event, move, drop) {
    const ends = new AbortController();
    const own = (act) => (each) => each.pointerId === event.pointerId && act(each);
    const end = (act) => own((each) => {
      ends.abort();
      Object.assign(this, { preview: null, range: null });
      act(each);
      this.draw();
    });
    const { signal } = ends;
    window.addEventListener('pointermove', own(move), { signal });
    window.addEventListener('pointerup', end(drop), { signal });
    window.addEventListener('pointercancel', end(() => {}), { signal });
  }

  key(event) {
    const steps = { ArrowLeft: -1, ArrowRight: 1 };
    const held = event.ctrlKey || event.metaKey;
    if (event.key === 'Delete' || event.key === 'Backspace') this.remove();
    else if (steps[event.key] && this.picked.size) this.change(held ? 'Copy' : 'Move', ([frame, value]) => [frame + steps[event.key] * (event.shiftKey ? 10 : 1), value], held);
    else if (held && event.key === 'a') this.pick(this.everyKey, true);
    else if (held && event.key === 'c' && this.picked.size) this.copy();
    else if (held && event.key === 'v' && this.copied) this.paste();
    else if (event.key === 'Escape' && this.picked.size) this.picked.clear();
    else return;
    this.draw();
    event.preventDefault();
    event.stopPropagation();
  }

  // --- what is done to keys --------------------------------------------------------------------------

  get everyKey() {
    return keysWithin(this.session.keys, [...this.session.keys.keys()]);
  }

  /** As `changedKeys`, of the picked keys, within the ranges of their controls. */
  changed(change, copies) {
    const { keys, controls } = this.session;
    return changedKeys(keys, this.pickedKeys, (key, control) => {
      const [frame, value] = change(key, control);
      return [frame, clamp(value, controls[control].minimum, controls[control].maximum)];
    }, copies);
  }

  /** Picked keys as `change` has them; they stay picked. */
  change(label, change, copies = false) {
    const words = `${label} ${counted(this.picked.size, 'key')}`;
    const { keys, picked } = this.changed(change, copies);
    this.picked = picked;
    this.session.rekey(words, keys);
  }

  /** Picked keys in the opposite order, between the first and the last of them. */
  reverse() {
    const { span } = this;
    if (span) this.change('Reverse', ([frame, value]) => [span[0] + span[1] - frame, value]);
    else this.say('No range of keys is picked');
  }

  remove() {
    const picked = this.pickedKeys;
    if (picked.length) this.session.rekey(`Delete ${counted(picked.length, 'key')}`, removedKeys(this.session.keys, picked));
    else this.say('No key is picked');
  }

  copy() {
    if (this.picked.size) this.copied = copiedKeys(this.session.keys, this.pickedKeys);
    this.say(this.picked.size ? `${counted(this.copied.length, 'key')} copied` : 'No key is picked');
  }

  paste() {
    const { session, copied } = this;
    if (!copied) return this.say('No key is copied');
    this.picked = new Set(copied.map(([control, [frame]]) => `${control} ${session.frame + frame}`));
    return session.rekey(`Paste ${counted(copied.length, 'key')}`, pastedKeys(session.keys, copied, session.frame));
  }

  /** Picked keys, or all, go to the next ones in this way, and so does the first key of a control from now on. */
  go(way) {
    const { session } = this;
    const picked = this.pickedKeys.length ? this.pickedKeys : this.everyKey;
    if (!this.picked.size) session.setOption('interpolation', way);
    if (picked.length) session.rekey(`${capitalised(way)}: ${counted(picked.length, 'key')}`, keysGoing(way, session.keys, picked));
    this.draw();
  }
}
