// From a drag in the plane of the screen to the values of an element's controls.
//
// Every axis of the element (one control, or two opposed ones) is a polyline on the screen with the
// values of its controls at each corner.  One axis: the nearest point on the line, searched from where
// the handle is so that a curved slider never jumps across its bend.  Two axes (patch, joystick): the
// point of the patch nearest to the pointer.  More (fan): the best of the patches of adjacent axes.

import { alongTrack } from './elements.js';

const STRAY = 4; // pixels from the line within which a drag keeps to the branch that it is on
const LEAST = 24; // pixels that a line is given when it is shorter than a quarter of this on the screen

/**
 * A drag of one element, begun at the present pose.  `project` maps a root-space point to [x, y] in
 * pixels, `values` are all control values at the start.
 */
export function beginDrag(element, controls, rest, values, project) {
  const origin = project(element.origin);
  const axes = element.axes.map((members) => screenAxis(element, members, controls, rest, values, project, origin));
  return { axes, origin, current: axes.map((axis) => axis.start) };
}

/**
 * Control values, as a Map of control index to value, for a handle at `target` pixels relative to the
 * position that the handle had at the start.
 */
export function dragTo(drag, dx, dy) {
  const from = drag.axes.reduce((sum, axis) => plus(sum, pointAt(axis, axis.start)), [0, 0]);
  const target = plus(from, [dx, dy]);
  if (drag.axes.length === 1) drag.current = [nearest(drag.axes[0], target, drag.current[0])];
  else if (drag.axes.length === 2) drag.current = onPatch(drag.axes, target, drag.current);
  else drag.current = onFan(drag.axes, target, drag.current);
  const changed = new Map();
  drag.axes.forEach((axis, i) => valuesAt(axis, drag.current[i]).forEach((value, k) => changed.set(axis.controls[k], value)));
  return changed;
}

/** One axis as corners: position relative to the element's origin, and the values of its controls. */
function screenAxis(element, members, controls, rest, values, project, origin) {
  const indices = members.map((m) => element.members[m].control);
  const corners = members.length === 1
    ? singleCorners(element, members[0], controls)
    : opposedCorners(element, members, controls, rest);
  const points = corners.map(({ at }) => {
    const [x, y] = project(at);
    return [x - origin[0], y - origin[1]];
  });
  // Of several axes one that is seen end-on must not take what the others are dragged along.
  const shown = element.axes.length > 1 ? points : stretched(points);
  const axis = { controls: indices, points: shown, values: corners.map(({ set }) => set) };
  axis.start = parameterOf(axis, indices.map((control) => values[control]));
  return axis;
}

function singleCorners(element, m, controls) {
  const { control, values } = element.members[m];
  const { minimum, maximum } = controls[control];
  const inside = values.filter((value) => value > minimum && value < maximum);
  return [minimum, ...inside, maximum].map((value) => ({
    at: alongTrack(values, element.tracks[m], value),
    set: [value],
  }));
}

/** From the far end of the negative control through rest to the far end of the positive one. */
function opposedCorners(element, [negative, positive], controls, rest) {
  const restOf = [negative, positive].map((m) => rest[element.members[m].control]);
  const half = (m) => singleCorners(element, m, controls).filter(({ set }) => set[0] > rest[element.members[m].control]);
  return [
    ...half(negative).reverse().map(({ at, set }) => ({ at, set: [set[0], restOf[1]] })),
    { at: element.origin, set: restOf },
    ...half(positive).map(({ at, set }) => ({ at, set: [restOf[0], set[0]] })),
  ];
}

/** A line seen end-on cannot be dragged along: give it a length, upwards if it has no direction at all. */
function stretched(points) {
  const length = polylineLength(points);
  if (length >= LEAST / 4) return points;
  const [first, last] = [points[0], points.at(-1)];
  const span = Math.hypot(last[0] - first[0], last[1] - first[1]);
  if (span > 1) return points.map(([x, y]) => [(x * LEAST) / span, (y * LEAST) / span]);
  return points.map((point, i) => [point[0], point[1] - (LEAST * i) / Math.max(1, points.length - 1)]);
}

function polylineLength(points) {
  let total = 0;
  for (let i = 1; i < points.length; i++) total += Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
  return total;
}

// --- parameters: corner index plus share of the piece that follows -----------------------------------

function pointAt(axis, t) {
  const i = Math.min(Math.floor(t), axis.points.length - 2);
  return axis.points[i].map((from, k) => from + (t - i) * (axis.points[i + 1][k] - from));
}

function valuesAt(axis, t) {
  const i = Math.min(Math.floor(t), axis.values.length - 2);
  return axis.values[i].map((from, k) => (t === i ? from : from + (t - i) * (axis.values[i + 1][k] - from)));
}

/** Parameter whose values are nearest to `wanted`. */
function parameterOf(axis, wanted) {
  let best = [Infinity, 0];
  for (let i = 0; i + 1 < axis.values.length; i++) {
    const [a, b] = [axis.values[i], axis.values[i + 1]];
    const step = a.map((value, k) => b[k] - value);
    const square = dot(step, step);
    const share = square ? clamp(dot(wanted.map((value, k) => value - a[k]), step) / square, 0, 1) : 0;
    const off = a.reduce((sum, value, k) => sum + (value + share * step[k] - wanted[k]) ** 2, 0);
    if (off < best[0] - 1e-15) best = [off, i + share];
  }
  return best[1];
}

/** Nearest point of the polyline, walking downhill from parameter `start`; another branch where it is twice as near. */
function nearest(axis, target, start) {
  const last = axis.points.length - 2;
  const on = (i) => {
    const [a, b] = [axis.points[i], axis.points[i + 1]];
    const step = [b[0] - a[0], b[1] - a[1]];
    const square = dot(step, step);
    const share = square ? clamp(dot([target[0] - a[0], target[1] - a[1]], step) / square, 0, 1) : 0;
    return { t: i + share, off: Math.hypot(a[0] + share * step[0] - target[0], a[1] + share * step[1] - target[1]) };
  };
  let best = on(Math.min(Math.floor(start), last));
  for (const direction of [1, -1]) {
    for (let i = Math.min(Math.floor(start), last) + direction; i >= 0 && i <= last; i += direction) {
      const next = on(i);
      if (next.off > best.off + 1e-9) break;
      best = next;
    }
  }
  if (best.off < STRAY) return best.t;
  // Another branch of a bend, or the other end of an opposed pair that goes the same way on the screen.
  for (let i = 0; i <= last; i++) {
    const other = on(i);
    if (other.off < 0.5 * best.off) best = other;
  }
  return best.t;
}

/** Alternate between the two axes from several starts; straight axes settle at the bounded optimum. */
function onPatch(axes, target, current) {
  const [u, v] = axes;
  const straight = solveStraight(axes, target, current);
  let [s, t] = straight;
  for (let round = 0; round < 60; round++) {
    const before = [s, t];
    s = nearest(u, minus(target, pointAt(v, t)), s);
    t = nearest(v, minus(target, pointAt(u, s)), t);
    if (Math.abs(s - before[0]) + Math.abs(t - before[1]) < 1e-7) break;
  }
  return [s, t];
}

/** Newton steps with both axes free, held inside their ends: exact where both pieces are straight. */
function solveStraight([u, v], target, [s, t]) {
  for (let round = 0; round < 12; round++) {
    const i = Math.min(Math.floor(s), u.points.length - 2);
    const j = Math.min(Math.floor(t), v.points.length - 2);
    const a = minus(u.points[i + 1], u.points[i]);
    const b = minus(v.points[j + 1], v.points[j]);
    const off = minus(target, plus(pointAt(u, s), pointAt(v, t)));
    const area = a[0] * b[1] - a[1] * b[0];
    if (Math.abs(area) < 1e-6 || Math.hypot(...off) < 1e-9) break;
    // At most into the neighbouring piece, whose direction the next round takes up.
    s = clamp(s + (off[0] * b[1] - off[1] * b[0]) / area, Math.max(0, i - 0.5), Math.min(u.points.length - 1, i + 1.5));
    t = clamp(t + (a[0] * off[1] - a[1] * off[0]) / area, Math.max(0, j - 0.5), Math.min(v.points.length - 1, j + 1.5));
  }
  return [s, t];
}

/** The best of the patches between axes that are neighbours by angle; all other axes go to rest. */
function onFan(axes, target, current) {
  const restAt = axes.map((axis) => nearest(axis, [0, 0], axis.start));
  const order = axes
    .map((axis, i) => ({ i, angle: Math.atan2(...[...axis.points.at(-1)].reverse()) }))
    .sort((a, b) => a.angle - b.angle);
  let best = { off: Infinity };
  order.forEach(({ i, angle }, k) => {
    const next = order[(k + 1) % order.length];
    const span = (next.angle - angle + 2 * Math.PI) % (2 * Math.PI);
    if (span > Math.PI + 1e-6 && order.length > 2) return;
    const pair = [axes[i], axes[next.i]];
    const [s, t] = onPatch(pair, target, [restAt[i], restAt[next.i]]);
    const off = Math.hypot(...minus(target, plus(pointAt(pair[0], s), pointAt(pair[1], t))));
    if (off < best.off - 1e-6) best = { off, set: restAt.map((at, n) => (n === i ? s : n === next.i ? t : at)) };
  });
  return best.set ?? current;
}

const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
const plus = (a, b) => [a[0] + b[0], a[1] + b[1]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
