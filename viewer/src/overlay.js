// Tracks, handles, labels and marks, drawn on a plain canvas above the picture: crisp at any resolution,
// and half-hidden parts can be shown as ghosts.

import { Arrangement, BADGE } from './arrangement.js';
import { covering, placed } from './dom.js';

const AFFECTED = '#5fd6ff';
const FAINT = 0.22; // strength below which elements are drawn without dark rims and halves, which nobody would see
const AROUND = 40; // pixels that handles, badges, pins and halos reach beyond their places

export class Overlay extends Arrangement {
  constructor(canvas, session) {
    super(session);
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    this.marquee = null;
    this.placing = null;
  }

  resize(width, height, ratio) {
    this.ratio = ratio;
    this.width = width;
    this.height = height;
    this.box = null;
  }

  /** `strokes` of a review lie over all, `trails` (trails.js) over the handles. */
  draw(strokes = [], trails = []) {
    const { pen, session } = this;
    this.cover(strokes, trails);
    pen.clearRect(0, 0, this.width, this.height);
    if (session.options.handles && this.column) {
      this.clipTo(this.column);
      const order = this.drawn.filter(({ element }) => !element.onBoard).sort((a, b) => b.handle[2] - a.handle[2]);
      this.drawElements(order);
      trails.forEach((trail) => this.drawTrail(trail));
      if (session.options.labels === 'all') this.drawLabels(order);
      pen.restore();
      if (this.dock.rect) this.drawDock();
    }
    this.drawPins();
    strokes.forEach((points) => this.drawStroke(points));
    this.drawPlacing();
    if (this.marquee) this.drawMarquee(this.marquee);
  }

  /** Let the canvas cover what is to be drawn and no more: what is empty takes time to show too. */
  cover(strokes, trails) {
    const { canvas, pen, ratio } = this;
    const box = covering(this.reach(strokes, trails), this.box, [this.width, this.height]);
    if (box === this.box) return;
    this.box = box;
    canvas.width = Math.round((box[2] - box[0]) * ratio);
    canvas.height = Math.round((box[3] - box[1]) * ratio);
    placed(canvas, box);
    pen.setTransform(ratio, 0, 0, ratio, -box[0] * ratio, -box[1] * ratio);
  }

  /** [left, top, right, bottom] around all that is drawn. */
  reach(strokes, trails) {
    const { session, dock } = this;
    if (strokes.length || this.marquee || this.placing || session.options.labels === 'all') return [0, 0, this.width, this.height];
    const shown = session.options.handles ? this.drawn : [];
    const strip = session.options.handles && dock.rect;
    const ends = strip ? [[strip.left, strip.top], [strip.left + strip.width, strip.top + strip.height]] : [];
    let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
    const extend = ([x, y]) => {
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < top) top = y;
      if (y > bottom) bottom = y;
    };
    [...ends, ...(this.pinned ?? []), ...trails.flatMap(({ places }) => places.map(({ at }) => at))].forEach(extend);
    for (const { element, handle, home, tracks, origin, corners } of shown) {
      const about = (from, factor) => ([x, y]) => extend([from[0] + factor * (x - from[0]), from[1] + factor * (y - from[1])]);
      const onTrack = about(origin, element.axes.length > 1 ? 2 : 1); // patches reach as far as two tracks together
      tracks.forEach((track) => track.forEach(({ at }) => onTrack(at)));
      corners?.forEach(about(handle, 1.3 * this.enlarged));
      extend(handle);
      if (home) extend(home);
    }
    return [left - AROUND, top - AROUND, right + AROUND, bottom + AROUND];
  }

  drawElements(order) {
    for (const part of ['drawLeader', 'drawTracks', 'drawHandle', 'drawBadge']) order.forEach((each) => this[part](each));
  }

  drawDock() {
    this.clipTo(this.dock.rect);
    this.dock.draw(this.pen);
    this.drawElements(this.drawn.filter(({ element }) => element.onBoard));
    this.pen.restore();
  }

  /** From a handle that the lens has moved to its place on the skin. */
  drawLeader({ element, home, handle, hidden }) {
    if (!home || Math.hypot(home[0] - handle[0], home[1] - handle[1]) < 3) return;
    this.pen.globalAlpha = 0.5 * this.strength(element, hidden);
    lines(this.pen, [home, handle]);
    stroke(this.pen, 1, '#f4f5f7');
  }

  /** The sign of a second level: plus at what can be opened, minus at the members of what is open. */
  drawBadge(drawn) {
    const at = this.badgeOf(drawn);
    if (!at) return;
    const { pen } = this;
    const strength = this.strength(drawn.element, drawn.hidden);
    if (strength < 0.3) return;
    const [x, y] = at;
    const [across, down] = [[[x - 3, y], [x + 3, y]], [[x, y - 3], [x, y + 3]]];
    pen.globalAlpha = strength;
    disc(pen, at, BADGE, '#f4f5f7');
    lines(pen, across, ...(drawn.element.inner.length ? [down] : []));
    stroke(pen, 1.6, '#16181b');
    pen.globalAlpha = 1;
  }

  clipTo({ left, top, width, height }) {
    this.pen.save();
    this.pen.beginPath();
    this.pen.rect(left, top, width, height);
    this.pen.clip();
  }

  // --- elements --------------------------------------------------------------------------------------

  /** How strongly an element is drawn: options, what is being dragged, what is covered. */
  strength(element, covered) {
    const { session } = this;
    const { opacity, fade, occlusion } = session.options;
    const busy = session.dragging;
    const involved =
      session.selection.has(element.index) || session.hover === element || this.affectedShare(element) > 0;
    let strength = opacity;
    if (fade && busy && busy !== element && !involved) strength *= 0.18;
    if (covered && occlusion !== 'overlay') strength *= occlusion === 'ghost' ? 0.2 : 0;
    return strength;
  }

  affectedShare(element) {
    return element.members.reduce((most, { control }) => Math.max(most, this.session.affected.get(control) ?? 0), 0);
  }

  colour(element) {
    return this.affectedShare(element) > 0 && this.session.dragging === 'skin' ? AFFECTED : this.session.colours[element.side];
  }

  drawTracks(drawn) {
    const { element, tracks } = drawn;
    const { pen, session } = this;
    const marked = session.selection.has(element.index) || session.hover === element;
    const colour = this.colour(element);
    if (element.axes.length > 1) this.drawPatch(drawn, colour, marked);
    Object.assign(pen, { lineCap: 'round', lineJoin: 'round' });
    const faint = this.strength(element, false) < FAINT;
    tracks.forEach((track) => {
      if (!faint) this.strokeRuns(element, track, '#14161a', marked ? 5.5 : 4, 0.55);
      this.strokeRuns(element, track, colour, marked ? 3 : 1.9, 0.95);
    });
    tracks.forEach((track) => this.drawEnd(element, track.at(-1), colour));
    pen.globalAlpha = 1;
  }

  /** Stroke a track run by run, so that covered stretches are drawn fainter. */
  strokeRuns(element, track, colour, width, alpha) {
    const { pen } = this;
    let i = 0;
    while (i + 1 < track.length) {
      const covered = track[i].covered && track[i + 1].covered;
      pen.globalAlpha = alpha * this.strength(element, covered);
      const run = [track[i].at];
      do run.push(track[++i].at);
      while (i + 1 < track.length && (track[i].covered && track[i + 1].covered) === covered);
      lines(pen, run);
      if (pen.globalAlpha > 0) stroke(pen, width, colour);
    }
  }

  drawEnd(element, { at, covered }, colour) {
    this.pen.globalAlpha = 0.9 * this.strength(element, covered);
    disc(this.pen, at, 2.2, colour);
  }

  /** The area that a two-axis element spans, or the sectors of a fan. */
  drawPatch({ element, tracks, origin, hidden }, colour, marked) {
    const { pen } = this;
    const ends = element.axes.map((members) => {
      const far = tracks[members.at(-1)].at(-1).at;
      const near = members.length > 1 ? tracks[members[0]].at(-1).at : tracks[members[0]][0].at;
      return [near, far].map((end) => [end[0] - origin[0], end[1] - origin[1]]);
    });
    pen.globalAlpha = (marked ? 0.3 : 0.16) * this.strength(element, hidden);
    pen.fillStyle = colour;
    const ordered = ends.length > 2 ? byAngle(ends) : ends;
    const count = ends.length > 2 ? ordered.length : 1;
    for (let k = 0; k < count; k++) {
      const [a, b] = [ordered[k], ordered[(k + 1) % ordered.length]];
      if (count > 1 && turn(a[1], b[1]) > Math.PI + 1e-6) continue;
      lines(pen, [[0, 0], [1, 0], [1, 1], [0, 1]].map(([i, j]) => [0, 1].map((axis) => origin[axis] + a[i][axis] + b[j][axis])));
      pen.fill();
    }
  }

  drawHandle(drawn) {
    const { element, handle, width, hidden } = drawn;
    const { pen, session } = this;
    const strength = this.strength(element, hidden);
    if (strength <= 0 || handle[2] <= 0) return;
    const [x, y] = handle;
    const hover = session.hover === element;
    const selected = session.selection.has(element.index);
    const moved = element.members.some(({ control }) => session.values[control] !== session.rest[control]);
    const locked = element.members.every(({ control }) => session.locks.has(control));
    const radius = (width / 2) * (hover ? 1.22 : 1);
    pen.globalAlpha = strength;
    const inside = moved ? this.colour(element) : '#2a2d32';
    const rim = selected ? '#ffffff' : this.colour(element);
    if (element.glyph) this.drawGlyph(drawn, inside, rim, (selected ? 2.6 : 1.8) + (moved ? 0.8 : 0), hover ? 1.22 : 1);
    else {
      pen.beginPath();
      outline(pen, element.axes.length, x, y, radius);
      if (strength >= FAINT) stroke(pen, 4, 'rgba(15, 17, 20, 0.75)');
      pen.fillStyle = inside;
      pen.fill();
      if (!moved && strength >= FAINT) this.fillHalf(element, x, y, radius);
      stroke(pen, selected ? 2.6 : 1.8, rim);
    }
    if (locked) drawCross(pen, x, y, radius * 0.5, moved ? '#16181b' : this.colour(element));
    if (hover || selected) this.drawHalo(element, x, y, radius + 4.5, selected && !hover ? 0.35 : 0.7);
    pen.globalAlpha = 1;
  }

  /** Side is not told by colour alone: half of a handle is filled, toward the character's own side. */
  fillHalf(element, x, y, radius) {
    const way = { left: this.leftward, right: -this.leftward }[element.side];
    if (!way) return;
    const { pen } = this;
    pen.save();
    pen.clip();
    pen.fillStyle = this.session.colours[element.side];
    pen.fillRect(way > 0 ? x : x - 2 * radius, y - 2 * radius, 2 * radius, 4 * radius);
    pen.restore();
    pen.beginPath();
    outline(pen, element.axes.length, x, y, radius);
  }

  /** A custom handle: lines, or faces within a rim; as much larger as small handles are drawn larger than they are. */
  drawGlyph({ element, handle, corners }, inside, rim, width, larger) {
    const { pen } = this;
    const { parts, closed } = element.glyph;
    const enlarged = this.enlarged * larger;
    const at = (corner) => [0, 1].map((axis) => handle[axis] + enlarged * (corners[corner][axis] - handle[axis]));
    const paths = parts.map((part) => {
      const path = new Path2D();
      for (const [x, y] of part.map(at)) path.lineTo(x, y);
      if (closed) path.closePath();
      return path;
    });
    const line = (wide, colour) => paths.forEach((path) => stroke(pen, wide, colour, path));
    line(closed ? 2 * width + 2 : width + 2.2, 'rgba(15, 17, 20, 0.75)');
    line(closed ? 2 * width : width, rim);
    if (!closed) return;
    pen.fillStyle = inside;
    for (const path of paths) pen.fill(path);
    line(0.7, inside);
  }

  drawHalo(element, x, y, radius, alpha) {
    const { pen } = this;
    pen.globalAlpha = alpha;
    pen.beginPath();
    outline(pen, element.axes.length, x, y, radius);
    stroke(pen, 1.4, '#ffffff');
  }

  /** Labels of all visible handles, left out where they would cover one another. */
  drawLabels(order) {
    const { pen } = this;
    const taken = [];
    pen.font = '11px system-ui, sans-serif';
    pen.textAlign = 'left';
    for (const { element, handle, width, hidden } of [...order].reverse()) {
      const strength = this.strength(element, hidden);
      if (strength < 0.3 || element.onBoard) continue;
      const text = element.label;
      const box = [handle[0] + width / 2 + 5, handle[1] - 7, pen.measureText(text).width + 10, 14];
      if (taken.some((other) => overlapping(box, other))) continue;
      taken.push(box);
      pen.globalAlpha = 0.72 * strength;
      pen.fillStyle = '#17191c';
      pen.fillRect(...box);
      pen.globalAlpha = strength;
      pen.fillStyle = this.session.colours[element.side];
      pen.fillRect(box[0], box[1], 3, box[3]); // words are never in the colour of a mark, which is hard to read
      pen.fillStyle = '#f4f5f7';
      pen.fillText(text, box[0] + 6, box[1] + 11);
    }
    pen.globalAlpha = 1;
  }

  // --- marks -----------------------------------------------------------------------------------------

  drawPins() {
    const { pen } = this;
    for (const [x, y, depth] of this.pinned ?? []) {
      if (depth <= 0) continue;
      lines(pen, [[x, y], [x + 5, y - 13]]);
      stroke(pen, 3.5, '#14161a');
      stroke(pen, 1.6, '#f2f3f5');
      disc(pen, [x + 5.5, y - 15], 4.5, '#f08c4b');
      pen.stroke();
    }
  }

  /** Where a rearranged element would go: its ghost on a line from its old place. */
  drawPlacing() {
    if (!this.placing) return;
    const { pen } = this;
    const { from, to, free, refused } = this.placing;
    pen.setLineDash([4, 4]);
    lines(pen, [from, to]);
    stroke(pen, 1.5, refused ? this.session.colours.right : free ? '#9aa0a8' : '#7ee787');
    pen.setLineDash([]);
    pen.beginPath();
    pen.arc(to[0], to[1], 8, 0, 7);
    pen.stroke();
  }

  /** The way of a handle: a tick at every frame, a larger dot at a key, a white one at the present frame. */
  drawTrail({ colour: side, places }) {
    const { pen, session } = this;
    const before = places.filter(({ at }) => at[2] > 0);
    const now = before.findLast(({ frame }) => frame <= session.frame);
    Object.assign(pen, { globalAlpha: 1, lineCap: 'round', lineJoin: 'round' });
    lines(pen, before.map(({ at }) => at));
    stroke(pen, 4, '#14161a');
    stroke(pen, 2, side);
    const [ticks, keys] = [false, true].map((kind) => before.filter(({ isKey }) => isKey === kind));
    for (const place of [...ticks, ...keys, ...(now ? [now] : [])]) {
      const [radius, colour] = place === now ? [4.5, '#ffffff'] : place.isKey ? [4, '#f0a94b'] : [1.5, '#f4f5f7'];
      disc(pen, place.at, radius, colour);
      if (radius > 2) stroke(pen, 1.5, '#14161a');
    }
  }

  drawMarquee([x0, y0, x1, y1]) {
    const { pen } = this;
    pen.fillStyle = 'rgba(120, 170, 255, 0.12)';
    pen.strokeStyle = 'rgba(150, 190, 255, 0.9)';
    pen.lineWidth = 1;
    pen.fillRect(x0, y0, x1 - x0, y1 - y0);
    pen.strokeRect(x0 + 0.5, y0 + 0.5, x1 - x0, y1 - y0);
  }

  drawStroke(points) {
    const { pen } = this;
    Object.assign(pen, { lineCap: 'round', lineJoin: 'round' });
    lines(pen, [...points, points.at(-1)]); // a dot has one
    stroke(pen, 5.5, '#14161a');
    stroke(pen, 3, '#f0a94b');
  }
}

/** Begin a path with lines, each through points of its own. @param {number[][][]} all */
function lines(pen, ...all) {
  pen.beginPath();
  for (const points of all) points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
}

/** @param {Path2D | null} [path] in place of the one begun */
function stroke(pen, lineWidth, strokeStyle, path = null) {
  Object.assign(pen, { lineWidth, strokeStyle });
  if (path) pen.stroke(path);
  else pen.stroke();
}

function disc(pen, at, radius, fillStyle) {
  pen.beginPath();
  pen.arc(at[0], at[1], radius, 0, 7);
  pen.fillStyle = fillStyle;
  pen.fill();
}

/** Circle for one axis, diamond for two, triangle for a fan. */
function outline(pen, axes, x, y, radius) {
  if (axes === 1) pen.arc(x, y, radius, 0, 7);
  else {
    const count = axes === 2 ? 4 : 3;
    const reach = radius * (axes === 2 ? 1.25 : 1.4);
    for (let k = 0; k < count; k++) {
      const angle = -Math.PI / 2 + (2 * Math.PI * k) / count;
      pen.lineTo(x + reach * Math.cos(angle), y + reach * Math.sin(angle));
    }
  }
  pen.closePath();
}

function drawCross(pen, x, y, reach, colour) {
  lines(pen, [[x - reach, y - reach], [x + reach, y + reach]], [[x + reach, y - reach], [x - reach, y + reach]]);
  stroke(pen, 1.8, colour);
}

const overlapping = (a, b) => a[0] < b[0] + b[2] && b[0] < a[0] + a[2] && a[1] < b[1] + b[3] && b[1] < a[1] + a[3];
const angleOf = ([x, y]) => Math.atan2(y, x);
const byAngle = (ends) => [...ends].sort((a, b) => angleOf(a[1]) - angleOf(b[1]));
const turn = (a, b) => (angleOf(b) - angleOf(a) + 2 * Math.PI) % (2 * Math.PI);
