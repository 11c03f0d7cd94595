// Pulling the skin: a picked place, the pins and the present pose become the bounded fit of direct.js.

import { fitPull } from './direct.js';
import { farOf } from './drag.js';

const PROBE = 1e-3; // share of a control's range by which its motion is measured

export class Pull {
  /** Begin at a picked triangle; `towards` is the unit direction to the viewer. */
  constructor(session, hit, towards) {
    this.session = session;
    this.towards = towards;
    this.start = Float64Array.from(session.values);
    this.places = [session.place(hit), ...session.pins];
    this.origin = session.shown(this.places[0]);
    this.controls = session.controls;
  }

  /** Move the grabbed place to `target` (root space). */
  to(target) {
    const { session } = this;
    const targets = [target, ...session.pins.map((pin) => pin.at)].flat();
    const fit = (groups) => fitPull({
      model: this,
      start: this.start,
      now: session.values,
      targets,
      groups,
      towards: this.towards,
      locality: session.options.locality,
    });
    const local = fit(session.groups(false));
    const found = local.size ? local : fit(session.groups(true));
    session.affected = this.changes(found);
    session.set(found);
  }

  /** Whether a control that is free moves the grabbed place. */
  get acts() {
    const { motion } = this.linearise(this.session.values);
    return this.session.groups(true).flat().some((control) => Math.hypot(...motion(control).slice(0, 3)) > 0);
  }

  /** Control index to change since the start, as a share of its range. */
  changes(found) {
    const out = new Map();
    for (const [index, value] of found) {
      const share = Math.abs(value - this.start[index]) / (this.maximum(index) - this.minimum(index));
      if (share > 5e-3) out.set(index, share);
    }
    return out;
  }

  // --- the model that direct.js asks for -------------------------------------------------------------

  /** Ends of signed axes go from their default to one side. */
  minimum(index) {
    return this.opposites(index).length ? Math.min(this.off(index), farOf(this.controls[index])) : this.controls[index].minimum;
  }

  maximum(index) {
    return this.opposites(index).length ? Math.max(this.off(index), farOf(this.controls[index])) : this.controls[index].maximum;
  }

  opposites(index) {
    return this.session.opposites[index];
  }

  off(index) {
    return this.controls[index].default;
  }

  peak(index) {
    return this.session.influence.peak(index);
  }

  /** Positions of the grabbed place and the pins at `values`, and how each control moves them. */
  linearise(values) {
    const { deformer } = this.session;
    const trace = () => this.places.flatMap((place) => this.session.traced(place));
    deformer.drive(values);
    const at = trace();
    const motion = (index) => {
      const range = this.maximum(index) - this.minimum(index);
      const room = this.maximum(index) - values[index];
      const step = (room >= PROBE * range ? PROBE : -PROBE) * range;
      const moved = deformer.withControl(index, values[index], values[index] + step, trace);
      return moved.map((value, i) => (value - at[i]) / step);
    };
    return { at, motion };
  }
}
