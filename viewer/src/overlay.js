// Tracks, handles, labels and marks, drawn on a plain canvas above the picture: crisp at any resolution,
// and half-hidden parts can be shown as ghosts.

import { Dock } from './dock.js';
import { covering, placed } from './dom.js';
import { alongTrack } from './elements.js';
import { lensAt } from './spread.js';

const AFFECTED = '#5fd6ff';
const LEAST_HANDLE = 11;
const MOST_HANDLE = 22;
const LEAST_TRACK = 30; // pixels: shorter tracks are drawn longer, and moved so
const MOST_GAIN = 8;
const STAY = 2; // least distances that the pointer may go before the lens comes after it
const FAINT = 0.22; // strength below which elements are drawn without dark rims and halves, which nobody would see
const AROUND = 40; // pixels that handles, badges, pins and halos reach beyond their places
const BADGE = 6; // pixels of the sign at a coarse element, and at its open members
export const FINGER = 44; // pixels that fingertips need

export class Overlay {
  constructor(canvas, session) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d');
    this.session = session;
    this.marquee = null;
    this.placing = null;
    this.dock = new Dock(session);
    this.lens = null;
    this.look = '';
    this.magnifications = new Map();
  }

  resize(width, height, ratio) {
    this.ratio = ratio;
    this.width = width;
    this.height = height;
    this.box = null;
  }

  /**
   * Project all elements into a column, and those of the board into its strip; call when pose or camera have changed.
   * `hides` tells whether the skin covers a projected point; null keeps what was covered, how much tracks are
   * lengthened and what the lens has moved, as they were (while dragging).
   */
  arrange(column, camera, hides) {
    const { session } = this;
    const project = camera.projector(column);
    const perUnit = 1 / camera.pixelSize(column.height);
    const width = Math.min(MOST_HANDLE, Math.max(LEAST_HANDLE, session.elements.width * perUnit));
    this.enlarged = width / (session.elements.width * perUnit);
    const before = new Map((this.drawn ?? []).map((each) => [each.element, each]));
    if (hides) this.magnifications = new Map();
    const { azimuth, elevation, distance, target } = camera;
    const look = [azimuth, elevation, distance, ...target, column.left, column.width, column.height].join();
    if (look !== this.look) this.lens = null; // it stood over other places
    this.look = look;
    this.drawn = session.elements.list
      .filter((element) => session.isShown(element) && (!element.onBoard || this.dock.mapOf(element)))
      .map((element) => {
        if (element.onBoard) return this.docked(element);
        const away = hides && this.facesAway(element, camera);
        return this.arranged(element, project, away ? () => true : hides, width, before.get(element));
      });
    this.pinned = session.pins.map((pin) => project(session.shown(pin)));
    this.column = column;
    this.leftward = Math.sign(session.character.layout.planeNormal.reduce((sum, value, axis) => sum + value * camera.right[axis], 0));
    if (this.lens) this.shift();
  }

  /** From an element's scene units to pixels: a short track is lengthened about the place of its handle at rest. */
  mapOf(element, project) {
    const origin = project(element.origin);
    if (!this.magnifications.has(element)) this.magnifications.set(element, magnificationOf(element.tracks.map((track) => track.map(project))));
    const magnification = this.magnifications.get(element);
    const [dx, dy] = this.lens?.offsets.get(element) ?? [0, 0];
    return (point) => {
      const [x, y, depth] = project(point);
      return [origin[0] + magnification * (x - origin[0]) + dx, origin[1] + magnification * (y - origin[1]) + dy, depth];
    };
  }

  /** What `beginDrag` needs: an element and the map of its points to pixels. */
  draggable(element, project) {
    const map = this.dock.mapOf(element);
    return element.onBoard && map ? [this.dock.heldStill(element), map] : [element, this.mapOf(element, project)];
  }

  docked(element) {
    const map = this.dock.mapOf(element);
    const { tracks } = this.dock.heldStill(element);
    const screen = element.members.map((member, m) => this.screenTrack(member, tracks[m], map, () => false));
    const at = this.dock.handleOf(element);
    const still = element.members[0];
    const origin = map(alongTrack(still.values, tracks[0], this.session.rest[still.control]));
    const [handle, width] = [map(at), LEAST_HANDLE + 1];
    const scale = width / (this.session.elements.width * this.enlarged);
    const corners = element.glyph && element.glyph.points.map((point) => {
      const [x, y] = this.dock.seen(point);
      return [handle[0] + scale * x, handle[1] + scale * y, 1];
    });
    return { element, handle, tracks: screen, width, hidden: false, corners, origin };
  }

  // --- the lens --------------------------------------------------------------------------------------

  /** Open, move or close the lens for a pointer at (x, y); true when something has moved.  `apart` for fingers. */
  point(x, y, apart = null) {
    const { lens } = this;
    if (lens && Math.hypot(x - lens.at[0], y - lens.at[1]) < STAY * lens.apart && (apart ?? 0) <= lens.apart) return false;
    const reachable = (this.drawn ?? []).filter((each) => !each.element.onBoard && this.isReachable(each));
    const wide = apart ?? (reachable[0]?.width ?? 0) + 2;
    const off = (each) => Math.hypot(each.handle[0] - x, each.handle[1] - y);
    const nearest = reachable.reduce((best, each) => (best && off(best) <= off(each) ? best : each), null);
    const aimed = nearest && off(nearest) <= nearest.width / 2 ? reachable.indexOf(nearest) : -1;
    const held = aimed < 0 ? null : reachable[aimed].handle; // what is pointed at does not run away
    const had = this.closeLens();
    if (!this.session.options.handles) return had;
    const homes = reachable.map(({ handle }) => handle);
    const found = lensAt(homes.map((home, i) => (i === aimed ? held : home)), [x, y], wide, aimed);
    if (!found) return had;
    const offsets = new Map([...found].map(([i, [dx, dy]]) => {
      const [hx, hy] = i === aimed ? [held[0] - homes[i][0], held[1] - homes[i][1]] : [0, 0];
      return [reachable[i].element, [dx + hx, dy + hy]];
    }));
    this.lens = { offsets, at: [x, y], apart: wide };
    this.shift();
    return true;
  }

  closeLens() {
    if (!this.lens) return false;
    this.shift(-1);
    this.lens = null;
    return true;
  }

  /** Move what is under the lens by its offsets, or back. */
  shift(sign = 1) {
    const { offsets } = this.lens;
    for (const each of this.drawn) {
      const [dx, dy] = offsets.get(each.element) ?? [0, 0];
      if (!dx && !dy) continue;
      const move = ([x, y, depth]) => [x + sign * dx, y + sign * dy, depth];
      each.home = sign > 0 ? each.handle : null;
      each.handle = move(each.handle);
      each.origin = move(each.origin);
      each.corners = each.corners && each.corners.map(move);
      each.tracks = each.tracks.map((track) => track.map(({ at, covered }) => ({ at: move(at), covered })));
    }
  }

  isReachable({ handle, hidden }) {
    return handle[2] > 0 && (!hidden || this.session.options.occlusion === 'overlay');
  }

  /** True when an element on the face is seen from behind, which no depth tells where the skin is a thin sheet. */
  facesAway(element, { towards }) {
    const { occlusion } = this.session.options;
    const facing = element.normal.reduce((sum, value, axis) => sum + value * towards[axis], 0);
    return occlusion !== 'overlay' && !element.onBoard && facing < -0.2;
  }

  arranged(element, project, hides, width, before) {
    const lens = this.lens;
    this.lens = null; // which moves what is drawn afterwards
    const map = this.mapOf(element, project);
    this.lens = lens;
    const handle = map(element.handle);
    const tracks = element.tracks.map((track, m) => {
      const kept = hides ? null : before?.tracks[m];
      return this.screenTrack(element.members[m], track, map, (at, k) => hides?.(at) ?? kept?.[k]?.covered ?? false);
    });
    const hidden = hides ? hides(handle) && mostlyCovered(tracks) : (before?.hidden ?? false);
    const bare = project(element.handle);
    const moved = ([x, y, depth]) => [x + handle[0] - bare[0], y + handle[1] - bare[1], depth];
    const corners = element.glyph && element.outline.map((corner) => moved(project(corner)));
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

  /** `strokes` of a review lie over all. */
  draw(strokes = []) {
    const { pen, session } = this;
    this.cover(strokes);
    pen.clearRect(0, 0, this.width, this.height);
    if (session.options.handles && this.drawn) {
      this.clipTo(this.column);
      const order = this.drawn.filter(({ element }) => !element.onBoard).sort((a, b) => b.handle[2] - a.handle[2]);
      this.drawElements(order);
      if (session.options.labels === 'all') this.drawLabels(order);
      pen.restore();
      if (this.dock.rect) this.drawDock();
    }
    this.drawPins();
    strokes.forEach((stroke) => this.drawStroke(stroke));
    this.drawPlacing();
    if (this.marquee) this.drawMarquee(this.marquee);
  }

  /** Let the canvas cover what is to be drawn and no more: what is empty takes time to show too. */
  cover(strokes) {
    const { canvas, pen, ratio } = this;
    const box = covering(this.reach(strokes), this.box, [this.width, this.height]);
    if (box === this.box) return;
    this.box = box;
    canvas.width = Math.round((box[2] - box[0]) * ratio);
    canvas.height = Math.round((box[3] - box[1]) * ratio);
    placed(canvas, box);
    pen.setTransform(ratio, 0, 0, ratio, -box[0] * ratio, -box[1] * ratio);
  }

  /** [left, top, right, bottom] around all that is drawn. */
  reach(strokes) {
    const { session, dock } = this;
    if (strokes.length || this.marquee || this.placing || session.options.labels === 'all') return [0, 0, this.width, this.height];
    const shown = session.options.handles ? (this.drawn ?? []) : [];
    const strip = session.options.handles && dock.rect;
    const ends = strip ? [[strip.left, strip.top], [strip.left + strip.width, strip.top + strip.height]] : [];
    let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
    const extend = ([x, y]) => {
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < top) top = y;
      if (y > bottom) bottom = y;
    };
    [...ends, ...(this.pinned ?? [])].forEach(extend);
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
    order.forEach((each) => this.drawLeader(each));
    order.forEach((each) => this.drawTracks(each));
    order.forEach((each) => this.drawHandle(each));
    order.forEach((each) => this.drawBadge(each));
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
    const { pen } = this;
    pen.globalAlpha = 0.5 * this.strength(element, hidden);
    pen.lineWidth = 1;
    pen.strokeStyle = '#f4f5f7';
    pen.beginPath();
    pen.moveTo(home[0], home[1]);
    pen.lineTo(handle[0], handle[1]);
    pen.stroke();
  }

  /** The sign of a second level: plus at what can be opened, minus at the members of what is open. */
  drawBadge(drawn) {
    const at = this.badgeOf(drawn);
    if (!at) return;
    const { pen } = this;
    const strength = this.strength(drawn.element, drawn.hidden);
    if (strength < 0.3) return;
    pen.globalAlpha = strength;
    pen.beginPath();
    pen.arc(at[0], at[1], BADGE, 0, 7);
    pen.fillStyle = '#f4f5f7';
    pen.fill();
    pen.lineWidth = 1.6;
    pen.strokeStyle = '#16181b';
    pen.beginPath();
    pen.moveTo(at[0] - 3, at[1]);
    pen.lineTo(at[0] + 3, at[1]);
    if (drawn.element.inner.length) {
      pen.moveTo(at[0], at[1] - 3);
      pen.lineTo(at[0], at[1] + 3);
    }
    pen.stroke();
    pen.globalAlpha = 1;
  }

  badgeOf({ element, handle, width }) {
    const { session } = this;
    const marked = element.inner.length || (session.levels.coarseOf(element).length && (session.hover === element || session.selection.has(element.index)));
    return marked ? [handle[0] + width / 2 + 4, handle[1] + width / 2 + 4] : null;
  }

  /** The element whose sign of a second level is at (x, y). */
  badgeAt(x, y, reach = BADGE + 2) {
    if (!this.session.options.handles) return null;
    const found = (this.drawn ?? []).filter((each) => this.isReachable(each)).find((each) => {
      const at = this.badgeOf(each);
      return at && Math.hypot(at[0] - x, at[1] - y) <= reach;
    });
    return found?.element ?? null;
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
    pen.lineCap = 'round';
    pen.lineJoin = 'round';
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
      if (strength >= FAINT) {
        pen.lineWidth = 4;
        pen.strokeStyle = 'rgba(15, 17, 20, 0.75)';
        pen.stroke();
      }
      pen.fillStyle = inside;
      pen.fill();
      if (!moved && strength >= FAINT) this.fillHalf(element, x, y, radius);
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
      pen.fillStyle = this.session.colours[element.side];
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
    pen.strokeStyle = refused ? this.session.colours.right : free ? '#9aa0a8' : '#7ee787';
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

  drawStroke(stroke) {
    const { pen } = this;
    pen.lineCap = 'round';
    pen.lineJoin = 'round';
    pen.beginPath();
    stroke.forEach(([x, y]) => pen.lineTo(x, y));
    if (stroke.length === 1) pen.lineTo(stroke[0][0], stroke[0][1]);
    for (const [width, colour] of [[5.5, '#14161a'], [3, '#f0a94b']]) {
      pen.lineWidth = width;
      pen.strokeStyle = colour;
      pen.stroke();
    }
  }

  // --- picking ---------------------------------------------------------------------------------------

  /** The element whose handle is nearest to (x, y) and within reach; covered handles only when drawn. */
  elementAt(x, y, reach = 0) {
    const { session, dock } = this;
    if (!session.options.handles || !this.drawn) return null;
    const inDock = dock.contains({ x, y });
    let best = null;
    for (const each of this.drawn) {
      const { element, handle, width } = each;
      if (!this.isReachable(each) || element.onBoard !== inDock) continue;
      const off = Math.hypot(handle[0] - x, handle[1] - y);
      if (off <= Math.max(reach, width / 2 + 4) && (!best || off < best.off)) best = { element, off };
    }
    return best?.element ?? null;
  }

  /** Whether a fingertip covers handles of several elements that the lens has not moved apart for it. */
  isAmbiguous(x, y, reach) {
    if (!this.session.options.handles || (this.lens && this.lens.apart >= 2 * reach)) return false;
    const covered = (this.drawn ?? []).filter((each) => {
      return !each.element.onBoard && this.isReachable(each) && Math.hypot(each.handle[0] - x, each.handle[1] - y) <= reach;
    });
    return covered.length > 1;
  }

  pinAt(x, y, reach = 0) {
    const index = (this.pinned ?? []).findIndex((pin) => Math.hypot(pin[0] + 5 - x, pin[1] - 15 - y) < Math.max(9, reach));
    return index < 0 ? null : this.session.pins[index];
  }

  elementsIn([x0, y0, x1, y1]) {
    const inside = ([x, y]) => x >= Math.min(x0, x1) && x <= Math.max(x0, x1) && y >= Math.min(y0, y1) && y <= Math.max(y0, y1);
    const overlay = this.session.options.occlusion === 'overlay';
    return (this.drawn ?? []).filter((each) => inside(each.handle) && (overlay || !each.hidden)).map((each) => each.element);
  }
}

/** A handle behind a fold of the skin whose track can be seen is still within reach. */
function mostlyCovered(tracks) {
  const corners = tracks.flat();
  return corners.filter(({ covered }) => covered).length > 0.6 * corners.length;
}

/** How much longer short tracks are drawn; those seen from their end stay as they are. */
function magnificationOf(tracks) {
  const longest = Math.max(...tracks.map((track) => {
    return track.slice(1).reduce((sum, [x, y], k) => sum + Math.hypot(x - track[k][0], y - track[k][1]), 0);
  }));
  return longest < LEAST_TRACK / MOST_GAIN ? 1 : Math.max(1, LEAST_TRACK / longest);
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
