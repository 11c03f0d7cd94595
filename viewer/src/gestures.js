// One gesture system without modes.  A press takes what is under the pointer: a handle, else the skin,
// else the empty space, which orbits.  Moves are handled once per drawn frame.

import { beginDrag, dragTo, movedAlong } from './drag.js';
import { Pull } from './pull.js';

const SLOP = 3; // pixels that a click may wander
const FINE = 0.1;

export class Gestures {
  constructor(view) {
    this.view = view;
    this.session = view.session;
    this.active = null;
    this.pending = null;
    const surface = view.surface;
    surface.addEventListener('pointerdown', (event) => this.press(event));
    surface.addEventListener('pointermove', (event) => this.move(event));
    surface.addEventListener('pointerup', (event) => this.release(event));
    surface.addEventListener('pointercancel', () => this.cancel());
    surface.addEventListener('pointerleave', () => this.leave());
    surface.addEventListener('dblclick', (event) => this.doubleClick(event));
    surface.addEventListener('contextmenu', (event) => event.preventDefault());
    surface.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  // --- events ----------------------------------------------------------------------------------------

  press(event) {
    if (this.active) return;
    const at = this.view.locate(event);
    this.view.surface.focus({ preventScroll: true });
    this.view.surface.setPointerCapture(event.pointerId);
    this.view.freshen();
    this.active = { start: at, last: at, hand: at, moved: false, ...this.chooseGesture(event, at) };
    this.active.begin?.();
    event.preventDefault();
  }

  move(event) {
    this.pending = { at: this.view.locate(event), fine: event.ctrlKey || event.metaKey };
    this.view.request();
  }

  /** Act on the latest move; called once before each frame. */
  flush() {
    if (!this.pending) return;
    const { at, fine } = this.pending;
    this.pending = null;
    if (this.active) this.dragTo(at, fine);
    else this.hover(at);
  }

  dragTo(at, fine) {
    const { active } = this;
    const scale = fine ? FINE : 1;
    active.hand = {
      ...at,
      x: active.hand.x + scale * (at.x - active.last.x),
      y: active.hand.y + scale * (at.y - active.last.y),
    };
    const step = [at.x - active.last.x, at.y - active.last.y];
    active.last = at;
    if (!active.moved && Math.hypot(at.x - active.start.x, at.y - active.start.y) < SLOP) return;
    if (!active.moved) active.grab?.();
    active.moved = true;
    active.drag?.(active.hand, step, at);
  }

  release(event) {
    if (!this.active) return;
    this.move(event);
    this.flush();
    const { active } = this;
    this.active = null;
    if (active.moved) active.drop?.(active.last);
    else active.click?.();
    this.session.affected = new Map();
    this.setDragging(null);
    this.view.changed('pose');
  }

  /** Give up the gesture and take back what it did. */
  cancel() {
    const { active } = this;
    this.active = null;
    active?.undo?.();
    this.session.affected = new Map();
    this.setDragging(null);
    return active !== null;
  }

  leave() {
    if (!this.active) this.session.setHover(null);
  }

  doubleClick(event) {
    const at = this.view.locate(event);
    const element = this.view.controlsAt(at) ? this.view.overlay.elementAt(at.x, at.y) : null;
    if (element) this.session.reset(element.members.map(({ control }) => control));
  }

  wheel(event) {
    event.preventDefault();
    this.view.camera.zoom(Math.exp(0.0012 * Math.max(-300, Math.min(300, event.deltaY))));
    this.view.changed('camera');
  }

  hover(at) {
    const element = this.view.controlsAt(at) ? this.view.overlay.elementAt(at.x, at.y) : null;
    this.session.setHover(element);
    const onSkin = !element && at.column?.kind !== 'target' && this.view.pick(at);
    this.view.setCursor(element ? 'grab' : onSkin && this.session.options.skinDrag ? 'crosshair' : 'default');
  }

  // --- what a press means ----------------------------------------------------------------------------

  chooseGesture(event, at) {
    const { view, session } = this;
    if (event.button === 1 || event.button === 2) return this.panning();
    if (event.altKey || !at.column || at.column.kind === 'target') return this.orbiting();
    const element = view.controlsAt(at) ? view.overlay.elementAt(at.x, at.y) : null;
    if (element && session.options.rearrange) return view.rearranging.gesture(element);
    if (element) return event.shiftKey ? this.adding(element) : this.handling(element);
    const pin = view.controlsAt(at) ? view.overlay.pinAt(at.x, at.y) : null;
    if (pin) return { click: () => session.removePin(pin) };
    const hit = session.options.skinDrag ? view.pick(at) : null;
    if (event.shiftKey) return this.marquee(hit, at);
    return hit && !session.options.rearrange ? this.pulling(hit, at) : this.orbiting();
  }

  orbiting() {
    const { camera } = this.view;
    return {
      drag: (_, [dx, dy]) => {
        camera.turn(camera.azimuth - 0.008 * dx, camera.elevation + 0.008 * dy);
        this.view.changed('camera');
      },
      click: () => this.session.select([]),
    };
  }

  panning() {
    const { camera } = this.view;
    return {
      drag: (_, [dx, dy]) => {
        camera.pan(dx, dy, this.view.height);
        this.view.changed('camera');
      },
    };
  }

  adding(element) {
    return { click: () => this.session.select([element], 'toggle') };
  }

  handling(element) {
    const { session, view } = this;
    let drag = null;
    let before = null;
    return {
      begin: () => {
        if (!session.selection.has(element.index)) session.select([element]);
        before = session.beginEdit();
        this.setDragging(element);
        view.setCursor('grabbing');
      },
      grab: () => {
        const project = view.camera.projector(this.active.start.column);
        drag = beginDrag(element, session.controls, session.rest, session.values, project);
      },
      drag: (hand) => {
        const changed = dragTo(drag, hand.x - this.active.start.x, hand.y - this.active.start.y);
        session.set(this.withSelection(element, drag, changed, before));
      },
      drop: () => session.endEdit(`Drag ${element.label}`, before),
      undo: () => session.set([...before.entries()]),
    };
  }

  /** The other selected elements move by the same share of their ranges, axis by axis. */
  withSelection(element, drag, changed, before) {
    const { controls, rest, selectedElements } = this.session;
    const out = new Map(changed);
    for (const other of selectedElements.filter((each) => each !== element)) {
      other.axes.slice(0, drag.axes.length).forEach((_, axis) => {
        const by = drag.current[axis] - drag.start[axis];
        const moved = by ? movedAlong(other, axis, by, controls, rest, before) : [];
        if (!moved.some(([control]) => out.has(control))) moved.forEach(([control, value]) => out.set(control, value));
      });
    }
    return out;
  }

  pulling(hit, at) {
    const { session, view } = this;
    let pull = null;
    let before = null;
    return {
      grab: () => {
        before = session.beginEdit();
        pull = new Pull(session, hit, view.camera.towards);
        this.setDragging('skin');
        view.setCursor('grabbing');
      },
      drag: (hand) => {
        const { column } = at;
        const from = view.camera.unproject(column, at.x, at.y, hit.depth);
        const to = view.camera.unproject(column, hand.x, hand.y, hit.depth);
        pull.to(pull.origin.map((value, axis) => value + to[axis] - from[axis]));
      },
      drop: () => session.endEdit('Pull the skin', before),
      click: () => view.showInfluences(hit),
      undo: () => before && session.set([...before.entries()]),
    };
  }

  /** Shift: drag a box around handles, or click the skin to pin it. */
  marquee(hit, at) {
    const { session, view } = this;
    const box = (to) => [at.x, at.y, to.x, to.y];
    return {
      drag: (_, __, to) => {
        view.overlay.marquee = box(to);
        view.changed('overlay');
      },
      drop: (to) => {
        view.overlay.marquee = null;
        session.select(view.overlay.elementsIn(box(to)), 'add');
      },
      click: () => hit && session.addPin(hit),
      undo: () => (view.overlay.marquee = null),
    };
  }

  setDragging(what) {
    this.session.dragging = what;
    this.session.emit('dragging');
  }
}
