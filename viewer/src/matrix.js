// 4x4 matrices in USD's row-vector convention (p' = p M), as 16 numbers row by row; rotations and polar factors as 9 numbers
// row by row; quaternions as [x, y, z, w].  To gl-matrix the same numbers are columns, for column vectors: a product is turned round.

import { glMatrix, mat3, mat4, quat, vec3 } from '../assets/gl-matrix.js';
import { mixed } from './vectors.js';

glMatrix.setMatrixArrayType(Array); // of double precision

/** @typedef {any} Numbers of one of gl-matrix's kinds, which are lists here */

/** @type {Numbers} */
export const IDENTITY = mat4.create();

/** @param {Numbers} a @param {Numbers} b @returns {Numbers} */
export const multiply = (a, b) => mat4.multiply(mat4.create(), b, a);

/** Inverse of an affine matrix; null when it has none. @param {Numbers} m @returns {Numbers} */
export const inverse = (m) => mat4.invert(mat4.create(), m);

/** @returns {Numbers} */
export const transformPoint = (m, x, y, z) => vec3.transformMat4(vec3.create(), [x, y, z], m);

/** @param {Numbers} a @param {Numbers} b @returns {Numbers} */
export const multiply3 = (a, b) => mat3.multiply(mat3.create(), b, a);

/** @param {Numbers} m @returns {Numbers} */
export const transposed3 = (m) => mat3.transpose(mat3.create(), m);

/** The upper left of a transform. @param {Numbers} m @returns {Numbers} */
const linearOf = (m) => mat3.fromMat4(mat3.create(), m);

/** The transform with a linear part (9) and a translation. */
export const placed = (r, [x, y, z]) => [r[0], r[1], r[2], 0, r[3], r[4], r[5], 0, r[6], r[7], r[8], 0, x, y, z, 1];

/** M = S R: stretch S and rotation R of positive determinant, by Higham's iteration for the polar factor. */
export function polar(m) {
  const linear = linearOf(m);
  let q = linear;
  for (let step = 0; step < 60; step++) {
    /** @type {Numbers} */
    const back = mat3.invert(mat3.create(), transposed3(q));
    if (!back) return { stretch: linear, rotation: mat3.create() };
    const next = q.map((value, i) => 0.5 * (value + back[i]));
    const change = next.reduce((most, value, i) => Math.max(most, Math.abs(value - q[i])), 0);
    q = next;
    if (change < 1e-14) break;
  }
  const sign = Math.sign(mat3.determinant(q)) || 1;
  const rotation = q.map((value) => value * sign);
  return { stretch: multiply3(linear, transposed3(rotation)), rotation };
}

/** Rotation matrix for row vectors of the rotation vector (x, y, z) in radians. */
export function rotationOf(x, y, z) {
  const angle = Math.hypot(x, y, z) || 1e-300;
  return quaternionMatrix(quat.setAxisAngle(quat.create(), [x / angle, y / angle, z / angle], angle));
}

/** Unit quaternion of a rotation matrix for row vectors. @param {Numbers} r @returns {Numbers} */
export const quaternionOf = (r) => quat.normalize(quat.create(), quat.fromMat3(quat.create(), r));

/** Rotation matrix (9) for row vectors of a unit quaternion. @param {Numbers} q @returns {Numbers} */
export const quaternionMatrix = (q) => mat3.fromQuat(mat3.create(), q);

/** Rotation vector (x, y, z) in radians, at most half a turn, of a rotation matrix for row vectors. */
export function rotationVector(r) {
  const q = quaternionOf(r);
  const [x, y, z, w] = q[3] < 0 ? q.map((value) => -value) : q;
  const sine = Math.hypot(x, y, z);
  const factor = sine < 1e-12 ? 2 : (2 * Math.atan2(sine, w)) / sine;
  return [x, y, z].map((value) => factor * value);
}

/** Translation, unit quaternion and scales of a transform without shear, as a SkelAnimation holds them. @param {Numbers} m */
export function decomposed(m) {
  const linear = linearOf(m);
  const mirror = mat3.determinant(linear) < 0 ? -1 : 1;
  /** @type {Numbers[]} */
  const [lengths, translation] = [mat4.getScaling(vec3.create(), m), mat4.getTranslation(vec3.create(), m)];
  const scale = lengths.map((length) => mirror * (length || 1));
  return { translation, scale, rotation: quaternionOf(linear.map((value, i) => value / scale[Math.floor(i / 3)])) };
}

/** A transform between two as USD interpolates them: translations and scales linearly, rotations on the sphere. @returns {Numbers} */
export function between(before, after, share) {
  const [a, b] = [decomposed(before), decomposed(after)];
  const both = (name) => a[name].map((value, i) => mixed(value, b[name][i], share));
  const rotation = quat.slerp(quat.create(), a.rotation, b.rotation, share);
  return mat4.fromRotationTranslationScale(mat4.create(), rotation, both('translation'), both('scale'));
}
