// What programs have made of the samples that pages wrote, as keys: where a control has another value than its keys say,
// somebody has given it that value at that time.

import { animationOf, statesAt } from './animation_layer.js';
import { keysFrom } from './by_name.js';
import { withKey } from './interpolation.js';
import { polar, quaternionMatrix } from './matrix.js';
import { stringsIn, valuesIn } from './usda.js';
import { known } from './vectors.js';

const SAME = 1e-5; // of a control's range: single precision and a bit

/**
 * Keys, constant values and span of a stored work, and over them what others have `changed`: the texts of properties by their paths; `names` are
 * those that list names, `written` the paths of those that pages have written.
 */
export function withChanges(session, stored, { changed, names, written }) {
  const { controls, animation } = session;
  const work = keysFrom(stored, session);
  const keys = new Map(work.keys);
  const constants = new Map(work.constants);
  const values = Object.fromEntries(Object.entries(changed).map(([path, text]) => [path, valuesIn(text)]));
  const states = new Map();
  const stateAt = (time) => known(states, time, () => statesAt(session, [time], (when) => animation.at(when, work))[0]);
  controls.forEach(({ attribute, minimum, maximum }, control) => {
    const { samples, one } = values[attribute] ?? { samples: [], one: null };
    const isOurs = attribute in values && written.includes(attribute);
    // A page writes a sample for each key, or one value for all times.
    const kept = (keys.get(control) ?? []).filter(([frame]) => !isOurs || one !== null || samples.some(([time]) => time === frame));
    const stands = !samples.length && one !== null;
    const isAnimated = animation.isAnimated(control, keys);
    const times = kept.length ? kept.map(([frame]) => frame) : animation.range(work.keys, work.span);
    const said = [...readings(session, control, values, names, stateAt), ...(stands && isAnimated ? times.map((time) => [time, one]) : samples)];
    const isOther = ([time, value]) => value !== null && Math.abs(value - stateAt(time).values[control]) > SAME * (maximum - minimum);
    keys.set(control, said.filter(isOther).reduce((track, key) => withKey(track, ...key), kept));
    if (stands && !isAnimated) constants.set(control, one);
    else if (isOurs && !samples.length) constants.delete(control);
  });
  return { ...work, keys: new Map([...keys].filter(([, track]) => track.length)), constants };
}

/** The [time, value] that the weights or rotations of SkelAnimations give a control, as everything else is. */
function readings({ animation, controls, character: { channels, joints, skeletons } }, control, values, names, stateAt) {
  const { reading } = controls[control];
  if (!reading) return [];
  const [channel, rise] = reading.rises?.[0] ?? [];
  const joint = joints[reading.joint];
  // A channel's weight tells of the control that drives the fewest others with it.
  if (!joint && controls.some(({ reading: other }) => other?.rises?.[0][0] === channel && other.rises.length < reading.rises.length)) return [];
  const { token, index, animation: prim } = joint ? { token: joint.path, animation: animationOf(skeletons[joint.skeleton]) } : channels[channel];
  // A channel that no animation lists may be in any: of none its name begins with nothing.
  const found = Object.entries(values).filter(([path]) => path.endsWith(`${prim}.${joint ? 'rotations' : 'blendShapeWeights'}`));
  return found.flatMap(([path, { samples }]) => {
    const tokens = stringsIn(names[path.replace(/\w+$/, joint ? 'joints' : 'blendShapes')] ?? '');
    return samples.map(([time, rows]) => {
      const { values: shown, weights, locals } = stateAt(time);
      const row = rows?.[tokens.length ? tokens.indexOf(token) : index];
      const [w, x, y, z] = (joint && row) || [];
      const turned = (rotation) => animation.turned(reading, rotation);
      return [time, shown[control] + (joint ? turned(quaternionMatrix([x, y, z, w])) - turned(polar(locals[reading.joint]).rotation) : ((row ?? NaN) - weights[channel]) / rise)];
    });
  });
}
