// One gesture system without modes.  A press takes what is under the pointer: a handle, else the skin,
// else the empty space, which orbits.  One finger does what the mouse does; two pan, pinch and turn.  Moves are
// handled once per drawn frame.

import { minus, plus } from './camera.js';
import { dragTo, movedAlong } from './drag.js';
import { FINGER } from './dom.js';
import { Pull } from './pull.js';
import { clamp } from './vectors.js';

const SLOP = 3; // pixels that a click may wander
const FINE = 0.1;
const HOLD = 500; // milliseconds that a finger rests on the skin to pin it

export class Gestures {
  constructor(view) {
    this.view = view;
    this.session = view.session;
    this.active = null;
    this.pending = null;
    this.reach = 0; // pixels around a fingertip
    this.fingers = new Map(); // pointer -> its latest place
    const surface = view.surface;
    const acts = { pointerdown: this.press, pointermove: this.move, pointerup: this.release, pointercancel: this.lose, pointerleave: this.leave, dblclick: this.doubleClick };
    for (const [kind, act] of Object.entries(acts)) surface.addEventListener(kind, (event) => act.call(this, event));
    surface.addEventListener('contextmenu', (event) => event.preventDefault());
    surface.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
  }

  // --- events ----------------------------------------------------------------------------------------

  press(event) {
    const at = this.view.locate(event);
    if (event.pointerType === 'touch') {
      if (this.active?.isOfPen) return undefined; // the hand that holds the pen
      this.fingers.set(event.pointerId, at);
      if (this.fingers.size === 2) return this.beginTwo();
    }
    if (this.active) return undefined;
    this.view.surface.focus({ preventScroll: true });
    this.view.surface.setPointerCapture(event.pointerId);
    this.view.freshen();
    this.reach = event.pointerType === 'touch' ? FINGER / 2 : 0;
    const { pointerId: pointer, pointerType } = event;
    this.active = { pointer, isOfPen: pointerType === 'pen', start: at, last: at, hand: at, moved: false, ...this.chooseGesture(event, at) };
    this.active.begin?.();
    clearTimeout(this.holding);
    if (pointerType !== 'mouse' && this.active.hold) this.holding = setTimeout(() => this.hold(pointer), HOLD);
    event.preventDefault();
    return undefined;
  }

  /** A finger or a pen has rested where it pressed: what its gesture does then, and nothing when it goes. */
  hold(pointer) {
    this.flush();
    const { active } = this;
    if (active?.pointer !== pointer || active.moved) return;
    active.hold();
    Object.assign(active, { grab: null, drag: null, drop: null, click: null, undo: null });
  }

  move(event) {
    const at = this.view.locate(event);
    if (this.fingers.has(event.pointerId)) this.fingers.set(event.pointerId, at);
    if (this.active?.isOfTwo) {
      this.active.stale = true; // until the frame, so that both fingers have moved
      return this.view.request();
    }
    if (this.active && this.active.pointer !== event.pointerId) return undefined;
    if (event.pointerType !== 'touch') this.reach = 0;
    const passed = this.session.options.draw && this.active ? event.getCoalescedEvents?.() ?? [] : [];
    const trail = [...(this.pending?.trail ?? []), ...(passed.length ? passed : [event]).map((each) => this.view.locate(each))];
    this.pending = { at, trail, fine: event.ctrlKey || event.metaKey };
    return this.view.request();
  }

  // --- two fingers -----------------------------------------------------------------------------------

  /** Take back what the first finger has begun; the two of them hold the camera. */
  beginTwo() {
    this.cancel();
    this.pending = null;
    this.active = { isOfTwo: true, ...this.grip() };
  }

  /** Where two fingers are: their middle, how far apart, and how they are turned. */
  grip() {
    const [a, b] = [...this.fingers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(b.x - a.x, b.y - a.y) || 1, angle: Math.atan2(b.y - a.y, b.x - a.x) };
  }

  moveTwo() {
    if (this.fingers.size < 2 || !this.active.stale) return;
    const { camera, columns: [{ left, top, width, height }] } = this.view;
    const [before, now] = [this.active, this.grip()];
    const nearer = now.apart / before.apart;
    camera.zoom(1 / nearer);
    const stays = (at, was, middle) => at - middle - nearer * (was - middle); // what is between the fingers stays there
    camera.pan(stays(now.x, before.x, left + width / 2), stays(now.y, before.y, top + height / 2), height);
    const turned = Math.atan2(Math.sin(now.angle - before.angle), Math.cos(now.angle - before.angle));
    camera.turn(camera.azimuth + turned, camera.elevation);
    Object.assign(this.active, now, { stale: false });
    this.view.changed('camera');
  }

  lose(event) {
    this.fingers.delete(event.pointerId);
    this.cancel();
  }

  /** Act on the latest move; called once before each frame. */
  flush() {
    if (this.active?.isOfTwo) this.moveTwo();
    if (!this.pending) return;
    const { at, trail, fine } = this.pending;
    this.pending = null;
    if (this.active) this.dragTo(at, fine, trail);
    else this.hover(at);
  }

  dragTo(at, fine, trail) {
    const { active } = this;
    const scale = fine ? FINE : 1;
    const step = [at.x - active.last.x, at.y - active.last.y];
    active.hand = { ...at, x: active.hand.x + scale * step[0], y: active.hand.y + scale * step[1] };
    active.last = at;
    if (!active.moved && Math.hypot(at.x - active.start.x, at.y - active.start.y) < SLOP) return;
    if (!active.moved) active.grab?.();
    active.moved = true;
    active.drag?.(active.hand, step, at, trail);
  }

  release(event) {
    if (this.active?.isOfTwo) this.moveTwo();
    this.fingers.delete(event.pointerId);
    if (this.active?.isOfTwo) this.active = null;
    if (!this.active || this.active.pointer !== event.pointerId) return;
    this.move(event);
    this.flush();
    const { active } = this;
    this.active = null;
    if (active.moved) active.drop?.(active.last);
    else active.click?.();
    this.session.quiet ||= active.moved;
    this.setDragging(null);
    this.view.changed('pose');
  }

  /** Give up the gesture and take back what it did. */
  cancel() {
    const { active } = this;
    this.active = null;
    active?.undo?.();
    this.setDragging(null);
    return active !== null;
  }

  leave() {
    if (!this.active) this.session.setHover(null);
  }

  doubleClick(event) {
    const at = this.view.locate(event);
    const element = this.view.elementAt(at);
    const hit = element ? null : this.view.pick(at);
    if (element) this.session.reset(element.members.map(({ control }) => control));
    else if (hit) this.view.dive(hit);
  }

  wheel(event) {
    event.preventDefault();
    if (this.view.overlay.dock.contains(this.view.locate(event))) return this.scroll(event.deltaY);
    this.view.camera.zoom(Math.exp(0.0012 * clamp(event.deltaY, -300, 300)));
    return this.view.changed('camera');
  }

  /** Scroll the board. */
  scroll(by) {
    const { view } = this;
    if (!view.overlay.dock.scrollBy(by)) return;
    view.arrange();
    view.changed('overlay');
  }

  hover(at) {
    if (this.session.options.draw && at.column) {
      this.session.setHover(null);
      return this.view.setCursor('crosshair');
    }
    const { overlay } = this.view;
    if (this.view.controlsAt(at) && at.column && !this.reach && overlay.point(at.x, at.y)) this.view.changed('overlay');
    const element = this.view.elementAt(at);
    this.session.setHover(element);
    const onSkin = !element && at.column?.kind !== 'target' && this.view.pick(at);
    return this.view.setCursor(element ? 'grab' : onSkin && this.session.options.skinDrag ? 'crosshair' : 'default');
  }

  // --- what a press means ----------------------------------------------------------------------------

  chooseGesture(event, at) {
    const { view, session } = this;
    if (event.button === 1 || event.button === 2) return this.panning();
    if (session.options.draw && at.column && at.column === view.controlsColumn && !event.altKey) return view.review.drawing(at);
    const { reach } = this;
    const coarse = view.controlsAt(at) ? view.overlay.badgeAt(at.x, at.y, reach ? reach / 2 : undefined) : null;
    if (coarse) return { click: () => session.openOrClose([coarse]) };
    if (reach && at.column && view.overlay.isAmbiguous(at.x, at.y, reach)) return this.opening(at);
    const element = view.elementAt(at, reach);
    if (!element && view.overlay.dock.contains(at)) return { drag: (_, [, dy]) => this.scroll(-dy) };
    if (event.altKey || !(element || at.column) || at.column?.kind === 'target') return this.orbiting();
    if (element && session.options.rearrange) return view.rearranging.gesture(element);
    if (element) return event.shiftKey ? { click: () => session.select([element], 'toggle') } : this.handling(element);
    const pin = view.controlsAt(at) ? view.overlay.pinAt(at.x, at.y, reach) : null;
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
        camera.pan(dx, dy, this.view.columns[0].height);
        this.view.changed('camera');
      },
    };
  }

  /** A fingertip on several handles: they move apart, for the next press to choose. */
  opening(at) {
    return {
      begin: () => {
        this.view.overlay.point(at.x, at.y, FINGER);
        this.view.changed('overlay');
        this.view.say('Several handles lay under the finger: drag the one you mean');
      },
    };
  }

  handling(element) {
    const { session, view } = this;
    let drag = null;
    let before = null;
    return {
      begin: () => {
        if (!session.selection.has(element.index)) session.select([element]);
        session.emit('editing');
        this.setDragging(element);
        view.setCursor('grabbing');
      },
      grab: () => {
        before = session.beginEdit();
        drag = view.beginDrag(element);
      },
      drag: (hand) => {
        const changed = dragTo(drag, hand.x - this.active.start.x, hand.y - this.active.start.y);
        session.set(this.withSelection(element, drag, changed, before));
      },
      drop: () => session.endEdit(`Drag ${element.label}`, before),
      undo: () => this.takeBack(before),
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
        view.setCursor(pull.acts ? 'grabbing' : 'not-allowed');
        if (!pull.acts) view.say('No control that is free moves the skin here');
      },
      drag: (hand) => {
        const { column } = at;
        const from = view.camera.unproject(column, at.x, at.y, hit.depth);
        const to = view.camera.unproject(column, hand.x, hand.y, hit.depth);
        pull.to(plus(pull.origin, minus(to, from)));
      },
      drop: () => {
        if (pull.acts && before.every((value, i) => value === session.values[i])) view.say('No control that is free moves the skin here that way');
        session.endEdit('Pull the skin', before);
      },
      click: () => view.showInfluences(hit),
      hold: () => {
        session.addPin(hit);
        view.say('Pinned: pulls leave this point. A tap on the pin takes it out');
      },
      undo: () => this.takeBack(before),
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

  /** What a drag has done. */
  takeBack(before) {
    if (before) this.session.set([...before.entries()]);
  }

  setDragging(what) {
    Object.assign(this.session, { dragging: what, affected: new Map() });
    this.session.emit('dragging');
  }
}
