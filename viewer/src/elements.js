// Where every element's tracks and handle are at the current pose; mirrors usdrigui/pose/evaluate.py.
//
// Tracks follow the skin under all controls but the element's own, the handle under all.  Beside the face,
// or where an element is static, it follows the joints of its anchor alone; what stands on the board
// stays in one piece, moved by no control of any element there.

import * as matrix from './matrix.js';

export class Elements {
  constructor(character, deformer) {
    this.deformer = deformer;
    this.rest = restValues(character);
    this.width = character.layout.handleWidth;
    this.list = character.layout.elements.map((element, index) => ({ ...element, index }));
    this.byControl = new Map();
    for (const element of this.list) {
      for (const member of element.members) this.claim(member.control, element);
      this.prepare(element);
    }
  }

  /** A control's element is the coarse one, where it has a slider of its own besides. */
  claim(control, element) {
    const before = this.byControl.get(control);
    if (!before?.inner.includes(element.name)) this.byControl.set(control, element);
  }

  /** Everything about an element that holds as long as its anchor does. */
  prepare(element) {
    element.tracer = this.deformer.tracer(element.mesh, element.point);
    this.deformer.setBase(null, null);
    this.deformer.drive(this.rest);
    element.restMap = this.deformer.traceMap(element.tracer);
    element.restPoint = this.deformer.trace(element.tracer, element.restMap);
    element.restInverse = matrix.inverse(element.restMap);
    element.enlarged = element.members.some((member) => member.magnification !== 1);
  }

  /** Move all elements to the pose of `values`; with `still` all are taken for static ones. */
  follow(values, still = false) {
    this.deformer.drive(values);
    this.board = this.boardControls();
    for (const element of this.list) this.followOne(element, values, still || element.static || element.onBoard);
  }

  followOne(element, values, detached) {
    const { tracer, restInverse, restPoint } = element;
    const [map, skin] = this.withoutOwn(element, values, () => {
      const now = this.deformer.traceMap(tracer);
      return [now, this.deformer.trace(tracer, now)];
    });
    const carry = restInverse ? matrix.multiply(restInverse, map) : matrix.IDENTITY;
    const anchor = detached ? matrix.transformPoint(carry, ...restPoint) : skin;
    element.tracks = element.members.map((member) => member.track.map((point) => carried(point, restPoint, carry, anchor)));
    const rests = element.members.map((member, m) => alongTrack(member.values, element.tracks[m], this.rest[member.control]));
    element.origin = rests[0];
    element.handle = detached || element.enlarged ? this.handleAt(element, values, rests) : this.deformer.trace(tracer);
    if (element.glyph) {
      const held = detached || !restInverse ? carry : matrix.multiply(restInverse, this.deformer.traceMap(tracer));
      element.outline = element.glyph.points.map((point) => carried(point, [0, 0, 0], held, element.handle));
    }
  }

  handleAt(element, values, rests) {
    const at = [...rests[0]];
    element.members.forEach((member, m) => {
      const on = alongTrack(member.values, element.tracks[m], values[member.control]);
      for (let axis = 0; axis < 3; axis++) at[axis] += on[axis] - rests[m][axis];
    });
    return at;
  }

  /** Paths of the anchor under each of the element's controls in the base pose, magnified. */
  paths(element) {
    const { deformer, rest } = this;
    const middle = deformer.trace(element.tracer);
    return element.members.map(({ control, values: knots, magnification }) =>
      knots.map((knot) => {
        const at = deformer.withControl(control, rest[control], knot, () => deformer.trace(element.tracer));
        return at.map((value, axis) => middle[axis] + magnification * (value - middle[axis]));
      }),
    );
  }

  /** Controls of the elements on the board that turn or move joints. */
  boardControls() {
    const owned = this.list.filter((element) => element.onBoard).flatMap((element) => element.members);
    const turning = owned.filter(({ control }) => this.deformer.controls[control].drive.joints.length);
    return [...new Set(turning.map(({ control }) => control))];
  }

  /** Run `use` with the element's own controls at rest, beside the face all of the board's, and others as driven. */
  withoutOwn(element, values, use) {
    const own = element.onBoard ? this.board : element.members.map(({ control }) => control);
    const nested = own.reduce((inner, control) => {
      if (values[control] === this.rest[control]) return inner;
      return () => this.deformer.withControl(control, values[control], this.rest[control], inner);
    }, use);
    return nested();
  }

  /** Anchor an element at another point of the character; `values` is the present pose. */
  reanchor(element, mesh, point, widths) {
    Object.assign(element, { mesh, point, onBoard: false, category: '' });
    element.tracer = this.deformer.tracer(mesh, point);
    this.deformer.setBase(null, null);
    this.deformer.drive(this.rest);
    element.position = this.deformer.trace(element.tracer);
    for (const member of element.members) member.magnification = 1;
    const bare = this.paths(element);
    element.members.forEach((member, m) => (member.magnification = magnificationFor(bare[m], widths * this.width)));
    const drawn = this.paths(element);
    element.members.forEach((member, m) => (member.track = drawn[m].map((each) => [...each])));
    this.prepare(element);
  }

  /** Put an element on the board, its tracks moved as they are by `offset`. */
  putBeside(element, offset) {
    const shifted = (point) => point.map((value, axis) => value + offset[axis]);
    element.position = shifted(element.position);
    for (const member of element.members) member.track = member.track.map(shifted);
    element.onBoard = true;
    this.prepare(element);
  }

  /** What rearranging changes in an element, to be given back by `restore`. */
  placement(element) {
    const { mesh, point, onBoard, category, position } = element;
    const members = element.members.map(({ track, magnification }) => ({ track, magnification }));
    return { mesh, point, onBoard, category, position, members };
  }

  restore(element, { members, ...place }) {
    Object.assign(element, place);
    element.members.forEach((member, m) => Object.assign(member, members[m]));
    this.prepare(element);
  }
}

/** Values of the base pose in which the layout was made. */
export function restValues(character) {
  const base = character.layout.baseValues;
  return Float64Array.from(character.controls, (control, i) => base[i] ?? control.default);
}

/** Position on a track (knots ascending) at a value; beyond the ends the last pieces go on. */
export function alongTrack(knots, track, value) {
  if (knots.length === 1) return track[0];
  let i = 0;
  while (i < knots.length - 2 && value >= knots[i + 1]) i++;
  const share = (value - knots[i]) / (knots[i + 1] - knots[i]);
  return track[i].map((from, axis) => (1 - share) * from + share * track[i + 1][axis]);
}

/** Factor that makes a path at least `length` long; 1 for one that is, or that does not move at all. */
function magnificationFor(path, length) {
  let total = 0;
  for (let k = 1; k < path.length; k++) total += Math.hypot(...path[k].map((value, axis) => value - path[k - 1][axis]));
  return total > 0 && total < length ? length / total : 1;
}

/** `anchor` plus the offset of a point from the base anchor, turned by the linear part of `carry`. */
function carried(point, base, carry, anchor) {
  const [x, y, z] = [point[0] - base[0], point[1] - base[1], point[2] - base[2]];
  return [
    anchor[0] + x * carry[0] + y * carry[4] + z * carry[8],
    anchor[1] + x * carry[1] + y * carry[5] + z * carry[9],
    anchor[2] + x * carry[2] + y * carry[6] + z * carry[10],
  ];
}
