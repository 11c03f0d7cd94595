// The colour of an eye that has none of its own, by where a point lies on the ball: usdrigui/view/body/shading.py has the
// same, for pictures.  Drawers multiply what they drew as white by `tints`.

import { clamp } from './vectors.js';

const STEPS = 256;
const REACH = 0.75; // radii from the middle of the pupil; beyond, all is white

/** (STEPS x 3) factors on the white of an eye, by the distance from the middle of the pupil in steps of `perStep`. */
export function tints({ pupil, iris, white, radii }) {
  const out = new Float32Array(3 * STEPS);
  for (let step = 0; step < STEPS; step++) {
    const away = ((step + 0.5) * REACH) / STEPS;
    const rim = 1 - 0.6 * smooth(0.75 * radii[1], radii[1], away);
    const open = smooth(radii[0] - 0.015, radii[0] + 0.015, away);
    const beyond = smooth(radii[1] - 0.025, radii[1] + 0.025, away);
    for (let k = 0; k < 3; k++) {
      const inner = pupil[k] + open * (rim * iris[k] - pupil[k]);
      out[3 * step + k] = (inner + beyond * (white[k] - inner)) / white[k];
    }
  }
  return { factors: out, perRadius: STEPS / REACH, last: STEPS - 1 };
}

/** Per triangle, 1 where all its corners lie on an eyeball: `gaze` has two numbers per point, large ones off the eyes. */
export function onEyes(triangles, gaze) {
  const out = new Uint8Array(triangles.length / 3);
  for (let t = 0, k = 0; t < triangles.length; t += 3, k++) {
    out[k] = [0, 1, 2].every((corner) => Math.abs(gaze[2 * triangles[t + corner]]) < 3) ? 1 : 0;
  }
  return out;
}

export function smooth(low, high, value) {
  const t = clamp((value - low) / (high - low), 0, 1);
  return t * t * (3 - 2 * t);
}
