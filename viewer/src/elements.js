// Where every element's tracks and handle are at the current pose.
//
// What carries an element and which controls it ignores, each says itself, for the character and for the board
// (`follows`, of usdrigui/following.py).  Here it is evaluated; tests/laws/test_page_equals_usd.py holds it to what
// UsdSkel makes of the layer.

import { minus, plus, scaled } from './camera.js';
import * as matrix from './matrix.js';
import { alongTrack, lengthOf } from './vectors.js';

export class Elements {
  /** @type {number} */ width; // of handles, in the section that is shown

  constructor(character, deformer) {
    this.deformer = deformer;
    this.rest = restValues(character);
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
    const { deformer } = this;
    const { held, deforms, joint } = element.follows[element.onBoard ? 'board' : 'character'];
    const carrier = deformer.tracer(element.mesh, element.point, joint);
    Object.assign(element, { held, deforms, carrier, tracer: deformer.tracer(element.mesh, element.point) });
    deformer.setBase(null, null);
    deformer.drive(this.rest);
    element.restMap = deformer.traceMap(carrier);
    element.restPoint = deformer.trace(carrier, element.restMap);
    element.restInverse = matrix.inverse(element.restMap);
    element.enlarged = element.members.some((member) => member.magnification !== 1);
  }

  /** Move elements, all or some, to the pose of `values`; with `still` none deforms. */
  follow(values, still = false, list = this.list) {
    this.deformer.drive(values);
    for (const element of list) this.followOne(element, values, still || !element.deforms);
  }

  followOne(element, values, detached) {
    const { carrier, restInverse, restPoint } = element;
    const [map, skin] = this.without(element.held, values, () => {
      const now = this.deformer.traceMap(carrier);
      return [now, this.deformer.trace(carrier, now)];
    });
    const carry = restInverse ? matrix.multiply(restInverse, map) : matrix.IDENTITY;
    const anchor = detached ? matrix.transformPoint(carry, ...restPoint) : skin;
    element.tracks = element.members.map((member) => member.track.map((point) => carried(point, restPoint, carry, anchor)));
    const rests = element.members.map((member, m) => alongTrack(member.values, element.tracks[m], this.rest[member.control]));
    element.origin = rests[0];
    element.handle = detached || element.enlarged ? this.handleAt(element, values, rests) : this.deformer.trace(carrier);
    if (element.glyph) {
      const held = detached || !restInverse ? carry : matrix.multiply(restInverse, this.deformer.traceMap(carrier));
      element.outline = element.glyph.points.map((point) => carried(point, [0, 0, 0], held, element.handle));
    }
  }

  handleAt(element, values, rests) {
    const moved = (at, member, m) => plus(at, minus(alongTrack(member.values, element.tracks[m], values[member.control]), rests[m]));
    return element.members.reduce(moved, rests[0]);
  }

  /** Paths of the anchor under each of the element's controls in the base pose, magnified. */
  paths(element) {
    const { deformer, rest } = this;
    const middle = deformer.trace(element.tracer);
    return element.members.map(({ control, values: knots, magnification }) =>
      knots.map((knot) => {
        const at = deformer.withControl(control, rest[control], knot, () => deformer.trace(element.tracer));
        return plus(middle, scaled(minus(at, middle), magnification));
      }),
    );
  }

  /** Run `use` with some controls at rest and all others as driven. */
  without(held, values, use) {
    const nested = held.reduce((inner, control) => {
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

  /** Put an element on the board, under the heading where `process` lists it there. */
  putBeside(element) {
    Object.assign(element, { onBoard: true, category: element.boardCategory });
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
function restValues(character) {
  const base = character.layout.baseValues;
  return Float64Array.from(character.controls, (control, i) => base[i] ?? control.default);
}

/** Factor that makes a path at least `length` long; 1 for one that is, or that does not move at all. */
function magnificationFor(path, length) {
  const total = lengthOf(path);
  return total > 0 && total < length ? length / total : 1;
}

/** `anchor` plus the offset of a point from the base anchor, turned by the linear part of `carry`. */
function carried(point, base, carry, anchor) {
  const [x, y, z] = minus(point, base);
  return [0, 1, 2].map((axis) => anchor[axis] + x * carry[axis] + y * carry[4 + axis] + z * carry[8 + axis]);
}
