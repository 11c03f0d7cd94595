// Where every element's tracks and handle are at the current pose.
//
// A member's track is the path that its anchor would take from here if only that control went through
// its range (so it follows every other control), and the handle stands on it at the control's value.
// Elements beside the face follow the joints of their anchor only, static ones nothing.

import * as matrix from './matrix.js';

export class Elements {
  constructor(character, deformer) {
    this.deformer = deformer;
    this.rest = restValues(character);
    this.width = character.layout.handleWidth;
    this.list = character.layout.elements.map((element, index) => ({ ...element, index }));
    this.byControl = new Map();
    for (const element of this.list) {
      for (const member of element.members) this.byControl.set(member.control, element);
      this.prepare(element);
    }
  }

  /** Everything about an element that holds as long as its anchor does. */
  prepare(element) {
    element.axes = axesOf(element);
    element.tracer = this.deformer.tracer(element.mesh, element.point);
    this.deformer.setBase(null, null);
    this.deformer.drive(this.rest);
    element.restPaths = element.beside ? null : this.paths(element, this.rest);
    const map = element.beside ? this.deformer.traceMap(element.tracer) : null;
    element.restInverse = map && matrix.inverse(map);
    element.tracks = element.members.map((member) => member.track.map((point) => [...point]));
    element.origin = [...element.position];
  }

  /** Move all elements to the pose of `values`; `frozen` leaves them where the layout put them. */
  follow(values, frozen = false) {
    this.deformer.drive(values);
    for (const element of this.list) this.followOne(element, values, frozen || element.static);
  }

  followOne(element, values, frozen) {
    if (!frozen && element.beside) this.followJoints(element, values);
    else if (!frozen) this.followSkin(element, values);
    else element.tracks = element.members.map((member) => member.track);
    element.origin = originOf(element, this.rest);
    element.handle = this.handleAt(element, values);
  }

  followSkin(element, values) {
    const paths = this.withoutOwn(element, values, () => this.paths(element, this.ownAtRest(element, values)));
    element.tracks = element.members.map((member, m) =>
      member.track.map((point, k) => point.map((value, axis) => value + paths[m][k][axis] - element.restPaths[m][k][axis])),
    );
  }

  followJoints(element, values) {
    if (!element.tracer.chain.length || !element.restInverse) return;
    const map = this.withoutOwn(element, values, () => this.deformer.traceMap(element.tracer));
    const move = matrix.multiply(element.restInverse, map);
    element.tracks = element.members.map((member) =>
      member.track.map((point) => matrix.transformPoint(move, ...point)),
    );
  }

  /** Drawn paths of the members' tracks, gain applied, with the element's other members at rest. */
  paths(element, values) {
    const { deformer, rest } = this;
    const fixed = element.members.every((member) => !deformer.controls[member.control].drive.turns);
    const map = fixed ? deformer.traceMap(element.tracer) : undefined;
    const middle = deformer.trace(element.tracer, map);
    return element.members.map(({ control, values: knots, gain }) =>
      knots.map((knot) => {
        if (knot === rest[control]) return middle;
        const at = deformer.withControl(control, values[control], knot, () => deformer.trace(element.tracer, map));
        return at.map((value, axis) => middle[axis] + gain * (value - middle[axis]));
      }),
    );
  }

  ownAtRest(element, values) {
    const still = Float64Array.from(values);
    for (const { control } of element.members) still[control] = this.rest[control];
    return still;
  }

  /** Run `use` with the element's own controls at rest and all others as driven. */
  withoutOwn(element, values, use) {
    const nested = element.members.reduce((inner, { control }) => {
      if (values[control] === this.rest[control]) return inner;
      return () => this.deformer.withControl(control, values[control], this.rest[control], inner);
    }, use);
    return nested();
  }

  handleAt(element, values) {
    const at = [...element.origin];
    element.members.forEach((member, m) => {
      const on = alongTrack(member.values, element.tracks[m], values[member.control]);
      const from = alongTrack(member.values, element.tracks[m], this.rest[member.control]);
      for (let axis = 0; axis < 3; axis++) at[axis] += on[axis] - from[axis];
    });
    return at;
  }

  /** Anchor an element at another point of the character; `values` is the present pose. */
  reanchor(element, mesh, point, widths) {
    Object.assign(element, { mesh, point, beside: false, family: '' });
    element.tracer = this.deformer.tracer(mesh, point);
    this.deformer.setBase(null, null);
    this.deformer.drive(this.rest);
    element.position = this.deformer.trace(element.tracer);
    for (const member of element.members) member.gain = 1;
    const bare = this.paths(element, this.rest);
    element.members.forEach((member, m) => (member.gain = gainFor(bare[m], widths * this.width)));
    const drawn = this.paths(element, this.rest);
    element.members.forEach((member, m) => (member.track = drawn[m].map((each) => [...each])));
    this.prepare(element);
  }

  /** Put an element beside the face, its tracks moved as they are by `offset`. */
  putBeside(element, offset) {
    const shifted = (point) => point.map((value, axis) => value + offset[axis]);
    element.position = shifted(element.position);
    for (const member of element.members) member.track = member.track.map(shifted);
    element.beside = true;
    this.prepare(element);
  }

  /** What rearranging changes in an element, to be given back by `restore`. */
  placement(element) {
    const { mesh, point, beside, family, position } = element;
    const members = element.members.map(({ track, gain }) => ({ track, gain }));
    return { mesh, point, beside, family, position, members };
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
function gainFor(path, length) {
  let total = 0;
  for (let k = 1; k < path.length; k++) total += Math.hypot(...path[k].map((value, axis) => value - path[k - 1][axis]));
  return total > 0 && total < length ? length / total : 1;
}

/** Positions of members that make one axis each: opposed pairs [negative, positive], or single ones. */
function axesOf(element) {
  const paired = new Set(element.opposed.flat());
  const axes = element.opposed.map(([negative, positive]) => [negative, positive]);
  element.members.forEach((_, m) => {
    if (!paired.has(m)) axes.push([m]);
  });
  return axes.sort((a, b) => Math.min(...a) - Math.min(...b));
}

function originOf(element, rest) {
  const { control, values } = element.members[0];
  return alongTrack(values, element.tracks[0], rest[control]);
}
