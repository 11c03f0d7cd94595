// What every control is at every frame: the rig's clip, and keys as sparse opinions over it.
//
// A control has the value that its keys give (interpolation.js).  Outside its keys it follows the clip where
// the clip moves it, beginning one frame away from the key, and holds its nearest key where the clip does not.
// A control without keys follows the clip; one that the clip does not move either keeps what it was last set to.

import { bendsOf, valueBetween } from './interpolation.js';
import * as matrix from './matrix.js';
import { ascending, dot, known, mixed } from './vectors.js';

const DEFAULT_RANGE = [1, 48];
const DEFAULT_RATE = 24;
const MOVES = 1e-6; // what a weight or an entry of a rotation must change by for the clip to move it

export class Animation {
  constructor(character, rest) {
    this.character = character;
    this.controls = character.controls;
    this.clip = character.clip;
    this.rest = rest;
    const [first, last, rate] = character.timeCodes ?? [...DEFAULT_RANGE, DEFAULT_RATE];
    this.rate = this.clip?.framesPerSecond || rate;
    const times = this.clip && this.clip.times.length > 1 ? this.clip.times : [first, last];
    this.first = Math.floor(times[0]);
    this.last = Math.max(this.first + 1, Math.ceil(times.at(-1)));
    this.span = null; // first and last frame as set by hand, where no clip says them
    this.readings = this.controls.map(({ reading }) => this.clip && reading); // where the clip has their values
    this.moving = this.readings.map((reading) => reading !== null && this.isMoved(reading));
    this.recent = new Map(); // time -> the clip there
  }

  /** Whether the clip changes what a control is read from. */
  isMoved({ rises, joint }) {
    const { weights, locals, times } = this.clip;
    const changes = (array, width, from, count) => {
      for (let i = from; i < from + count; i++) {
        for (let k = 1; k < times.length; k++) if (Math.abs(array[k * width + i] - array[i]) > MOVES) return true;
      }
      return false;
    };
    if (rises) return changes(weights, this.character.channels.length, rises[0][0], 1);
    return changes(locals, 16 * this.character.joints.length, 16 * joint, 11);
  }

  /** Whether keys or the clip say what a control is in time. */
  isAnimated(control, keys) {
    return keys.has(control) || this.moving[control];
  }

  /** Control values, base weights and base joint transforms at a time; null for a base is the rig's own. */
  at(time, { keys, constants }) {
    const { values, weights, locals } = this.clipAt(time);
    const out = Float64Array.from(values);
    for (const [control, value] of constants) if (!this.isAnimated(control, keys)) out[control] = value;
    for (const [control, track] of keys) {
      out[control] = keyedValue(track, time, this.moving[control] ? (when) => this.clipAt(when).values[control] : null);
    }
    return { values: out, weights, locals };
  }

  get isFree() {
    return !(this.clip?.times.length > 1);
  }

  /** First and last whole frame of the clip, or as set by hand, and of keys. */
  range(keys, span = this.span) {
    const times = [...keys.values()].flatMap((track) => [track[0][0], track.at(-1)[0]]);
    const [first, last] = span ?? [this.first, this.last];
    return [Math.min(first, ...times.map(Math.floor)), Math.max(last, ...times.map(Math.ceil))];
  }

  /**
   * Times between which all control values are linear: every whole frame, every sample of the clip, every key,
   * where a stepped key lets go, and where a key's last frame ends.
   */
  times(keys, span = this.span) {
    const [first, last] = this.range(keys, span);
    const times = new Set(this.clip?.times ?? []);
    for (let frame = first; frame <= last; frame++) times.add(frame);
    for (const [control, track] of keys) {
      for (const [time] of track) times.add(time);
      for (const time of bendsOf(track)) times.add(time);
      if (this.moving[control]) times.add(track[0][0] - 1).add(track.at(-1)[0] + 1);
    }
    return ascending(times);
  }

  // --- the clip --------------------------------------------------------------------------------------

  /**
   * The clip at a time as control values over what no control says: driving the base weights and joint
   * transforms by the values gives the clip exactly.
   */
  clipAt(time) {
    if (!this.clip) return { values: this.rest, weights: null, locals: null };
    return known(this.recent, time, () => {
      if (this.recent.size >= 4) this.recent.delete(this.recent.keys().next().value);
      return this.readClip(time);
    });
  }

  readClip(time) {
    const weights = this.weightsAt(time);
    const locals = this.localsAt(time);
    const turns = new Map();
    const values = Float64Array.from(this.controls, (control, index) => {
      const reading = this.readings[index];
      if (!reading) return control.default;
      const { rises, joint } = reading;
      const away = rises
        ? (weights[rises[0][0]] - this.character.baseWeights[rises[0][0]]) / rises[0][1]
        : this.turned(reading, matrix.polar(locals.subarray(16 * joint, 16 * joint + 16)).rotation);
      if (!rises) {
        const turned = turns.get(joint) ?? [0, 0, 0];
        turns.set(joint, turned.map((value, axis) => value + away * reading.turn[axis]));
      }
      return control.default + away;
    });
    this.readings.forEach((reading, index) => {
      const away = values[index] - this.controls[index].default;
      reading?.rises?.forEach(([channel, rise]) => (weights[channel] -= away * rise));
    });
    for (const [joint, turned] of turns) turnBack(locals.subarray(16 * joint, 16 * joint + 16), turned);
    return { values, weights, locals };
  }

  /** The component along the control's own turn of a rotation from the rig's base. */
  turned({ joint, turn }, now) {
    const base = matrix.polar(this.character.base.subarray(16 * joint, 16 * joint + 16)).rotation;
    const turned = matrix.rotationVector(matrix.multiply3(now, matrix.transposed3(base)));
    return dot(turned, turn) / dot(turn, turn);
  }

  weightsAt(time) {
    const { low, high, share } = this.between(time);
    const width = this.character.channels.length;
    const { weights } = this.clip;
    return Float64Array.from({ length: width }, (_, i) => mixed(weights[low * width + i], weights[high * width + i], share));
  }

  localsAt(time) {
    const { low, high, share } = this.between(time);
    const width = 16 * this.character.joints.length;
    const row = (k) => this.clip.locals.subarray(k * width, (k + 1) * width);
    const locals = Float64Array.from(row(low));
    if (share === 0) return locals;
    for (let from = 0; from < width; from += 16) {
      const [before, after] = [row(low), row(high)].map((values) => values.subarray(from, from + 16));
      if (before.some((value, i) => value !== after[i])) locals.set(matrix.between(before, after, share), from);
    }
    return locals;
  }

  /** The samples around a time, and the share of the later one; before the first and after the last these hold. */
  between(time) {
    const { times } = this.clip;
    const low = Math.max(0, times.findLastIndex((each) => each <= time));
    const high = Math.min(low + 1, times.length - 1);
    const share = high > low ? Math.max(0, (time - times[low]) / (times[high] - times[low])) : 0;
    return { low, high, share };
  }
}

/** The value of keys at a time; `clip` tells what holds outside them, null: the keys. */
export function keyedValue(track, time, clip) {
  const after = track.findIndex(([key]) => key >= time);
  if (after > 0) return valueBetween(track, after - 1, time);
  const [edge, value] = after === 0 ? track[0] : track.at(-1);
  const away = Math.abs(time - edge);
  if (!clip || away === 0) return value;
  return away >= 1 ? clip(time) : mixed(value, clip(edge + Math.sign(time - edge)), away);
}

/** Take a turn out of a local transform S R, so that turning by it gives the transform again. */
function turnBack(local, turned) {
  const { stretch, rotation } = matrix.polar(local);
  const back = matrix.rotationOf(...turned.map((value) => -value));
  const linear = matrix.multiply3(stretch, matrix.multiply3(back, rotation));
  for (let row = 0; row < 3; row++) local.set(linear.slice(3 * row, 3 * row + 3), 4 * row);
}

