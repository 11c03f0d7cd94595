// Areas of influence: how far each point moves when a control goes through its range, and which controls
// move a given point most.

import { mat3 } from '../assets/gl-matrix.js';
import { minus } from './camera.js';
import { dot, known } from './vectors.js';

const GOOD_WAY = 64; // of 255: a quarter of the way that the point goes that moves most

export class Influence {
  constructor(character, deformer, rest) {
    this.character = character;
    this.deformer = deformer;
    this.rest = rest;
    this.known = new Map();
    this.peaks = new Map();
    this.sideways = new Map();
  }

  /** The longest way that a control moves any point over its range, in scene units. */
  peak(index) {
    return known(this.peaks, index, () => this.longest(index));
  }

  /** Of a control without joints: its shapes' largest offsets, and the scale of the mesh's map. */
  longest(index) {
    const { drive, minimum, maximum } = this.character.controls[index];
    if (drive.joints.length) {
      this.ofControl(index);
      return this.peaks.get(index);
    }
    const span = maximum - minimum;
    const slope = (i) => {
      const steps = drive.values.slice(1).map((value, k) => Math.abs((drive.weights[k + 1][i] - drive.weights[k][i]) / (value - drive.values[k])));
      return span * Math.max(...steps);
    };
    const reach = new Map(drive.channels.map((channel, i) => [channel, slope(i)]));
    return Math.max(0, ...this.character.meshes.flatMap((mesh) =>
      mesh.shapes.filter(({ channel }) => reach.has(channel)).map((shape) => reach.get(shape.channel) * largestOffset(shape) * scaleOf(mesh.maps)),
    ));
  }

  /** Share of a control's motion that goes to one side, 0 to 1: its mean along `normal` over its mean length. */
  sidewaysOf(index, normal) {
    return known(this.sideways, index, () => {
      const { minimum, maximum } = this.character.controls[index];
      const [still, ...ends] = this.pointsAt(index, [this.rest[index], minimum, maximum]);
      return Math.max(...ends.map((end) => sideways(still, end, normal)));
    });
  }

  /** Whether a control moves joints, and by these at least half of the character's points a good way. */
  isWide(index) {
    if (!this.character.controls[index].drive.joints.length) return false;
    const heat = this.ofControl(index);
    return heat.filter((value) => value > GOOD_WAY).length > 0.5 * heat.length;
  }

  /** 0 to 255 per point: displacement at the stronger end of the range, relative to the control's largest. */
  ofControl(index) {
    return known(this.known, index, () => this.measure(index));
  }

  /** The largest influence of several controls at each point. */
  ofControls(indices) {
    const maps = indices.map((index) => this.ofControl(index));
    if (maps.length === 1) return maps[0];
    return maps[0].map((value, point) => maps.reduce((most, map) => Math.max(most, map[point]), value));
  }

  measure(index) {
    const control = this.character.controls[index];
    const ends = [...new Set([control.minimum, control.maximum])].filter((end) => end !== this.rest[index]);
    const [still, ...poses] = this.pointsAt(index, [this.rest[index], ...ends]);
    const ways = new Float32Array(still.length / 3);
    for (const moved of poses) {
      for (let point = 0, i = 0; point < ways.length; point++, i += 3) {
        ways[point] = Math.max(ways[point], Math.hypot(moved[i] - still[i], moved[i + 1] - still[i + 1], moved[i + 2] - still[i + 2]));
      }
    }
    const most = ways.reduce((a, b) => Math.max(a, b), 0);
    if (control.drive.joints.length) this.peaks.set(index, most);
    return Uint8Array.from(ways, (way) => (most > 0 ? Math.round((255 * way) / most) : 0));
  }

  /** All points with control `index` at each of `ends` and the others at rest; what is shown stays as it is. */
  pointsAt(index, ends) {
    const { deformer } = this;
    const values = Float64Array.from(this.rest);
    return ends.map((end) => {
      values[index] = end;
      return deformer.posedAside(values);
    });
  }

  /** Controls that move a place of the skin, where it is said by `at`, strongest first: [{control, distance, share}]. */
  rank(values, at) {
    const { deformer } = this;
    deformer.drive(values);
    const found = this.character.controls.map((control, index) => {
      const ends = [control.minimum, control.maximum, this.rest[index]];
      const [low, high, rest] = ends.map((end) => deformer.withControl(index, values[index], end, at));
      const distance = Math.max(...[[low, rest], [high, rest], [low, high]].map(([a, b]) => Math.hypot(...minus(a, b))));
      return { control: index, distance };
    });
    const most = found.reduce((a, { distance }) => Math.max(a, distance), 0);
    return found
      .filter(({ distance }) => distance > 1e-3 * most)
      .sort((a, b) => b.distance - a.distance || a.control - b.control)
      .map((each) => ({ ...each, share: each.distance / most }));
  }
}

/** The sum of all motion along `normal`, as a share of the sum of its lengths. */
function sideways(still, moved, normal) {
  let along = 0;
  let length = 0;
  for (let i = 0; i < still.length; i += 3) {
    const way = [moved[i] - still[i], moved[i + 1] - still[i + 1], moved[i + 2] - still[i + 2]];
    along += dot(way, normal);
    length += Math.hypot(...way);
  }
  return length > 0 ? Math.abs(along) / length : 0;
}

/** Largest offset of a shape per unit of weight. */
function largestOffset(shape) {
  shape.largest ??= shape.weights.reduce((largest, weight, k) => {
    const from = 3 * k * shape.points.length;
    let most = 0;
    for (let i = from; i < from + 3 * shape.points.length; i += 3) {
      most = Math.max(most, Math.hypot(shape.offsets[i], shape.offsets[i + 1], shape.offsets[i + 2]));
    }
    return Math.max(largest, (most * shape.step) / Math.abs(weight));
  }, 0);
  return shape.largest;
}

/** Mean scale of the first of a mesh's maps. */
const scaleOf = (map) => Math.cbrt(Math.abs(mat3.determinant(map)));
