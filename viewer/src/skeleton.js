// Joints: what control values do to them, and the affine map by which a skinned point follows them.
// Mirrors usdrigui/character/deform.py: a local transform S R moves to exp(scales) S exp(rotations) R.

import { quat, quat2 } from '../assets/gl-matrix.js';
import * as matrix from './matrix.js';
import { ascending, known } from './vectors.js';

const SAME = 1e-8;

export class Skeletons {
  constructor(character) {
    this.joints = character.joints;
    this.count = this.joints.length;
    this.toRoot = character.skeletons.map((each) => each.toRoot.flat());
    this.unbind = this.joints.map((_, i) => matrix.inverse(character.bind.subarray(16 * i, 16 * i + 16)));
    this.restLocals = character.base;
    this.locals = character.base;
    this.factors = new Map();
    this.whole = [...this.joints.keys()];
  }

  /** Take other local transforms (an animation's frame) as the base; null takes the rig's own again. */
  setBase(locals) {
    this.locals = locals ?? this.restLocals;
    this.factors.clear();
  }

  /** Joints that must be known to place `joints`, parents first. */
  chainOf(joints) {
    const needed = new Set();
    for (let joint of joints) {
      for (; joint >= 0 && !needed.has(joint); joint = this.joints[joint].parent) needed.add(joint);
    }
    return ascending(needed);
  }

  /** Skinning matrices (inverse bind times pose) of the joints in `chain`, as a sparse list by joint. */
  skinning(moves, chain = this.whole) {
    const pose = new Array(this.count);
    const skinning = new Array(this.count);
    for (const joint of chain) {
      const local = this.localAt(joint, moves);
      const parent = this.joints[joint].parent;
      pose[joint] = parent < 0 ? local : matrix.multiply(local, pose[parent]);
      skinning[joint] = matrix.multiply(this.unbind[joint] ?? matrix.IDENTITY, pose[joint]);
    }
    return skinning;
  }

  /** Local transform of a joint after `moves`: nine numbers per joint (rotation, translation, scale). */
  localAt(joint, moves) {
    const base = this.locals.subarray(16 * joint, 16 * joint + 16);
    const at = 9 * joint;
    if (moves.subarray(at, at + 9).every((value) => value === 0)) return base;
    const { stretch, rotation } = known(this.factors, joint, () => matrix.polar(base));
    const turn = matrix.rotationOf(moves[at], moves[at + 1], moves[at + 2]);
    const turned = matrix.multiply3(matrix.multiply3(stretch, turn), rotation);
    const local = Array.from(base);
    for (let row = 0; row < 3; row++) {
      const scale = Math.exp(moves[at + 6 + row]);
      for (let column = 0; column < 3; column++) local[4 * row + column] = scale * turned[3 * row + column];
      local[12 + row] += moves[at + 3 + row];
    }
    return local;
  }

  /** Map (16) of one row of a skin's influences from mesh space to root space. */
  rowMap(skin, row, skinning, duals) {
    const blend = skin.dualQuaternion
      ? dualQuaternionMap(skin, row, duals ?? dualsOf(skinning))
      : linearMap(skin, row, skinning);
    const toRoot = this.toRoot[this.joints[skin.joints[0]].skeleton];
    return matrix.multiply(matrix.multiply(skin.bind, blend), toRoot);
  }

  /** Maps of all points of a skin: one map (12 numbers) when all used joints move as one, else one each. */
  maps(skin, skinning, size) {
    const used = usedJoints(skin);
    const toRoot = this.toRoot[this.joints[skin.joints[0]].skeleton];
    if (skin.sumsToOne && used.every((joint) => same(skinning[joint], skinning[used[0]], size))) {
      return packed([matrix.multiply(matrix.multiply(skin.bind, skinning[used[0]]), toRoot)]);
    }
    if (skin.sumsToOne && !skin.dualQuaternion) return this.linearMaps(skin, skinning, used, toRoot);
    const duals = skin.dualQuaternion ? dualsOf(skinning) : null;
    const rows = [];
    for (let row = 0; row < skin.rows; row++) rows.push(this.rowMap(skin, row, skinning, duals));
    return packed(rows);
  }

  /** Linear skinning at speed: each joint's map is composed once and only then blended. */
  linearMaps(skin, skinning, used, toRoot) {
    const whole = new Float64Array(12 * this.count);
    const maps = packed(used.map((j) => matrix.multiply(matrix.multiply(skin.bind, skinning[j]), toRoot)));
    used.forEach((joint, i) => whole.set(maps.subarray(12 * i, 12 * i + 12), 12 * joint));
    const out = new Float64Array(12 * skin.rows);
    for (let row = 0, i = 0; row < skin.rows; row++) {
      for (const end = i + skin.width; i < end; i++) {
        const weight = skin.weights[i];
        if (weight === 0) continue;
        const from = 12 * skin.joints[i];
        for (let k = 0; k < 12; k++) out[12 * row + k] += weight * whole[from + k];
      }
    }
    return out;
  }
}

/** Add to a decoded skin what evaluation needs. */
export function prepareSkin(skin) {
  skin.bind = skin.geomBind.flat();
  skin.sumsToOne = true;
  for (let row = 0; row < skin.rows && skin.sumsToOne; row++) {
    let total = 0;
    for (let i = row * skin.width; i < (row + 1) * skin.width; i++) total += skin.weights[i];
    skin.sumsToOne = Math.abs(total - 1) <= 1e-6;
  }
}

export function usedJoints(skin) {
  skin.used ??= ascending(skin.joints.filter((_, i) => skin.weights[i] !== 0));
  return skin.used;
}

function same(a, b, size) {
  for (let i = 0; i < 15; i++) if (Math.abs(a[i] - b[i]) > SAME * (i > 11 ? size : 1)) return false;
  return true;
}

/** Row-major 4x3 maps (12 numbers each): three linear rows, then the translation. */
function packed(maps) {
  const out = new Float64Array(12 * maps.length);
  maps.forEach((m, i) => {
    for (let row = 0; row < 4; row++) out.set([m[4 * row], m[4 * row + 1], m[4 * row + 2]], 12 * i + 3 * row);
  });
  return out;
}

function linearMap(skin, row, skinning) {
  const out = new Array(16).fill(0);
  for (let i = row * skin.width; i < (row + 1) * skin.width; i++) {
    const weight = skin.weights[i];
    if (weight === 0) continue;
    const m = skinning[skin.joints[i]];
    for (let j = 0; j < 16; j++) out[j] += weight * m[j];
  }
  out[15] = 1;
  return out;
}

/** Per joint: stretch, and the dual quaternion of rotation and translation. @returns {any[]} */
function dualsOf(skinning) {
  return skinning.map((m) => {
    const { stretch, rotation } = matrix.polar(m);
    return { stretch, dual: quat2.fromRotationTranslation(quat2.create(), matrix.quaternionOf(rotation), m.slice(12, 15)) };
  });
}

/** Dual-quaternion skinning (Kavan et al. 2007) with linearly blended stretch, as UsdSkel does it. */
function dualQuaternionMap(skin, row, duals) {
  const first = row * skin.width;
  let pivot = first;
  for (let i = first; i < first + skin.width; i++) if (skin.weights[i] > skin.weights[pivot]) pivot = i;
  const reference = duals[skin.joints[pivot]].dual;
  const stretch = new Array(9).fill(0);
  /** @type {any} */
  const sum = new Array(8).fill(0);
  for (let i = first; i < first + skin.width; i++) {
    const weight = skin.weights[i];
    if (weight === 0) continue;
    const joint = duals[skin.joints[i]];
    const signed = quat.dot(joint.dual, reference) < 0 ? -weight : weight;
    for (let k = 0; k < 9; k++) stretch[k] += weight * joint.stretch[k];
    for (let k = 0; k < 8; k++) sum[k] += signed * joint.dual[k];
  }
  quat2.normalize(sum, sum);
  return matrix.placed(matrix.multiply3(stretch, matrix.quaternionMatrix(sum)), /** @type {any} */ (quat2.getTranslation([0, 0, 0], sum)));
}
