// Curves of the selected controls, or of all that have keys, over time: each over its own range, with keys to drag in time
// and value.

import { keyedValue } from './animation.js';
import { setAll } from './dom.js';
import { bendsOf, slopeOf, wayOf } from './interpolation.js';
import { retimed, withKeys } from './keying.js';
import { ascending, clamp, rounded } from './vectors.js';

export const REACH = { mouse: 8, touch: 22 }; // pixels around a key
export const WIDE = 60; // pixels from one number of a frame to the next, at least
const EDGE = 14; // pixels around the curves
const SVG = 'http://www.w3.org/2000/svg';

export class Curves {
  /** `sheet`: whose keys are shown, picked and changed. */
  constructor(sheet) {
    this.sheet = sheet;
    this.size = [0, 0];
    this.node = /** @type {SVGSVGElement} */ (svg('svg', { class: 'curves', role: 'img', 'aria-label': 'Curves' }));
    this.node.addEventListener('pointerdown', (event) => this.press(event));
    new ResizeObserver(() => this.sheet.shows === 'curves' && !this.sheet.node.hidden && this.draw()).observe(this.node);
  }

  get session() {
    return this.sheet.session;
  }

  /** Keyed controls that are selected, or all that are keyed. */
  get controls() {
    const keyed = [...this.sheet.keys.keys()];
    const chosen = new Set(this.session.selection.size ? this.session.chosenControls : []);
    const both = keyed.filter((control) => chosen.has(control));
    return both.length ? both : keyed;
  }

  draw() {
    const { clientWidth: width, clientHeight: height } = this.node;
    if (!this.sheet.scale || !width) return;
    this.size = [width, height];
    this.node.replaceChildren(
      ...[0, 0.5, 1].flatMap((share) => this.level(share)),
      ...roundFrames(this.sheet.scale, width / WIDE).flatMap((frame) => [
        svg('line', { class: 'curve-grid', x1: this.x(frame), x2: this.x(frame), y1: 0, y2: height }),
        text(frame, { class: 'curve-number', x: this.x(frame) + 3, y: height - 2 }),
      ]),
      ...this.tangents.flatMap(({ from, at }) => [svg('polyline', { class: 'curve-tangent', points: `${from} ${at}` }), svg('circle', { class: 'curve-tangent', cx: at[0], cy: at[1], r: 3.5 })]),
      ...this.controls.flatMap((control) => this.curve(control)),
      svg('line', { class: 'curve-now', y1: 0, y2: height }),
      ...this.band(),
    );
    this.moveNow();
  }

  moveNow() {
    const now = this.node.querySelector('.curve-now');
    const x = this.size ? this.x(this.session.frame) : 0;
    if (now) setAll(now, { x1: x, x2: x });
  }

  /** A line across and what it stands for: a value of the one control that is shown, or of all a share of their ranges. */
  level(share) {
    const shown = this.controls.map((control) => this.session.controls[control]);
    const value = ({ minimum, maximum }) => Number((minimum + share * (maximum - minimum)).toPrecision(3));
    const words = shown.length > 1 ? `${100 * share} %` : shown.map(value).join();
    return [
      svg('line', { class: 'curve-grid', x1: 0, x2: this.size[0], y1: this.y(share), y2: this.y(share) }),
      text(words, { class: 'curve-number', x: 2, y: this.y(share) - 2 }),
    ];
  }

  curve(control) {
    const { session, sheet } = this;
    const track = sheet.keys.get(control);
    const colour = session.colours[session.elements.byControl.get(control)?.side ?? 'none'];
    const { label } = session.controls[control];
    const [[first], [last]] = [track[0], track.at(-1)];
    const times = ascending([...track.map(([frame]) => frame), ...bendsOf(track), ...wholeFrames(first, last)]);
    const points = times.map((time) => this.place(control, time, keyedValue(track, time, null)).join());
    const named = this.place(control, last, track.at(-1)[1]);
    const ends = named[0] > this.size[0] - 120;
    return [
      svg('polyline', { class: 'curve', points: points.join(' '), stroke: colour }),
      ...track.map(([frame, value]) => this.keyMark(control, frame, value, colour, label)),
      text(label, { class: 'curve-name', x: named[0] + (ends ? -8 : 8), y: Math.max(12, named[1] - 6), 'text-anchor': ends ? 'end' : 'start' }),
    ];
  }

  keyMark(control, frame, value, colour, label) {
    const [x, y] = this.place(control, frame, value);
    const on = this.sheet.isPicked(control, frame);
    const mark = svg('circle', { class: on ? 'curve-key on' : 'curve-key', cx: x, cy: y, r: 4.5, fill: on ? '#fff' : colour });
    mark.append(text(`${label}, frame ${frame}: ${value.toFixed(3)}`, {}, 'title'));
    return mark;
  }

  // --- places ----------------------------------------------------------------------------------------

  x(frame) {
    const [first, last] = this.sheet.scale;
    return EDGE + ((frame - first) / (last - first)) * (this.size[0] - 2 * EDGE);
  }

  y(share) {
    return this.size[1] - EDGE - share * (this.size[1] - 2 * EDGE);
  }

  get framesPerPixel() {
    return (this.sheet.scale[1] - this.sheet.scale[0]) / (this.size[0] - 2 * EDGE);
  }

  valuePerPixel(control) {
    const { minimum, maximum } = this.session.controls[control];
    return (maximum - minimum) / (this.size[1] - 2 * EDGE);
  }

  place(control, frame, value) {
    const { minimum, maximum } = this.session.controls[control];
    return [this.x(frame), this.y((value - minimum) / (maximum - minimum))];
  }

  /** All keys that are shown: {key: [control, frame], at: its place}. */
  get shown() {
    return this.controls.flatMap((control) => this.sheet.keys.get(control).map(([frame, value]) => ({ key: [control, frame], at: this.place(control, frame, value) })));
  }

  /** The shown key, or the end of a tangent, nearest to a place; undefined where none is within reach. @param {number[]} place */
  nearest(place, reach) {
    const away = ({ at }) => Math.hypot(at[0] - place[0], at[1] - place[1]);
    return [...this.shown, ...this.tangents].filter((each) => away(each) <= reach).sort((a, b) => away(a) - away(b))[0];
  }

  /** Tangents of the picked keys towards their smooth sides: {control, key, reach in frames, from, at: the places of its ends}. */
  get tangents() {
    return this.controls.flatMap((control) => this.sheet.keys.get(control).flatMap(([frame, value], index, track) => {
      const smooth = [index - 1, index].filter((start) => this.sheet.isPicked(control, frame) && track[start + 1] && wayOf(track[start] ?? []) === 'smooth');
      return smooth.map((start) => {
        const reach = (start < index ? -1 : 1) * (track[start + 1][0] - track[start][0]) / 3;
        const at = this.place(control, frame + reach, value + reach * slopeOf(track, index));
        return { control, key: track[index], reach, from: this.place(control, frame, value), at };
      });
    }));
  }

  // --- hand ------------------------------------------------------------------------------------------

  press(event) {
    if (event.button || !this.size) return;
    const box = this.node.getBoundingClientRect();
    const at = [event.clientX - box.left, event.clientY - box.top];
    const hit = this.nearest(at, event.pointerType === 'touch' ? REACH.touch : REACH.mouse);
    if (hit?.from) this.bending(event, hit);
    else if (hit) this.moving(event, hit.key);
    else this.ranging(event, box, at);
    this.sheet.node.focus({ preventScroll: true });
    event.preventDefault();
  }

  moving(event, hit) {
    const { sheet } = this;
    sheet.pick([hit], event.shiftKey);
    sheet.draw();
    sheet.dragging(event, (now) => {
      const [dx, dy] = [now.clientX - event.clientX, now.clientY - event.clientY];
      const upright = now.shiftKey && Math.abs(dy) > Math.abs(dx);
      const by = upright ? 0 : Math.round(dx * this.framesPerPixel);
      const up = now.shiftKey && !upright ? 0 : -dy;
      const to = retimed(by, hit[1], now.altKey ? sheet.span : null);
      return by || up ? ([frame, value], control) => [to(frame), value + up * this.valuePerPixel(control)] : null;
    });
  }

  /** A tangent follows the pointer; its ends stay within the control's range, and with them the curve. */
  bending(event, { control, key, from, at }) {
    const { sheet, session } = this;
    const [frame, value] = key;
    const { minimum, maximum } = session.controls[control];
    const reaches = this.tangents.filter((each) => each.key === key).map((each) => each.reach);
    const within = (slope, reach) => (clamp(value + slope * reach, minimum, maximum) - value) / reach;
    const side = Math.sign(at[0] - from[0]);
    let { keys } = session;
    sheet.follow(event, (now) => {
      const [dx, dy] = [side * (at[0] - from[0] + now.clientX - event.clientX), from[1] - at[1] + event.clientY - now.clientY];
      const slope = (side * dy * this.valuePerPixel(control)) / (Math.max(1, dx) * this.framesPerPixel);
      keys = withKeys(session.keys, [[control, [frame, value, wayOf(key), rounded(reaches.reduce(within, slope))]]]);
      sheet.preview = { keys, picked: sheet.picked };
      sheet.draw();
    }, () => keys === session.keys || session.rekey('Bend a curve', keys));
  }

  ranging(event, box, from) {
    const { sheet } = this;
    sheet.selecting(event, (now) => {
      const to = [now.clientX - box.left, now.clientY - box.top];
      const [low, high] = [Math.min, Math.max].map((end) => [0, 1].map((axis) => end(from[axis], to[axis])));
      sheet.range = { controls: [], frames: [], corners: [low, high] };
      return this.shown.filter(({ at }) => at.every((value, axis) => value >= low[axis] && value <= high[axis])).map(({ key }) => key);
    });
  }

  /** The range that is being picked. */
  band() {
    const [low, high] = this.sheet.range?.corners ?? [];
    return low ? [svg('rect', { class: 'curve-band', x: low[0], y: low[1], width: high[0] - low[0], height: high[1] - low[1] })] : [];
  }
}

/** Round frames of a range, `most` at most, about. */
export function roundFrames([first, last], most) {
  const rough = Math.max(1, (last - first) / Math.max(1, most));
  const unit = 10 ** Math.floor(Math.log10(rough));
  const step = unit * ([1, 2, 5].find((times) => times * unit >= rough) ?? 10);
  return [...wholeFrames(first / step, last / step)].map((count) => count * step);
}

function* wholeFrames(first, last) {
  for (let frame = Math.ceil(first); frame <= last; frame++) yield frame;
}

function svg(tag, attributes) {
  const node = document.createElementNS(SVG, tag);
  setAll(node, attributes);
  return node;
}

function text(words, attributes, tag = 'text') {
  const node = svg(tag, attributes);
  node.textContent = words;
  return node;
}

