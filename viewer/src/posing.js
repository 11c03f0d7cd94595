// The values of a character's controls, and what of it they move: its skin, places and pins on it, and the controls that may
// change in a pull.

import { plus, scaled } from './camera.js';
import { Display } from './display.js';
import { shownValue } from './dom.js';
import { Influence } from './heat.js';
import { clamp } from './vectors.js';

const WIDE = new Set(['global', 'composite']);

export class Posing extends Display {
  constructor(character) {
    super(character);
    this.rest = this.elements.rest;
    this.values = Float64Array.from(this.rest);
    this.influence = new Influence(character, this.deformer, this.rest);
    this.opposites = oppositesOf(this.elements.list, this.controls.length);
    this.twins = twinsOf(this.elements.list, this.opposites);
    this.locks = new Set();
    this.pins = [];
    this.affected = new Map();
    this.dragging = null;
  }

  /** Recompute points and elements from the values. */
  reshape() {
    this.deformer.pose(this.values);
    this.elements.follow(this.values, !this.options.follow);
    this.emit('pose');
  }

  // --- values ----------------------------------------------------------------------------------------

  /** Set control values (Map or entries of index to value): bounded, locks kept, mirrored if asked. */
  set(changes) {
    for (const [index, value] of changes) {
      this.setOne(index, value);
      const twin = this.twins[index];
      if (this.options.symmetric && twin >= 0) this.setOne(twin, this.mirrored(index, twin));
    }
    this.reshape();
  }

  setOne(index, value) {
    const { minimum, maximum } = this.controls[index];
    if (!this.locks.has(index) && Number.isFinite(value)) {
      this.values[index] = clamp(value, minimum, maximum);
    }
  }

  /** The twin's value for this control's: the same share of its own range about rest. */
  mirrored(index, twin, values = this.values) {
    const away = values[index] - this.rest[index];
    const span = (control, end) => Math.abs(this.controls[control][end] - this.rest[control]) || 1;
    const end = away < 0 ? 'minimum' : 'maximum';
    return this.rest[twin] + (away * span(twin, end)) / span(index, end);
  }

  setOption(name, value) {
    this.options[name] = value;
    if (name === 'follow') this.reshape();
    this.emit('options');
  }

  flipOption(name) {
    this.setOption(name, !this.options[name]);
  }

  toggleLock(control) {
    if (!this.locks.delete(control)) this.locks.add(control);
    this.emit('options');
  }

  /** A control's value, or another, for people. */
  worded(index, value = this.values[index]) {
    const { minimum, maximum } = this.controls[index];
    return shownValue(value, maximum - minimum);
  }

  // --- points of the skin ----------------------------------------------------------------------------

  /** Mesh index and local point of a point of the character. */
  meshOf(point) {
    const meshes = this.character.meshes;
    const index = meshes.findIndex((mesh) => point < mesh.start + mesh.count);
    return [index, point - meshes[index].start];
  }

  tracer(point) {
    return this.deformer.tracer(...this.meshOf(point));
  }

  /** A place on the skin, as a picked triangle gives it, that can be traced through poses. */
  place({ corners, shares }) {
    return { corners, shares, tracers: corners.map((corner) => this.tracer(corner)) };
  }

  /** Where a place is at the weights and moves last driven. */
  traced(place) {
    return place.tracers.reduce((sum, tracer, k) => plus(sum, scaled(this.deformer.trace(tracer), place.shares[k])), [0, 0, 0]);
  }

  /** Where a place is on the shown skin. */
  shown(place) {
    const { points } = this.deformer;
    return place.corners.reduce((sum, corner, k) => plus(sum, scaled(points.subarray(3 * corner, 3 * corner + 3), place.shares[k])), [0, 0, 0]);
  }

  addPin(hit) {
    const place = this.place(hit);
    this.pins.push({ ...place, at: this.shown(place) });
    this.emit('options');
  }

  removePin(pin) {
    this.pins = this.pins.filter((each) => each !== pin);
    this.emit('options');
  }

  /**
   * Controls that may change in a pull of the skin, those that change together in one list: not the locked
   * ones, and without `wide` none of the whole face's, nor any that repeats what others do together.  What
   * keeps its value away from its default keeps the other end of its axis, too.
   */
  groups(wide) {
    return this.besideFreeEnds(this.unlocked(wide));
  }

  /** The groups of which no control has an opposite end away from its default that is in no group. */
  besideFreeEnds(groups) {
    const free = new Set(groups.flat());
    const held = (end) => !free.has(end) && this.values[end] !== this.controls[end].default;
    const left = groups.filter((group) => !group.some((control) => this.opposites[control].some(held)));
    return left.length < groups.length ? this.besideFreeEnds(left) : left;
  }

  unlocked(wide) {
    const groups = [];
    for (let index = 0; index < this.controls.length; index++) {
      const twin = this.options.symmetric ? this.twins[index] : -1;
      if (twin >= 0 && twin < index) continue;
      const group = twin > index ? [index, twin] : [index];
      if (group.some((control) => this.locks.has(control))) continue;
      if (this.options.symmetric && twin < 0 && this.crosses(index)) continue;
      if (wide || !this.isWide(index)) groups.push(group);
    }
    return groups;
  }

  /** Whether a control moves the whole face, or repeats what others do together. */
  isWide(index) {
    return WIDE.has(this.elements.byControl.get(index)?.category) || this.influence.isWide(index);
  }

  /** Whether a control without a twin moves the face to one side, which alone is not symmetric. */
  crosses(index) {
    return this.influence.sidewaysOf(index, this.character.layout.planeNormal) > 0.5;
  }
}

/** Per control the other ends of its axes: one at most of an opposed pair is away from its default. */
export function oppositesOf(elements, count) {
  /** @type {number[][]} */
  const opposites = Array.from({ length: count }, () => []);
  for (const { members, axes } of elements) {
    for (const [a, b] of axes.filter((axis) => axis.length === 2).map((axis) => axis.map((m) => members[m].control))) {
      if (!opposites[a].includes(b)) [opposites[a], opposites[b]].forEach((each, k) => each.push([b, a][k]));
    }
  }
  return opposites;
}

/** Twin of each control, or -1, from the elements that mirror each other; the other end of an axis is none. */
export function twinsOf(elements, opposites) {
  const twins = new Int32Array(opposites.length).fill(-1);
  const named = new Map(elements.map((element) => [element.name, element]));
  for (const element of elements) {
    const mirror = named.get(element.mirror);
    if (!mirror || mirror === element || mirror.members.length !== element.members.length) continue;
    element.members.forEach(({ control }, m) => {
      const twin = mirror.members[m].control;
      if (!element.reversed?.includes(m) && !opposites[control].includes(twin)) twins[control] = twin;
    });
  }
  return twins;
}
