// All characters of a page where they stand: the one that is posed, and the others by their own keys and clips.  Everything is in
// the root space of the first.

import { vec3 } from '../assets/gl-matrix.js';
import { IDENTITY, inverse, multiply } from './matrix.js';
import { alike, clamp } from './vectors.js';

export class Cast {
  /** `others`: the sessions of the other characters. */
  constructor(session, others) {
    this.session = session;
    this.others = others;
    this.seen = [];
    let pointCount = 0;
    const meshes = [session, ...others].flatMap(({ character }) => {
      const first = pointCount;
      pointCount += character.pointCount;
      return character.meshes.map((mesh) => ({ ...mesh, start: first + mesh.start }));
    });
    this.character = { ...session.character, meshes, pointCount };
    this.points = new Float32Array(3 * pointCount);
    session.deformer.points = this.points.subarray(0, session.deformer.points.length);
    session.showBase(); // for another one it may have been posed elsewhere
    session.reshape();
    this.follow();
  }

  /** Pose the others as they are at the frame shown. */
  follow() {
    const { session: { character, frame, neutral, deformer }, others, points } = this;
    const here = [frame, neutral, ...others.flatMap(({ keys, constants }) => [keys, constants])];
    if (alike(here, this.seen)) return;
    this.seen = here;
    const back = inverse(placeOf(character, frame)) ?? IDENTITY; // shrunk to nothing, as one that is hidden may be
    let at = deformer.points.length;
    for (const other of others) {
      const { values, weights, locals } = neutral
        ? { values: other.rest, weights: null, locals: null }
        : other.animation.at(frame, { keys: other.keys, constants: other.allConstants() });
      other.deformer.setBase(weights, locals);
      const shown = other.deformer.pose(values);
      points.set(shown, at);
      vec3.forEach(points, 3, at, shown.length / 3, vec3.transformMat4, multiply(placeOf(other.character, frame), back));
      at += shown.length;
    }
  }
}

/** From a character's root space to its stage at a frame. */
const placeOf = ({ toWorld, timeCodes }, frame) => toWorld[clamp(Math.round(frame - (timeCodes?.[0] ?? frame)), 0, toWorld.length - 1)];
