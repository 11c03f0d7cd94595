// The viewport: one or more columns showing the character, and the loop that keeps them up to date.

import { OrbitCamera } from './camera.js';
import { Cast } from './cast.js';
import { beginDrag } from './drag.js';
import { Gestures } from './gestures.js';
import { Onion } from './onion.js';
import { Overlay } from './overlay.js';
import { ScreenSurface } from './pick.js';
import { Rearranging } from './rearrange.js';
import { Stage } from './stage.js';
import { visibleTriangles } from './surface.js';
import { SNAP, contains, make } from './dom.js';
import { clamp, dot } from './vectors.js';

const SLOW = 45; // milliseconds per frame above which the picture is drawn coarser while it changes
const SETTLE = 180; // milliseconds of rest before the picture is drawn sharp again
const MOST_PIXELS = 0.7e6; // that the processor draws while the picture changes
const SMOOTH = 2; // how much finer the processor draws at rest, for smooth outlines
const MOST_SMOOTHED = 150000; // triangles up to which it does

export class View {
  /** @type {number} */ ratio;
  /** @type {number} */ closeness;

  /** `others`: sessions of characters that are shown besides; `say` tells people something. */
  constructor(session, others, say) {
    this.say = say;
    this.session = session;
    const marks = make('canvas', { class: 'marks' });
    this.tip = make('div', { class: 'tip', hidden: true });
    this.sides = [make('div', { class: 'side-tag', style: { left: '14px' } }), make('div', { class: 'side-tag' })];
    this.captions = make('div', { class: 'captions' });
    this.surface = make('div', { class: 'surface', tabIndex: 0, role: 'application', 'aria-label': 'Face: drag handles or skin' });
    this.cast = new Cast(session, others);
    this.stage = new Stage(this.cast.character, this.cast.points, drawingAsked());
    this.stage.onlost = () => this.changed('camera');
    this.onion = new Onion(this);
    this.node = make('div', { class: 'view' }, this.stage.node, this.onion.node, marks, this.surface, this.captions, ...this.sides, this.tip);
    this.overlay = new Overlay(marks, session);
    this.camera = new OrbitCamera(session.character.up, session.section.view);
    this.picker = new ScreenSurface(session.deformer.points, visibleTriangles(session.character));
    this.rearranging = new Rearranging(this);
    this.gestures = new Gestures(this);
    this.kinds = null;
    this.closeLook = null; // of frameClosely, as long as nothing else moves the camera
    this.showsInfluence = false; // while its key is held
    this.bare = false; // while all elements are hidden by theirs
    this.onInfluences = null;
    this.review = null;
    this.trails = null;
    this.shotLook = null; // where the shot's camera looked last
    this.columns = [];
    this.stale = new Set(['pose', 'camera', 'overlay']);
    this.fineness = 1;
    this.drawn = 0;
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.node);
  }

  /** A drag of an element, begun at the present pose, where the controls are shown. */
  beginDrag(element) {
    const { session } = this;
    const [held, map] = this.overlay.draggable(element, this.camera.projector(this.controlsColumn));
    return beginDrag(held, session.controls, session.rest, session.values, map);
  }

  listen() {
    const { session } = this;
    session.on('pose', () => this.changed('pose'));
    for (const event of ['selection', 'hover', 'dragging']) session.on(event, () => this.changed('overlay'));
    for (const event of ['options', 'layout']) session.on(event, () => this.arrange());
    session.on('time', () => session.options.shot && this.changed('camera'));
    session.on('section', () => {
      const { up } = session.character;
      this.camera = new OrbitCamera(up, session.section.view);
      this.overlay.dock.front = new OrbitCamera(up, session.section.view);
      session.emit('selection');
      session.emit('options');
      this.home();
    });
    for (const event of ['hover', 'selection', 'options', 'dragging']) session.on(event, () => (this.repaint = true));
  }

  /** Something needs drawing: 'pose', 'camera' or 'overlay'. */
  changed(what) {
    this.stale.add(what);
    this.request();
  }

  request() {
    this.scheduled ??= requestAnimationFrame((now) => {
      this.scheduled = null;
      this.frame(now);
    });
  }

  // --- columns ---------------------------------------------------------------------------------------

  resize() {
    const { clientWidth, clientHeight } = this.node;
    if (!clientWidth || !clientHeight) return;
    const first = !this.columns.length;
    this.width = clientWidth;
    this.height = clientHeight;
    this.ratio = Math.min(2, window.devicePixelRatio || 1);
    this.stage.resize(this.width, this.height, this.ratio * this.fineness);
    this.overlay.resize(this.width, this.height, this.ratio);
    this.arrange();
    if (first) this.home();
  }

  /** Lay out the columns: those of the evaluation, or the face alone, or the controls' copy and the clean face. */
  arrange() {
    if (!this.width) return; // not on the page yet
    const { arrangement, handles } = this.session.options;
    const { dock } = this.overlay;
    const kinds = this.kinds ?? (arrangement === 'beside' && handles ? ['controls', 'clean'] : ['controls']);
    const rect = kinds.includes('controls') ? dock.place(this.width, this.height) : null;
    dock.arrange(rect);
    const [wide, high] = rect && rect.width < this.width ? [rect.left, this.height] : [this.width, rect ? rect.top : this.height];
    const [most, highest] = this.roomOf?.() ?? [Infinity, Infinity];
    const width = Math.floor(Math.min(most, wide / kinds.length));
    const tall = Math.min(high, highest);
    const start = Math.floor((wide - width * kinds.length) / 2);
    const names = { controls: 'Controls', clean: 'Clean face', target: 'Target' };
    this.columns = kinds.map((kind, i) => ({ kind, left: start + i * width, top: 0, width, height: tall }));
    this.controlsColumn = this.columns.find((column) => column.kind === 'controls') ?? null;
    this.captions.replaceChildren(
      ...(kinds.length > 1 ? kinds : []).map((kind, i) =>
        make('span', { style: { left: `${start + i * width}px`, width: `${width}px` } }, this.captionOf?.(kind) ?? names[kind]),
      ),
    );
    this.sides.forEach((node) => (node.style.bottom = `${this.height - high + 12}px`));
    this.sides[1].style.right = `${this.width - wide + 14}px`;
    this.picker.invalidate();
    this.changed('camera');
  }

  /**
   * Show these columns instead of what the options say, at most as large as `roomOf` says; null goes back.
   * @param {((kind: string) => string) | null} [captionOf]
   * @param {(() => number[]) | null} [roomOf]
   */
  setColumns(kinds, captionOf = null, roomOf = null) {
    this.kinds = kinds;
    this.roomOf = roomOf;
    this.captionOf = captionOf;
    this.arrange();
    this.home();
  }

  /** [width, height] of a column for which three beside each other, and two beside a list so wide, have room. */
  commonRoom(list) {
    const whole = this.node.parentElement?.clientWidth ?? this.width;
    const rect = this.overlay.dock.place(whole, this.height);
    const beside = rect && rect.width < whole;
    return [Math.min((beside ? rect.left : whole) / 3, (whole - list) / 2), rect && !beside ? rect.top : this.height];
  }

  /** Pixels of the page from the highest to the lowest point of the face in a column of some kind. */
  faceHeight(kind) {
    const column = this.columns.find((each) => each.kind === kind);
    if (!column) return 0;
    const rows = this.session.section.frame.map((point) => this.camera.projector(column)(point)[1]);
    return Math.max(...rows) - Math.min(...rows);
  }

  /** Look at the face: from the front, or from an azimuth and elevation off it. */
  home(azimuth = 0, elevation = 0) {
    this.camera.turn(azimuth, elevation);
    const column = this.columns[0] ?? { width: 1, height: 1 };
    this.camera.frame(this.session.section.frame, column.width, column.height);
    this.closeness = this.camera.distance;
    this.changed('camera');
  }

  shownElements() {
    return this.session.elements.list.filter((element) => this.session.isShown(element));
  }

  /** Look as a note does (notes.js), at least as much of it as its page showed. */
  lookAs({ target, towards, distance, aspect }) {
    const { width, height } = this.controlsColumn ?? this.columns[0];
    this.camera.lookFrom([...target], towards, distance * Math.max(1, (aspect * height) / width));
    this.changed('camera');
  }

  /** Look more closely, from the same side: at the selected elements, else at those on the face; done again, as before. */
  frameClosely() {
    const { session, camera } = this;
    const where = () => JSON.stringify([camera.target, camera.towards, camera.distance, [...session.selection]]);
    if (this.closeLook?.where === where()) {
      const { target, towards, distance } = this.closeLook.before;
      camera.lookFrom(target, towards, distance);
      this.closeLook = null;
      this.changed('camera');
      return;
    }
    const { target, towards, distance } = camera;
    const onFace = this.shownElements().filter((element) => !element.onBoard);
    const selected = session.selectedElements.filter((element) => !element.onBoard);
    const chosen = selected.length ? selected : onFace;
    const column = this.columns[0];
    const points = chosen.flatMap((element) => element.tracks.flat());
    camera.frame(points, column.width, column.height, selected.length ? 3 : 1.2);
    this.closeLook = { where: where(), before: { target, towards, distance } };
    this.changed('camera');
  }

  locate(event) {
    const box = this.surface.getBoundingClientRect();
    const at = { x: event.clientX - box.left, y: event.clientY - box.top };
    return { ...at, column: this.overlay.dock.contains(at) ? null : (this.columns.find((column) => contains(column, at)) ?? null) };
  }

  /** Whether elements can be there: on the face that shows them, or on the board. */
  controlsAt(at) {
    return this.overlay.dock.contains(at) || (at.column !== null && at.column === this.controlsColumn);
  }

  /** The element under a pointer, if any. */
  elementAt(at, reach = 0) {
    return this.controlsAt(at) ? this.overlay.elementAt(at.x, at.y, reach) : null;
  }

  /** Look at a region of the skin as closely as to tell what is there apart, or at the whole face again. */
  dive(hit) {
    const { camera } = this;
    if (camera.distance < 0.7 * this.closeness) return this.home(camera.azimuth, camera.elevation);
    camera.target = this.session.shown(hit);
    camera.zoom(0.4);
    return this.changed('camera');
  }

  pick({ x, y, column }) {
    return column ? this.picker.pick(this.camera, column, x, y) : null;
  }

  // --- drawing ---------------------------------------------------------------------------------------

  /** Bring everything up to date at once, so that a press meets what is to be seen. */
  freshen() {
    this.gestures.flush();
    if (this.stale.size) this.drawNow();
  }

  frame(now) {
    this.gestures.flush();
    this.pace(now);
    if (this.stale.size || this.repaint) this.drawNow();
  }

  /** Look through the shot's camera at the present frame, until somebody has moved this one. */
  lookThroughShot() {
    const { camera, session } = this;
    const { shotCamera, timeCodes } = session.character;
    const look = () => [camera.half, camera.distance, ...camera.target, ...camera.towards].join();
    if (!session.options.shot) this.shotLook = null;
    else if (this.shotLook && this.shotLook !== look()) session.setOption('shot', false);
    else {
      const at = Math.round(session.frame - (timeCodes?.[0] ?? session.frame));
      camera.lookThrough(shotCamera[clamp(at, 0, shotCamera.length - 1)], this.columns[0]);
      this.shotLook = look();
    }
  }

  drawNow() {
    const { stale } = this;
    if (stale.has('camera')) this.lookThroughShot();
    if (this.repaint) this.paint();
    if (stale.has('pose')) {
      this.cast.follow();
      this.stage.refresh();
    }
    if (stale.has('pose') || stale.has('camera')) this.picker.invalidate();
    const full = stale.has('pose') || stale.has('camera') || this.repaint;
    this.repaint = false;
    const turned = stale.has('camera');
    stale.clear();
    if (full) {
      this.stage.draw(this.columns, this.camera);
      this.drawn++;
    }
    this.arrangeOverlay(turned);
    this.overlay.draw(this.review?.lines(), this.trails?.shown());
    this.onion.follow();
    this.placeTip();
    this.nameSides();
  }

  /** Occlusion is worked out when the camera turns and when a drag is over, not during it. */
  arrangeOverlay(turned) {
    const column = this.controlsColumn;
    if (!column) return;
    const { session, camera, picker } = this;
    const bias = 0.8 * session.elements.width;
    const held = session.dragging !== null && !turned;
    const every = session.options.occlusion === 'overlay';
    const hides = every ? () => false : held ? null : (at) => picker.hides(camera, column, at, bias);
    this.overlay.arrange(column, camera, hides);
  }

  /** Draw coarser while frames are slow, and sharp again when nothing changes. */
  pace(now) {
    const moving = this.stale.has('pose') || this.stale.has('camera') || this.repaint;
    if (moving && this.fineness > this.brisk) this.setFineness(this.brisk);
    if (moving && this.lastFrame && now - this.lastFrame < 400) {
      this.average = 0.8 * (this.average ?? 0) + 0.2 * (now - this.lastFrame);
      if (this.average > SLOW && this.fineness > 0.5) this.setFineness(this.fineness - 0.25);
    } else this.average = 0;
    this.lastFrame = moving ? now : null;
    clearTimeout(this.settling);
    if (this.fineness !== this.finest) this.settling = setTimeout(() => this.sharpen(), SETTLE);
  }

  /** Share of the screen's resolution at which the picture is drawn while it changes. */
  get brisk() {
    if (this.stage.drawnBy !== 'processor') return 1;
    const most = Math.sqrt(MOST_PIXELS / (this.width * this.height));
    return Math.min(1, Math.floor(SNAP * most) / SNAP / this.ratio);
  }

  /** Share of the screen's resolution at which the picture is drawn when nothing moves. */
  get finest() {
    const rough = this.stage.drawnBy === 'processor' && this.ratio < SMOOTH;
    return rough && this.stage.triangles.length <= 3 * MOST_SMOOTHED ? SMOOTH : 1;
  }

  sharpen() {
    if (this.gestures.active) this.settling = setTimeout(() => this.sharpen(), SETTLE);
    else {
      this.setFineness(this.finest);
      this.drawNow();
    }
  }

  setFineness(fineness) {
    this.fineness = fineness;
    this.average = 0;
    this.stage.resize(this.width, this.height, this.ratio * fineness);
    this.stale.add('camera');
  }

  /** Heat map of the hovered or selected elements, or of a control that another panel points at. */
  paint() {
    const { session } = this;
    const busy = session.dragging !== null;
    const subjects = this.showsInfluence ? [...session.selectedElements, session.hover].filter(Boolean) : session.hover && !session.quiet ? [session.hover] : [];
    const controls = this.pointedControl ?? subjects.flatMap((element) => element.members.map(({ control }) => control));
    const list = Array.isArray(controls) ? controls : [controls];
    const wanted = session.options.heat && !busy && list.length;
    this.stage.paint(wanted ? session.influence.ofControls(list) : null);
  }

  /** What holds while a key is down: 'bare' hides all elements, 'showsInfluence' colours what the selection moves. */
  hold(what, on) {
    this[what] = on;
    for (const { style } of [this.overlay.canvas, this.tip]) style.visibility = this.bare ? 'hidden' : '';
    this.repaint = true;
    this.request();
  }

  /** Show the heat map of one control, whatever is hovered; null ends it. */
  pointAt(control) {
    this.pointedControl = control === null ? null : [control];
    this.repaint = true;
    this.request();
  }

  // --- words -----------------------------------------------------------------------------------------

  placeTip() {
    const { hover, dragging, controls } = this.session;
    const element = dragging && dragging !== 'skin' ? dragging : hover;
    const drawn = element && this.overlay.drawn.find((each) => each.element === element);
    this.tip.hidden = !drawn || !this.session.options.handles;
    if (this.tip.hidden) return;
    const lines = element.members.map(({ control }) => make('div', {}, make('b', {}, this.session.worded(control)), ` ${controls[control].label}`));
    const heading = make('div', { class: 'tip-side', style: { borderColor: this.session.colours[element.side] } }, sideName(element.side));
    this.tip.replaceChildren(...(sideName(element.side) ? [heading] : []), ...lines);
    const [x, y] = drawn.handle;
    const right = x + 230 > this.width;
    this.tip.style.transform = `translate(${Math.round(right ? x - 18 : x + 18)}px, ${Math.round(y - 12)}px) translateX(${right ? -100 : 0}%)`;
  }

  /** Say on which side of the picture the character's left and right are, from any view. */
  nameSides() {
    const normal = this.session.character.layout.planeNormal;
    const across = dot(normal, this.camera.right);
    const names = Math.abs(across) < 0.25 ? [null, null] : across > 0 ? ['right', 'left'] : ['left', 'right'];
    this.sides.forEach((node, i) => {
      const name = names[i];
      node.hidden = !name || !this.session.options.handles;
      if (!name) return;
      node.textContent = i === 0 ? `◂ Character’s ${name}` : `Character’s ${name} ▸`;
      node.style.borderColor = this.session.colours[name];
    });
  }

  setCursor(name) {
    this.surface.style.cursor = name;
  }

  showInfluences(hit) {
    this.onInfluences?.(hit);
  }
}

/** 'webgl' or 'canvas' where the page's address insists on it: `#draw=canvas`. */
function drawingAsked() {
  const asked = new URLSearchParams(window.location.hash.slice(1)).get('draw');
  return asked === 'webgl' || asked === 'canvas' ? asked : null;
}

export function sideName(side) {
  return { left: 'Character’s left', right: 'Character’s right', middle: 'Middle', none: '' }[side];
}
