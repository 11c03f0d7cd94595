// An orbiting camera around the face, in the frame given by the rig's up and the layout's view.

import { clamp, dot } from './vectors.js';

const FIELD = (14 * Math.PI) / 180; // a long lens: what stands on the board does not turn it away
const HALF = Math.tan(FIELD / 2);
const STEEPEST = (88 * Math.PI) / 180;

export class OrbitCamera {
  /** @type {number[]} */ right;
  /** @type {number[]} */ above;
  /** @type {number[]} */ towards;

  constructor(up, view) {
    this.up = normalised(up);
    const ahead = normalised(minus(view, scaled(this.up, dot(view, this.up))));
    this.front = ahead ?? anyAcross(this.up);
    this.side = cross(this.up, this.front);
    this.target = [0, 0, 0];
    this.distance = 1;
    this.size = 1;
    this.half = HALF; // of what is seen at a distance of 1, from top to bottom
    this.turn(0, 0);
  }

  /** Look from an azimuth and elevation (radians) off the front, through the own lens. */
  turn(azimuth, elevation) {
    this.distance *= this.half / HALF;
    this.half = HALF;
    this.azimuth = azimuth;
    this.elevation = clamp(elevation, -STEEPEST, STEEPEST);
    const level = plus(scaled(this.front, Math.cos(azimuth)), scaled(this.side, Math.sin(azimuth)));
    this.towards = plus(scaled(level, Math.cos(this.elevation)), scaled(this.up, Math.sin(this.elevation)));
    this.right = /** @type {number[]} */ (normalised(cross(this.up, this.towards)));
    this.above = cross(this.towards, this.right);
  }

  /** Look the same way through the own lens, and without a roll. */
  leaveShot() {
    this.turn(this.azimuth, this.elevation);
  }

  /** Look at a target from where `towards` points (unit vector), so far away. */
  lookFrom(target, towards, distance) {
    this.turn(Math.atan2(dot(towards, this.side), dot(towards, this.front)), Math.asin(clamp(dot(towards, this.up), -1, 1)));
    this.target = target;
    this.distance = distance;
  }

  /** Look through the camera of a shot (`shot_camera` in usdrigui/character/rig.py), its whole picture in a column. */
  lookThrough([right, above, towards, place, [across, upward]], { width, height }) {
    const ahead = dot(minus(place, this.target), towards);
    this.lookFrom(this.target, towards, ahead > 0 ? ahead : this.distance);
    this.target = minus(place, scaled(towards, this.distance));
    Object.assign(this, { right, above, towards, half: Math.max(upward, (across * height) / width) });
  }

  /** Fit points (lists of 3) into a column of `width` by `height` pixels. */
  frame(points, width, height, margin = 1.06) {
    if (!points.length) return;
    const spans = [this.right, this.above, this.towards].map((axis) => {
      return points.reduce(
        ([low, top], point) => [Math.min(low, dot(point, axis)), Math.max(top, dot(point, axis))],
        [Infinity, -Infinity],
      );
    });
    this.target = [this.right, this.above, this.towards].reduce(
      (sum, axis, i) => plus(sum, scaled(axis, 0.5 * (spans[i][0] + spans[i][1]))),
      [0, 0, 0],
    );
    const [wide, high, deep] = spans.map(([low, top]) => top - low);
    const half = 0.5 * margin * Math.max(high, (wide * height) / Math.max(1, width), 1e-6);
    this.distance = half / this.half + 0.5 * deep;
    this.size = Math.max(wide, high, deep);
  }

  zoom(factor) {
    this.leaveShot();
    this.distance = clamp(this.distance * factor, 0.02 * this.size, 50 * this.size);
  }

  /** Move the target by a drag in pixels. */
  pan(dx, dy, height) {
    this.leaveShot();
    const perPixel = this.pixelSize(height);
    this.target = plus(this.target, plus(scaled(this.right, -dx * perPixel), scaled(this.above, dy * perPixel)));
  }

  /** Scene units per pixel in the plane through the target. */
  pixelSize(height) {
    return (2 * this.distance * this.half) / height;
  }

  get position() {
    return plus(this.target, scaled(this.towards, this.distance));
  }

  get fieldDegrees() {
    return (2 * Math.atan(this.half) * 180) / Math.PI;
  }

  /**
   * Projection into a column {left, top, width, height} of the canvas: a function from a root-space point
   * to [x, y, depth], in pixels and scene units; depth <= 0 is behind the viewer.
   */
  projector(column) {
    const eye = this.position;
    const focal = column.height / (2 * this.half);
    const [cx, cy] = [column.left + column.width / 2, column.top + column.height / 2];
    const { right, above, towards } = this;
    return (point) => {
      const offset = minus(point, eye);
      const depth = -dot(offset, towards);
      const scale = focal / Math.max(depth, 1e-9);
      return [cx + dot(offset, right) * scale, cy - dot(offset, above) * scale, depth];
    };
  }

  /** The point at pixel (x, y) of a column, in the plane parallel to the screen at `depth`. */
  unproject(column, x, y, depth) {
    const perPixel = (2 * this.half * depth) / column.height;
    const across = (x - column.left - column.width / 2) * perPixel;
    const upward = -(y - column.top - column.height / 2) * perPixel;
    const offset = plus(plus(scaled(this.right, across), scaled(this.above, upward)), scaled(this.towards, -depth));
    return plus(this.position, offset);
  }
}

export const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];

export function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Unit vector; null for a zero one. @returns {number[] | null} */
export function normalised(a) {
  const length = Math.hypot(...a);
  return length > 1e-12 ? scaled(a, 1 / length) : null;
}

const anyAcross = (up) => normalised(cross(Math.abs(up[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], up));
