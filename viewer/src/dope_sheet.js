// Keys as marks in rows, one for all controls and one for each keyed one: picked, moved, copied and taken away.

import { make } from './dom.js';
import { movedKeys, removedKeys } from './keying.js';

const ROW = 18; // pixels

export class DopeSheet {
  constructor(session, say) {
    this.session = session;
    this.say = say;
    this.picked = new Set(); // 'control frame'
    this.body = make('div', { class: 'dope-rows' });
    this.node = make('section', { class: 'dope', hidden: true, tabIndex: 0, 'aria-label': 'Keys', onkeydown: (event) => this.key(event) }, this.body);
    session.on('time', () => this.update());
    session.on('selection', () => this.update());
  }

  toggle(open = this.node.hidden) {
    this.node.hidden = !open;
    this.update();
  }

  get pickedKeys() {
    return [...this.picked].map((each) => each.split(' ').map(Number));
  }

  /** Rows: all keyed controls together, then each of them. */
  update() {
    if (this.node.hidden) return;
    const { session } = this;
    this.range = session.animation.range(session.keys);
    const known = new Set([...session.keys].flatMap(([control, track]) => track.map(([frame]) => `${control} ${frame}`)));
    this.picked = new Set([...this.picked].filter((each) => known.has(each)));
    const rows = [...session.keys].map(([control, track]) => this.row(session.controls[control].label, track.map(([frame]) => [[control, frame]])));
    const frames = [...new Set([...session.keys.values()].flat().map(([frame]) => frame))].sort((a, b) => a - b);
    const all = frames.map((frame) => [...session.keys].filter(([, track]) => track.some(([when]) => when === frame)).map(([control]) => [control, frame]));
    const none = make('p', { class: 'hint' }, 'No keys yet: K keys what is selected or changed, Auto-key every drag.');
    this.body.replaceChildren(...(rows.length ? [this.row('All', all), ...rows] : [none]));
  }

  row(name, marks) {
    const line = make('div', { class: 'dope-line' }, ...marks.map((keys) => this.mark(name, keys)));
    const now = make('i', { class: 'dope-now', style: { left: this.along(this.session.frame) } });
    line.append(now);
    return make('div', { class: 'dope-row', style: { height: `${ROW}px` } }, make('span', { title: name }, name), line);
  }

  along(frame) {
    const [first, last] = this.range;
    return `${(100 * (frame - first)) / (last - first)}%`;
  }

  /** A mark stands for one key, or for all at a frame. */
  mark(name, keys) {
    const frame = keys[0][1];
    const on = keys.every((key) => this.picked.has(key.join(' ')));
    return make('button', {
      type: 'button',
      class: 'dope-key',
      tabIndex: -1,
      style: { left: this.along(frame) },
      title: `${name}, frame ${frame}`,
      'aria-label': `${name}, frame ${frame}`,
      'aria-pressed': String(on),
      onpointerdown: (event) => this.press(event, keys),
    });
  }

  // --- hand ------------------------------------------------------------------------------------------

  /** Pick (shift: with those picked before) and move by dragging; with Ctrl copies are moved. */
  press(event, keys) {
    const line = event.currentTarget.parentElement.getBoundingClientRect();
    const names = keys.map((key) => key.join(' '));
    if (!event.shiftKey && !names.every((name) => this.picked.has(name))) this.picked.clear();
    names.forEach((name) => this.picked.add(name));
    const perPixel = (this.range[1] - this.range[0]) / line.width;
    let by = 0;
    const move = (moving) => (by = Math.round((moving.clientX - event.clientX) * perPixel));
    const up = (released) => {
      window.removeEventListener('pointermove', move);
      if (by) this.moveBy(by, released.ctrlKey || released.metaKey);
      else this.update();
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', up, { once: true });
    this.node.focus({ preventScroll: true });
    event.preventDefault();
  }

  key(event) {
    const steps = { ArrowLeft: -1, ArrowRight: 1 };
    if (event.key === 'Delete' || event.key === 'Backspace') this.remove();
    else if (steps[event.key] && this.picked.size) this.moveBy(steps[event.key] * (event.shiftKey ? 10 : 1), event.ctrlKey || event.metaKey);
    else if (event.key === 'a' && (event.ctrlKey || event.metaKey)) this.pickAll();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  pickAll() {
    this.picked = new Set([...this.session.keys].flatMap(([control, track]) => track.map(([frame]) => `${control} ${frame}`)));
    this.update();
  }

  moveBy(by, copies) {
    const picked = this.pickedKeys;
    if (!picked.length) return;
    const keys = movedKeys(this.session.keys, picked, by, copies);
    this.picked = new Set(picked.map(([control, frame]) => `${control} ${frame + by}`));
    this.session.rekey(`${copies ? 'Copy' : 'Move'} ${counted(picked.length)}`, keys);
  }

  remove() {
    const picked = this.pickedKeys;
    if (picked.length) this.session.rekey(`Delete ${counted(picked.length)}`, removedKeys(this.session.keys, picked));
  }
}

const counted = (count) => `${count} key${count === 1 ? '' : 's'}`;
