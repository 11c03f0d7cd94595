// Evaluation of the character at a pose, on the CPU with active shapes only; mirrors usdrigui/character/deform.py.

import * as matrix from './matrix.js';
import { Skeletons, prepareSkin, usedJoints } from './skeleton.js';
import { ascending, mixed, shareAt } from './vectors.js';

export class Deformer {
  constructor(character) {
    this.character = character;
    this.controls = character.controls;
    this.baseWeights = Float64Array.from(character.baseWeights);
    this.weights = new Float64Array(character.channels.length);
    this.moves = new Float64Array(9 * character.joints.length);
    this.skeletons = new Skeletons(character);
    this.points = new Float32Array(3 * character.pointCount);
    for (const mesh of character.meshes) prepareMesh(mesh);
    this.jointsAt = null;
  }

  /** Take other channel weights and joint transforms (an animation's frame) as the base pose. */
  setBase(weights, locals) {
    this.baseWeights = Float64Array.from(weights ?? this.character.baseWeights);
    this.skeletons.setBase(locals);
    this.jointsAt = null;
  }

  /** Set channel weights and joint moves from control values, without computing any point. */
  drive(values) {
    this.weights.set(this.baseWeights);
    this.moves.fill(0);
    for (let i = 0; i < this.controls.length; i++) {
      if (values[i] !== this.controls[i].default) this.addDrive(i, values[i]);
    }
  }

  /** Add what a control drives at a value, or with `sign` -1 take it away. */
  addDrive(index, value, sign = 1) {
    const { drive } = this.controls[index];
    const [key, share] = shareAt(drive.values, value);
    const at = (rows, i) => sign * mixed(rows[key][i], rows[key + 1][i], share);
    drive.channels.forEach((channel, i) => (this.weights[channel] += at(drive.weights, i)));
    drive.joints.forEach((joint, i) => {
      [drive.rotations, drive.translations, drive.scales].forEach((rows, part) => {
        for (let axis = 0; axis < 3; axis++) {
          const to = 9 * joint + 3 * part + axis;
          this.moves[to] = settled(this.moves[to] + sign * mixed(rows[key][i][axis], rows[key + 1][i][axis], share));
        }
      });
    });
  }

  /** Compute `points` (root space, 3 per point) at control values. */
  pose(values) {
    this.drive(values);
    this.updateMaps();
    for (const mesh of this.character.meshes) if (mesh.visible) this.poseMesh(mesh);
    return this.points;
  }

  /** All points at control values, apart from those that are shown. */
  posedAside(values) {
    const shown = this.points;
    this.points = new Float32Array(shown.length);
    const found = this.pose(values);
    this.points = shown;
    return found;
  }

  /** Renew the meshes' maps when joints have moved since the last time. */
  updateMaps() {
    const { jointsAt, moves } = this;
    if (jointsAt && moves.every((value, i) => value === jointsAt[i])) return;
    const skinning = this.skeletons.skinning(moves);
    for (const mesh of this.character.meshes) {
      if (mesh.skin) mesh.maps = this.skeletons.maps(mesh.skin, skinning, mesh.size);
      mesh.plain = mesh.maps.length === 12 && isIdentity(mesh.maps);
    }
    this.jointsAt = moves.slice();
  }

  poseMesh(mesh) {
    const out = this.points.subarray(3 * mesh.start, 3 * (mesh.start + mesh.count));
    const blended = mesh.plain ? out : (mesh.blended ??= new Float32Array(mesh.points.length));
    blended.set(mesh.points);
    for (const shape of mesh.shapes) {
      const weight = this.weights[shape.channel];
      if (weight !== 0) addShape(shape, weight, blended);
    }
    if (!mesh.plain) applyMaps(blended, mesh.maps, out);
  }

  // --- single points ---------------------------------------------------------------------------------

  /** Everything that is needed to evaluate one point often: its shapes, influences and joints; or a joint's alone. */
  tracer(meshIndex, point, joint = -1) {
    const mesh = this.character.meshes[meshIndex];
    const shapes = [];
    for (const shape of mesh.shapes) {
      const row = shape.points.indexOf(point);
      if (row >= 0) shapes.push({ shape, row });
    }
    const tracer = { mesh, point, shapes, row: 0, chain: /** @type {number[]} */ ([]), skin: mesh.skin };
    if (mesh.skin && joint >= 0) {
      tracer.skin = { ...mesh.skin, joints: Uint16Array.of(joint), weights: Float64Array.of(1), rows: 1, width: 1 };
      tracer.chain = this.skeletons.chainOf([joint]);
    } else if (mesh.skin) {
      tracer.row = mesh.skin.rows === 1 ? 0 : point;
      const from = tracer.row * mesh.skin.width;
      const joints = mesh.skin.joints.subarray(from, from + mesh.skin.width);
      tracer.chain = this.skeletons.chainOf(joints.filter((_, i) => mesh.skin.weights[from + i] !== 0));
    }
    return tracer;
  }

  /** Root-space position of a traced point at the weights and moves last driven. */
  trace(tracer, map = this.traceMap(tracer)) {
    const [x, y, z] = this.traceBlend(tracer);
    return matrix.transformPoint(map, x, y, z);
  }

  traceBlend({ mesh, point, shapes }) {
    const at = Array.from(mesh.points.subarray(3 * point, 3 * point + 3));
    for (const { shape, row } of shapes) {
      const weight = this.weights[shape.channel];
      if (weight === 0) continue;
      forShares(shape, weight, (inbetween, share) => {
        const from = 3 * (inbetween * shape.points.length + row);
        for (let axis = 0; axis < 3; axis++) at[axis] += share * shape.step * shape.offsets[from + axis];
      });
    }
    return at;
  }

  /** Map (16) of a traced point from mesh space to root space. */
  traceMap({ mesh, skin, row, chain }) {
    if (!skin) return mesh.root;
    return this.skeletons.rowMap(skin, row, this.skeletons.skinning(this.moves, chain));
  }

  /** Run `use` with control `index` at `value` instead of `now`; the driven state is restored exactly. */
  withControl(index, now, value, use) {
    const { drive } = this.controls[index];
    const weights = drive.channels.map((channel) => this.weights[channel]);
    const moves = drive.joints.map((joint) => this.moves.slice(9 * joint, 9 * joint + 9));
    this.addDrive(index, now, -1);
    this.addDrive(index, value);
    const result = use();
    drive.channels.forEach((channel, i) => (this.weights[channel] = weights[i]));
    drive.joints.forEach((joint, i) => this.moves.set(moves[i], 9 * joint));
    return result;
  }
}

/** Differences that are rounding only count as none, so that joints at rest keep their exact transform. */
const settled = (value) => (Math.abs(value) < 1e-14 ? 0 : value);

function prepareMesh(mesh) {
  mesh.root = mesh.toRoot.flat();
  mesh.size = mesh.points.reduce((most, value) => Math.max(most, Math.abs(value)), 1e-30);
  mesh.maps = Float64Array.from([0, 1, 2, 3].flatMap((row) => mesh.root.slice(4 * row, 4 * row + 3)));
  mesh.plain = isIdentity(mesh.maps);
  if (mesh.skin) {
    prepareSkin(mesh.skin);
    usedJoints(mesh.skin);
  }
  for (const shape of mesh.shapes) {
    shape.nodes = ascending([...shape.weights, 0]);
    shape.zero = shape.nodes.indexOf(0);
  }
}

function isIdentity(map) {
  return [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0].every((value, i) => Math.abs(map[i] - value) < 1e-12);
}

/** Call `use(inbetween, share)` for the rows of offsets that act at `weight`. */
function forShares(shape, weight, use) {
  if (shape.weights.length === 1) {
    use(0, weight);
    return;
  }
  const [i, share] = shareAt(shape.nodes, weight);
  for (const [node, amount] of [[i, 1 - share], [i + 1, share]]) {
    if (node !== shape.zero && amount !== 0) use(node > shape.zero ? node - 1 : node, amount);
  }
}

function addShape(shape, weight, blended) {
  const { points, offsets, step } = shape;
  const count = points.length;
  forShares(shape, weight, (inbetween, share) => {
    const scale = share * step;
    let from = 3 * inbetween * count;
    for (let i = 0; i < count; i++, from += 3) {
      const to = 3 * points[i];
      blended[to] += scale * offsets[from];
      blended[to + 1] += scale * offsets[from + 1];
      blended[to + 2] += scale * offsets[from + 2];
    }
  });
}

function applyMaps(points, maps, out) {
  const stride = maps.length === 12 ? 0 : 12;
  for (let i = 0, m = 0; i < points.length; i += 3, m += stride) {
    const x = points[i];
    const y = points[i + 1];
    const z = points[i + 2];
    out[i] = x * maps[m] + y * maps[m + 3] + z * maps[m + 6] + maps[m + 9];
    out[i + 1] = x * maps[m + 1] + y * maps[m + 4] + z * maps[m + 7] + maps[m + 10];
    out[i + 2] = x * maps[m + 2] + y * maps[m + 5] + z * maps[m + 8] + maps[m + 11];
  }
}
