// The board as a strip at the edge of the view: rows of short tracks with names, in pixels, wherever the camera looks.

import { OrbitCamera, minus } from './camera.js';
import { FINGER, contains, lastWord } from './dom.js';
import { alongTrack, clamp, dot } from './vectors.js';

const WIDE = 184; // pixels of a column of rows, a quarter more where the view is wide
const CELL = 46; // of them for a track
const ROW = 26;
const SQUARE = 50; // height of a row whose element has several axes
const HEAD = 24;
const PAD = 10;
const FONT = '11.5px system-ui, sans-serif';

export class Dock {
  constructor(session) {
    this.session = session;
    this.scroll = 0;
    this.most = 0; // that it can be scrolled
    this.cells = new Map(); // element -> {left, top, height, map, tracks}
    this.headings = [];
    this.front = new OrbitCamera(session.character.up, session.section.view);
  }

  get elements() {
    return this.session.elements.list.filter((element) => element.onBoard && this.session.isShown(element));
  }

  /**
   * What of a view of this size the strip takes: to the right of a wide one, below a tall one; null without a board.
   * It is kept free while elements are hidden, so that the face does not jump.
   */
  place(width, height) {
    const rows = this.elements.length;
    if (!rows) return null;
    if (height > width) {
      const high = Math.min(0.32 * height, this.tall(width) + PAD);
      return { left: 0, top: height - high, width, height: high };
    }
    const wide = clamp(0.1 * width, WIDE, 1.25 * WIDE);
    const columns = Math.min(Math.ceil(this.tall(wide) / height), Math.max(1, Math.floor((0.36 * width) / wide)));
    return { left: width - columns * wide, top: 0, width: columns * wide, height };
  }

  /** Height of all rows in as many columns as a width holds. */
  tall(width) {
    const columns = Math.max(1, Math.floor(width / WIDE));
    const groups = new Set(this.elements.map(({ category }) => category)).size;
    return PAD + (groups * HEAD + this.elements.reduce((sum, element) => sum + heightOf(element), 0)) / columns + ROW;
  }

  /** Give every element of the board its cell in a rectangle of the view. */
  arrange(rect) {
    this.rect = rect;
    this.cells = new Map();
    this.headings = [];
    if (!rect) return;
    const columns = Math.max(1, Math.floor(rect.width / WIDE));
    this.room = rect.width / columns - CELL - 2.6 * PAD; // for a name
    const share = Math.max(rect.height, this.tall(rect.width));
    const at = { column: 0, top: PAD };
    const step = (height, needed = height) => {
      if (at.top + needed > share && at.column + 1 < columns) Object.assign(at, { column: at.column + 1, top: PAD });
      at.top += height;
      return { left: rect.left + (at.column * rect.width) / columns + PAD, top: rect.top + at.top - height - this.scroll };
    };
    let category = null;
    for (const element of [...this.elements].sort(inRows)) {
      if (element.category !== category || !this.cells.size) this.headings.push({ ...step(HEAD, HEAD + heightOf(element)), text: headingOf(element) });
      category = element.category;
      const height = heightOf(element);
      this.cells.set(element, { ...step(height), height, ...this.shape(element) });
    }
    this.most = Math.max(0, Math.max(0, ...[...this.cells.values()].map((cell) => cell.top + cell.height)) + this.scroll - rect.top - rect.height);
    for (const cell of this.cells.values()) cell.map = mapInto(cell);
  }

  /** An element's tracks at rest, seen from the front: offsets from its handle's place there, in scene units. */
  shape(element) {
    const { rest } = this.session;
    const { right, above } = this.front;
    const tracks = element.members.map((member) => member.track);
    const origins = element.members.map((member, m) => alongTrack(member.values, tracks[m], rest[member.control]));
    // A slider lies level, whichever way it went on the face; several axes stay as they are seen from the front.
    const long = (k) => (track) => dot(minus(track.at(-1), track[0]), [right, above][k]);
    const turn = element.axes.length > 1 ? 0 : Math.atan2(long(1)(tracks.at(-1)), long(0)(tracks.at(-1)));
    const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
    const flat = (point) => {
      const [x, y] = [dot(point, right), dot(point, above)];
      return [cosine * x + sine * y, sine * x - cosine * y];
    };
    const points = tracks.flatMap((track, m) => track.map((point) => flat(minus(point, origins[m]))));
    return { points, origin: flat(origins[0]), flat, likeness: { members: element.members, tracks, origins } };
  }

  /** An offset in scene units as it is seen from the front: to the right and down. */
  seen(offset) {
    return [dot(offset, this.front.right), -dot(offset, this.front.above)];
  }

  /** Pixels of a point of an element's tracks, as they are at rest; undefined off the board. */
  mapOf(element) {
    return this.cells.get(element)?.map;
  }

  /** An element as drags see it: with its tracks at rest. */
  heldStill(element) {
    const { tracks } = this.cells.get(element).likeness;
    return { ...element, tracks };
  }

  /** Where an element's handle is at the present values, in scene units. */
  handleOf(element) {
    const { members, tracks, origins } = this.cells.get(element).likeness;
    return this.session.elements.handleAt({ members, tracks }, this.session.values, origins);
  }

  contains(at) {
    return Boolean(this.rect) && contains(this.rect, at);
  }

  /** Scroll by pixels; false where there is nothing more. */
  scrollBy(by) {
    const before = this.scroll;
    this.scroll = clamp(this.scroll + by, 0, this.most);
    return this.scroll !== before;
  }

  draw(pen) {
    const { rect, session } = this;
    if (!rect) return;
    pen.globalAlpha = 1;
    pen.fillStyle = 'rgba(36, 39, 43, 0.96)';
    pen.fillRect(rect.left, rect.top, rect.width, rect.height);
    pen.textAlign = 'left';
    pen.font = '600 10.5px system-ui, sans-serif';
    pen.fillStyle = '#979da6';
    for (const { left, top, text } of this.headings) pen.fillText(text.toUpperCase(), left, top + 15);
    pen.font = FONT;
    for (const [element, { left, top, height }] of this.cells) {
      const marked = session.hover === element || session.selection.has(element.index);
      pen.fillStyle = marked ? '#f4f5f7' : '#b4bac2';
      pen.fillText(shortened(pen, element.label, this.room), left + CELL + PAD, top + height / 2 + 4);
    }
    if (this.most > 0) this.drawBar(pen);
  }

  drawBar(pen) {
    const { rect, most, scroll } = this;
    const length = (rect.height * rect.height) / (rect.height + most);
    pen.fillStyle = 'rgba(255, 255, 255, 0.25)';
    pen.fillRect(rect.left + rect.width - 4, rect.top + (scroll / most) * (rect.height - length), 3, length);
  }
}

/** The heading under which an element stands on the board. */
export const headingOf = (element) => (element.category && element.heading) || 'Off the face';

const FINGERS = globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;
const heightOf = (element) => (element.axes.length > 1 ? SQUARE : FINGERS ? FINGER : ROW);
/** Rows in the order of the layer's board; words of other tools come last, each by itself. */
export const inRows = (a, b) => a.rank - b.rank || Number(a.category > b.category) - Number(a.category < b.category) || a.index - b.index;

/** From scene units to the pixels of a cell: the tracks' box in its middle, as large as it goes. */
function mapInto({ left, top, height, points, origin, flat }) {
  const span = (axis) => [Math.min(0, ...points.map((point) => point[axis])), Math.max(0, ...points.map((point) => point[axis]))];
  const [[x0, x1], [y0, y1]] = [span(0), span(1)];
  const room = Math.min(CELL - 12, height === SQUARE ? height - 14 : CELL);
  const scale = Math.min(room / Math.max(x1 - x0, 1e-12), (height === SQUARE ? room : CELL) / Math.max(y1 - y0, 1e-12), 1e12);
  const [cx, cy] = [left + CELL / 2 - (scale * (x0 + x1)) / 2, top + height / 2 - (scale * (y0 + y1)) / 2];
  return (point) => {
    const [x, y] = flat(point);
    return [cx + scale * (x - origin[0]), cy + scale * (y - origin[1]), 1];
  };
}

/** A text cut to a width in the middle, so that its last word, mostly a side, stays; '' where nothing fits. */
function shortened(pen, text, width) {
  if (pen.measureText(text).width <= width) return text;
  for (const end of [lastWord(text), '']) {
    let kept = text.length - end.length - 1;
    while (kept > 1 && pen.measureText(`${text.slice(0, kept)}…${end}`).width > width) kept--;
    if (kept > 1) return `${text.slice(0, kept)}…${end}`;
  }
  return '';
}
