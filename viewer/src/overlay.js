// Tracks, handles, labels and marks, drawn on a plain canvas above the picture: crisp at any resolution,
// and half-hidden parts can be shown as ghosts.

import { lastWord } from './dom.js';
import { alongTrack } from './elements.js';

// As in pictures (`usdrigui/view/overlay.py`, docs/decisions/114).
export const COLOURS = { left: '#4da3ff', right: '#f21420', middle: '#bcf000', none: '#7a5cff' };
const AFFECTED = '#5fd6ff';
const LEAST_HANDLE = 9;
const MOST_HANDLE = 22;
const BESIDE_FONT = '11px system-ui, sans-serif';

export class Overlay {
  constructor(canvas, session) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    this.session = session;
    this.marquee = null;
    this.placing = null;
  }

  resize(width, height, ratio) {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.ratio = ratio;
    this.width = width;
    this.height = height;
  }

  /**
   * Project all elements into a column; call when pose or camera have changed.  `hides` tells whether the
   * skin covers a projected point; null keeps what was covered before (while dragging).
   */
  arrange(column, camera, hides) {
    const { session } = this;
    const project = camera.projector(column);
    const perUnit = 1 / camera.pixelSize(column.height);
    const width = Math.min(MOST_HANDLE, Math.max(LEAST_HANDLE, session.elements.width * perUnit));
    this.enlarged = width / (session.elements.width * perUnit);
    const before = new Map((this.drawn ?? []).map((each) => [each.element, each]));
    this.drawn = session.elements.list
      .filter((element) => session.isShown(element))
      .map((element) => {
        const away = hides && this.facesAway(element, camera);
        return this.arranged(element, project, away ? () => true : hides, width, before.get(element));
      });
    this.names = this.families(this.drawn);
    this.pinned = session.pins.map((pin) => project(session.shown(pin)));
    this.column = column;
    this.leftward = Math.sign(session.character.layout.planeNormal.reduce((sum, value, axis) => sum + value * camera.right[axis], 0));
  }

  /** True when an element on the face is seen from behind, which no depth tells where the skin is a thin sheet. */
  facesAway(element, { towards }) {
    const { occlusion } = this.session.options;
    const facing = element.normal.reduce((sum, value, axis) => sum + value * towards[axis], 0);
    return occlusion !== 'overlay' && !element.onBoard && facing < -0.2;
  }

  arranged(element, project, hides, width, before) {
    const handle = project(element.handle);
    const tracks = element.tracks.map((track, m) => {
      const kept = hides ? null : before?.tracks[m];
      return this.screenTrack(element.members[m], track, project, (at, k) => hides?.(at) ?? kept?.[k]?.covered ?? false);
    });
    const hidden = hides ? hides(handle) && mostlyCovered(tracks) : (before?.hidden ?? false);
    const corners = element.glyph && element.outline.map(project);
    return { element, handle, tracks, width, hidden, corners, origin: project(element.origin) };
  }

  /** Corners of the drawn track between minimum and maximum, each with whether it is covered. */
  screenTrack(member, track, project, hides) {
    const { minimum, maximum } = this.session.controls[member.control];
    const inside = member.values.filter((value) => value > minimum && value < maximum);
    const knots = [minimum, ...inside, maximum];
    const fine = knots.flatMap((knot, i) => {
      const next = knots[i + 1];
      return next === undefined ? [knot] : [0, 1, 2, 3].map((k) => knot + (k / 4) * (next - knot));
    });
    return fine.map((value, k) => {
      const at = project(alongTrack(member.values, track, value));
      return { at, covered: hides(at, k) };
    });
  }

  /** Headings of the groups beside the face: above the first element of each family. */
  families(drawn) {
    const groups = new Map();
    for (const { element, handle, tracks } of drawn) {
      if (!element.onBoard || !element.category) continue;
      const corners = [handle, ...tracks.flatMap((track) => track.map(({ at }) => at))];
      const left = Math.min(...corners.map(([x]) => x));
      const top = Math.min(...corners.map(([, y]) => y));
      if (!groups.has(element.category)) groups.set(element.category, { left, top });
    }
    return groups;
  }

  draw() {
    const { pen, session, ratio } = this;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, this.width, this.height);
    if (session.options.handles && this.drawn) {
      this.clipTo(this.column);
      const order = [...this.drawn].sort((a, b) => b.handle[2] - a.handle[2]);
      order.forEach((each) => this.drawTracks(each));
      order.forEach((each) => this.drawHandle(each));
      this.drawFamilies();
      this.drawBesideLabels();
      if (session.options.labels === 'all') this.drawLabels(order);
      pen.restore();
    }
    this.drawPins();
    this.drawPlacing();
    if (this.marquee) this.drawMarquee(this.marquee);
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
    return this.affectedShare(element) > 0 && this.session.dragging === 'skin' ? AFFECTED : COLOURS[element.side];
  }

  drawTracks(drawn) {
    const { element, tracks } = drawn;
    const { pen, session } = this;
    const marked = session.selection.has(element.index) || session.hover === element;
    const colour = this.colour(element);
    if (element.axes.length > 1) this.drawPatch(drawn, colour, marked);
    pen.lineCap = 'round';
    pen.lineJoin = 'round';
    tracks.forEach((track) => {
      this.strokeRuns(element, track, '#14161a', marked ? 5.5 : 4, 0.55);
      this.strokeRuns(element, track, colour, marked ? 3 : 1.9, 0.95);
    });
    tracks.forEach((track) => this.drawEnd(element, track.at(-1), colour));
    pen.globalAlpha = 1;
  }

  /** Stroke a track run by run, so that covered stretches are drawn fainter. */
  strokeRuns(element, track, colour, width, alpha) {
    const { pen } = this;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    let i = 0;
    while (i + 1 < track.length) {
      const covered = track[i].covered && track[i + 1].covered;
      pen.globalAlpha = alpha * this.strength(element, covered);
      pen.beginPath();
      pen.moveTo(track[i].at[0], track[i].at[1]);
      do {
        i++;
        pen.lineTo(track[i].at[0], track[i].at[1]);
      } while (i + 1 < track.length && (track[i].covered && track[i + 1].covered) === covered);
      if (pen.globalAlpha > 0) pen.stroke();
    }
  }

  drawEnd(element, { at, covered }, colour) {
    const { pen } = this;
    pen.globalAlpha = 0.9 * this.strength(element, covered);
    pen.fillStyle = colour;
    pen.beginPath();
    pen.arc(at[0], at[1], 2.2, 0, 7);
    pen.fill();
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
      pen.beginPath();
      for (const [i, j] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
        pen.lineTo(origin[0] + a[i][0] + b[j][0], origin[1] + a[i][1] + b[j][1]);
      }
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
      pen.lineWidth = 4;
      pen.strokeStyle = 'rgba(15, 17, 20, 0.75)';
      pen.stroke();
      pen.fillStyle = inside;
      pen.fill();
      if (!moved) this.fillHalf(element, x, y, radius);
      pen.lineWidth = selected ? 2.6 : 1.8;
      pen.strokeStyle = rim;
      pen.stroke();
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
    pen.fillStyle = COLOURS[element.side];
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
    const stroke = (lineWidth, strokeStyle) => {
      Object.assign(pen, { lineWidth, strokeStyle });
      for (const path of paths) pen.stroke(path);
    };
    stroke(closed ? 2 * width + 2 : width + 2.2, 'rgba(15, 17, 20, 0.75)');
    stroke(closed ? 2 * width : width, rim);
    if (!closed) return;
    pen.fillStyle = inside;
    for (const path of paths) pen.fill(path);
    stroke(0.7, inside);
  }

  drawHalo(element, x, y, radius, alpha) {
    const { pen } = this;
    pen.globalAlpha = alpha;
    pen.lineWidth = 1.4;
    pen.strokeStyle = '#ffffff';
    pen.beginPath();
    outline(pen, element.axes.length, x, y, radius);
    pen.stroke();
  }

  drawFamilies() {
    const { pen } = this;
    pen.font = '600 11px system-ui, sans-serif';
    pen.textAlign = 'left';
    pen.fillStyle = '#9aa0a8';
    const rows = this.drawn.filter(({ element }) => element.onBoard);
    for (const [family, { left, top }] of this.names) {
      // Seen from afar there is no room between the rows of the board for its headings.
      const taken = rows.some(({ element, handle }) => element.category !== family && Math.abs(handle[1] - top + 20) < 12);
      if (taken) continue;
      pen.globalAlpha = 0.9 * this.session.options.opacity;
      pen.fillText(familyName(family).toUpperCase(), left - 6, top - 16);
    }
    pen.globalAlpha = 1;
  }

  /** Pixels across that the name of an element on the board takes. */
  labelWidth(text) {
    this.pen.font = BESIDE_FONT;
    return this.pen.measureText(text).width;
  }

  /** Names of the elements on the board, whose place does not tell what they do. */
  drawBesideLabels() {
    const { pen, session } = this;
    const rows = this.drawn.filter(({ element, handle }) => element.onBoard && handle[2] > 0);
    pen.font = BESIDE_FONT;
    pen.textAlign = 'left';
    const extents = rows.map(({ handle, tracks }) => {
      const xs = [handle[0], ...tracks.flatMap((track) => track.map(({ at }) => at[0]))];
      return { left: Math.min(...xs) - 7, right: Math.max(...xs) + 9 };
    });
    for (const [i, { element, handle, tracks }] of rows.entries()) {
      const x = extents[i].right;
      const y = element.axes.length > 1 ? handle[1] : tracks[0][0].at[1];
      const next = rows.reduce((least, other, k) => {
        const level = Math.abs(other.handle[1] - y) < 12 && extents[k].left > x;
        return level ? Math.min(least, extents[k].left) : least;
      }, this.column.left + this.column.width - 4);
      const marked = session.hover === element || session.selection.has(element.index);
      pen.globalAlpha = (marked ? 1 : 0.75) * this.strength(element, false);
      pen.fillStyle = marked ? '#f4f5f7' : '#b4bac2';
      pen.fillText(shortened(pen, element.label, next - x), x, y + 4);
    }
    pen.globalAlpha = 1;
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
      const box = [handle[0] + width / 2 + 5, handle[1] - 7, pen.measureText(text).width + 8, 14];
      if (taken.some((other) => overlapping(box, other))) continue;
      taken.push(box);
      pen.globalAlpha = 0.72 * strength;
      pen.fillStyle = '#17191c';
      pen.fillRect(...box);
      pen.globalAlpha = strength;
      pen.fillStyle = COLOURS[element.side];
      pen.fillText(text, box[0] + 4, box[1] + 11);
    }
    pen.globalAlpha = 1;
  }

  // --- marks -----------------------------------------------------------------------------------------

  drawPins() {
    const { pen } = this;
    for (const [x, y, depth] of this.pinned ?? []) {
      if (depth <= 0) continue;
      pen.lineWidth = 3.5;
      pen.strokeStyle = '#14161a';
      pen.beginPath();
      pen.moveTo(x, y);
      pen.lineTo(x + 5, y - 13);
      pen.stroke();
      pen.lineWidth = 1.6;
      pen.strokeStyle = '#f2f3f5';
      pen.stroke();
      pen.beginPath();
      pen.arc(x + 5.5, y - 15, 4.5, 0, 7);
      pen.fillStyle = '#f08c4b';
      pen.fill();
      pen.stroke();
    }
  }

  /** Where a rearranged element would go: its ghost on a line from its old place. */
  drawPlacing() {
    if (!this.placing) return;
    const { pen } = this;
    const { from, to, free, refused } = this.placing;
    pen.setLineDash([4, 4]);
    pen.lineWidth = 1.5;
    pen.strokeStyle = refused ? COLOURS.right : free ? '#9aa0a8' : '#7ee787';
    pen.beginPath();
    pen.moveTo(from[0], from[1]);
    pen.lineTo(to[0], to[1]);
    pen.stroke();
    pen.setLineDash([]);
    pen.beginPath();
    pen.arc(to[0], to[1], 8, 0, 7);
    pen.stroke();
  }

  drawMarquee([x0, y0, x1, y1]) {
    const { pen } = this;
    pen.fillStyle = 'rgba(120, 170, 255, 0.12)';
    pen.strokeStyle = 'rgba(150, 190, 255, 0.9)';
    pen.lineWidth = 1;
    pen.fillRect(x0, y0, x1 - x0, y1 - y0);
    pen.strokeRect(x0 + 0.5, y0 + 0.5, x1 - x0, y1 - y0);
  }

  // --- picking ---------------------------------------------------------------------------------------

  /** The element whose handle is nearest to (x, y) and within reach; covered handles only when drawn. */
  elementAt(x, y) {
    const { session } = this;
    if (!session.options.handles || !this.drawn) return null;
    let best = null;
    for (const { element, handle, width, hidden } of this.drawn) {
      if (handle[2] <= 0 || (hidden && session.options.occlusion !== 'overlay')) continue;
      const off = Math.hypot(handle[0] - x, handle[1] - y);
      if (off <= width / 2 + 4 && (!best || off < best.off)) best = { element, off };
    }
    return best?.element ?? null;
  }

  pinAt(x, y) {
    const index = (this.pinned ?? []).findIndex((pin) => Math.hypot(pin[0] + 5 - x, pin[1] - 15 - y) < 9);
    return index < 0 ? null : this.session.pins[index];
  }

  elementsIn([x0, y0, x1, y1]) {
    const inside = ([x, y]) => x >= Math.min(x0, x1) && x <= Math.max(x0, x1) && y >= Math.min(y0, y1) && y <= Math.max(y0, y1);
    const overlay = this.session.options.occlusion === 'overlay';
    return (this.drawn ?? []).filter((each) => inside(each.handle) && (overlay || !each.hidden)).map((each) => each.element);
  }
}

/** As in pictures (`usdrigui/view/lettering.py`). */
const FAMILIES = {
  global: 'Whole character',
  hidden: 'Hidden',
  interior: 'Inside the mouth',
  composite: 'Composite',
  viseme: 'Visemes',
  emotion: 'Emotions',
  combination: 'Combinations',
  identity: 'Identity',
  requested: 'By request',
  crowded: 'No room on the face',
};

/** The heading of a family of elements on the board. */
export const familyName = (family) => FAMILIES[family] ?? (family || 'Beside the face');

/** A handle behind a fold of the skin whose track can be seen is still within reach. */
function mostlyCovered(tracks) {
  const corners = tracks.flat();
  return corners.filter(({ covered }) => covered).length > 0.6 * corners.length;
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
  pen.lineWidth = 1.8;
  pen.strokeStyle = colour;
  pen.beginPath();
  pen.moveTo(x - reach, y - reach);
  pen.lineTo(x + reach, y + reach);
  pen.moveTo(x + reach, y - reach);
  pen.lineTo(x - reach, y + reach);
  pen.stroke();
}

const overlapping = (a, b) => a[0] < b[0] + b[2] && b[0] < a[0] + a[2] && a[1] < b[1] + b[3] && b[1] < a[1] + a[3];
const angleOf = ([x, y]) => Math.atan2(y, x);
const byAngle = (ends) => [...ends].sort((a, b) => angleOf(a[1]) - angleOf(b[1]));
const turn = (a, b) => (angleOf(b) - angleOf(a) + 2 * Math.PI) % (2 * Math.PI);
