// Where tracks, handles and pins are on the screen: projected, lengthened where they are short, moved apart by the lens;
// and what a pointer meets there.

import { Dock } from './dock.js';
import { alongTrack, clamp, dot, known, lengthOf } from './vectors.js';
import { lensAt } from './spread.js';

const LEAST_HANDLE = 11;
const MOST_HANDLE = 22;
const LEAST_TRACK = 30; // pixels: shorter tracks are drawn longer, and moved so
const MOST_GAIN = 8;
const STAY = 2; // least distances that the pointer may go before the lens comes after it
export const BADGE = 6; // pixels of the sign at a coarse element, and at its open members

export class Arrangement {
  constructor(session) {
    this.session = session;
    this.drawn = []; // of each element shown, where it is
    this.enlarged = 1; // how much larger handles are drawn than they are
    this.leftward = 0; // where the character's left is on the screen: -1, 0 or 1
    this.dock = new Dock(session);
    this.lens = null;
    this.look = '';
    this.magnifications = new Map();
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
    const width = clamp(session.elements.width * perUnit, LEAST_HANDLE, MOST_HANDLE);
    this.enlarged = width / (session.elements.width * perUnit);
    const before = new Map(this.drawn.map((each) => [each.element, each]));
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
    this.leftward = Math.sign(dot(session.character.layout.planeNormal, camera.right));
    if (this.lens) this.shift();
  }

  /** From an element's scene units to pixels: a short track is lengthened about the place of its handle at rest, `middle`. */
  mapOf(element, project, middle = element.origin) {
    const origin = project(middle);
    const magnification = known(this.magnifications, element, () => magnificationOf(element.tracks.map((track) => track.map(project))));
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
    const reachable = this.drawn.filter((each) => !each.element.onBoard && this.isReachable(each));
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
    return occlusion !== 'overlay' && !element.onBoard && dot(element.normal, towards) < -0.2;
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

  /** Where the sign of a second level is. */
  badgeOf({ element, handle, width }) {
    const { session } = this;
    const marked = element.inner.length || (session.levels.coarseOf(element).length && (session.hover === element || session.selection.has(element.index)));
    return marked ? [handle[0] + width / 2 + 4, handle[1] + width / 2 + 4] : null;
  }

  /** The element whose sign of a second level is at (x, y). */
  badgeAt(x, y, reach = BADGE + 2) {
    if (!this.session.options.handles) return null;
    const found = this.drawn.filter((each) => this.isReachable(each)).find((each) => {
      const at = this.badgeOf(each);
      return at && Math.hypot(at[0] - x, at[1] - y) <= reach;
    });
    return found?.element ?? null;
  }

  // --- picking ---------------------------------------------------------------------------------------

  /** The element whose handle is nearest to (x, y) and within reach; covered handles only when drawn. */
  elementAt(x, y, reach = 0) {
    const { session, dock } = this;
    if (!session.options.handles) return null;
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
    const covered = this.drawn.filter((each) => {
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
    return this.drawn.filter((each) => inside(each.handle) && (overlay || !each.hidden)).map((each) => each.element);
  }
}

/** A handle behind a fold of the skin whose track can be seen is still within reach. */
function mostlyCovered(tracks) {
  const corners = tracks.flat();
  return corners.filter(({ covered }) => covered).length > 0.6 * corners.length;
}

/** How much longer short tracks are drawn; those seen from their end stay as they are. */
function magnificationOf(tracks) {
  const longest = Math.max(...tracks.map((track) => lengthOf(track.map((point) => point.slice(0, 2)))));
  return longest < LEAST_TRACK / MOST_GAIN ? 1 : Math.max(1, LEAST_TRACK / longest);
}
