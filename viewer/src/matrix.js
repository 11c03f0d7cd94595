// 4x4 matrices in USD's row-vector convention (p' = p M), as 16 numbers row by row; rotations and
// polar factors as 9 numbers row by row.

import { cross, plus, scaled } from './camera.js';
import { dot, mixed, unit } from './vectors.js';

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export function multiply(a, b) {
  const out = new Array(16);
  for (let i = 0; i < 16; i += 4) {
    for (let j = 0; j < 4; j++) {
      out[i + j] = a[i] * b[j] + a[i + 1] * b[4 + j] + a[i + 2] * b[8 + j] + a[i + 3] * b[12 + j];
    }
  }
  return out;
}

/** Inverse of an affine matrix; null when it has none. */
export function inverse(m) {
  const r = inverse3(linearOf(m));
  if (!r) return null;
  const [x, y, z] = [m[12], m[13], m[14]];
  return placed(r, -(x * r[0] + y * r[3] + z * r[6]), -(x * r[1] + y * r[4] + z * r[7]), -(x * r[2] + y * r[5] + z * r[8]));
}

/** The transform with a linear part (9) and a translation. */
export const placed = (r, x, y, z) => [r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, r[6], r[7], r[8], 0, x, y, z, 1];

export const transformPoint = (m, x, y, z) => [0, 1, 2].map((axis) => x * m[axis] + y * m[4 + axis] + z * m[8 + axis] + m[12 + axis]);

const rowsOf = (m) => [m.slice(0, 3), m.slice(3, 6), m.slice(6, 9)];

export function determinant3(m) {
  const [a, b, c] = rowsOf(m);
  return dot(a, cross(b, c));
}

export function inverse3(m) {
  const [a, b, c] = rowsOf(m);
  const columns = [cross(b, c), cross(c, a), cross(a, b)];
  const d = dot(a, columns[0]);
  return Math.abs(d) > 1e-300 ? transposed3(columns.flat()).map((value) => value / d) : null;
}

export function multiply3(a, b) {
  const out = new Array(9);
  for (let i = 0; i < 9; i += 3) {
    for (let j = 0; j < 3; j++) out[i + j] = a[i] * b[j] + a[i + 1] * b[3 + j] + a[i + 2] * b[6 + j];
  }
  return out;
}

/** The upper left of a transform. */
const linearOf = (m) => [0, 1, 2, 4, 5, 6, 8, 9, 10].map((i) => m[i]);

export const transposed3 = (m) => [0, 3, 6, 1, 4, 7, 2, 5, 8].map((i) => m[i]);

/** M = S R: stretch S and rotation R of positive determinant, by Higham's iteration for the polar factor. */
export function polar(m) {
  const linear = linearOf(m);
  let q = linear;
  for (let step = 0; step < 60; step++) {
    const back = inverse3(transposed3(q));
    if (!back) return { stretch: linear, rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
    const next = q.map((value, i) => 0.5 * (value + back[i]));
    const change = next.reduce((most, value, i) => Math.max(most, Math.abs(value - q[i])), 0);
    q = next;
    if (change < 1e-14) break;
  }
  const sign = Math.sign(determinant3(q)) || 1;
  const rotation = q.map((value) => value * sign);
  return { stretch: multiply3(linear, transposed3(rotation)), rotation };
}

/** Rotation matrix for row vectors of the rotation vector (x, y, z) in radians (Rodrigues). */
export function rotationOf(x, y, z) {
  const angle = Math.hypot(x, y, z);
  const a = angle < 1e-8 ? 1 : Math.sin(angle) / angle;
  const half = angle < 1e-8 ? 1 : Math.sin(angle / 2) / (angle / 2);
  const skew = [0, z, -y, -z, 0, x, y, -x, 0];
  const square = multiply3(skew, skew);
  return skew.map((value, i) => (i % 4 === 0 ? 1 : 0) + a * value + 0.5 * half * half * square[i]);
}

/** Unit quaternion [w, x, y, z] of a rotation matrix for row vectors. */
export function quaternionOf(r) {
  const [m00, m01, m02, m10, m11, m12, m20, m21, m22] = transposed3(r);
  const trace = m00 + m11 + m22;
  const largest = Math.max(trace, m00, m11, m22);
  let q;
  if (largest === trace) q = [1 + trace, m21 - m12, m02 - m20, m10 - m01];
  else if (largest === m00) q = [m21 - m12, 1 + 2 * m00 - trace, m01 + m10, m02 + m20];
  else if (largest === m11) q = [m02 - m20, m01 + m10, 1 + 2 * m11 - trace, m12 + m21];
  else q = [m10 - m01, m02 + m20, m12 + m21, 1 + 2 * m22 - trace];
  return unit(q);
}

/** Hamilton product of two quaternions [w, x, y, z]. @param {number[]} p @param {number[]} q */
export function quaternionProduct(p, q) {
  const [[w, ...a], [v, ...b]] = [p, q];
  return [w * v - dot(a, b), ...plus(cross(a, b), plus(scaled(b, w), scaled(a, v)))];
}

/** Rotation matrix (9) for row vectors of a unit quaternion. */
export function quaternionMatrix([w, x, y, z]) {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y),
    2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
    2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y),
  ];
}

/** Rotation vector (x, y, z) in radians, at most half a turn, of a rotation matrix for row vectors. */
export function rotationVector(r) {
  const q = quaternionOf(r);
  const [w, ...axis] = q[0] < 0 ? q.map((value) => -value) : q;
  const sine = Math.hypot(...axis);
  const factor = sine < 1e-12 ? 2 : (2 * Math.atan2(sine, w)) / sine;
  return axis.map((value) => factor * value);
}

/** Translation, unit quaternion [w, x, y, z] and scales of a transform without shear, as a SkelAnimation holds them. */
export function decomposed(m) {
  const rows = [0, 4, 8].map((at) => Array.from(m.slice(at, at + 3)));
  const scale = rows.map((row) => Math.hypot(...row) || 1);
  const mirror = determinant3(rows.flat()) < 0 ? -1 : 1;
  const turned = rows.flatMap((row, i) => row.map((value) => value / (scale[i] * mirror)));
  return { translation: Array.from(m.slice(12, 15)), rotation: quaternionOf(turned), scale: scale.map((value) => value * mirror) };
}

/** A transform between two as USD interpolates them: translations and scales linearly, rotations on the sphere. */
export function between(before, after, share) {
  const [a, b] = [decomposed(before), decomposed(after)];
  const both = (name) => a[name].map((value, i) => mixed(value, b[name][i], share));
  const [scale, rotation] = [both('scale'), quaternionMatrix(slerp(a.rotation, b.rotation, share))];
  const linear = rotation.map((value, i) => value * scale[Math.floor(i / 3)]);
  const [x, y, z] = both('translation');
  return placed(linear, x, y, z);
}

/** The shorter way between two unit quaternions. */
export function slerp(a, b, share) {
  const cosine = dot(a, b);
  const angle = Math.acos(Math.min(1, Math.abs(cosine)));
  const sine = Math.sin(angle);
  const [from, to] = sine < 1e-6 ? [1 - share, share] : [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
  const q = a.map((value, i) => from * value + Math.sign(cosine || 1) * to * b[i]);
  return unit(q);
}
