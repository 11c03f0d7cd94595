// Poses out and in: as JSON for people and scripts, and as a USD layer with time samples for the stage.

import { determinant3, quaternionOf } from './matrix.js';

/** The pose as JSON text: values by control name, those away from their defaults only. */
export function poseToJson(session) {
  const values = {};
  session.controls.forEach((control, index) => {
    if (session.values[index] !== control.default) values[control.name] = rounded(session.values[index]);
  });
  return `${JSON.stringify({ usdrigui: 'pose', root: session.character.root, values }, null, 2)}\n`;
}

/**
 * Values by control index from JSON text; controls that it does not name take their defaults.
 * Throws an Error for people when the text is no pose.
 */
export function poseFromJson(text, session) {
  let found;
  try {
    found = JSON.parse(text);
  } catch {
    throw new Error('This is not JSON.');
  }
  const values = found?.values ?? found;
  if (values === null || typeof values !== 'object' || Array.isArray(values)) throw new Error('This JSON holds no pose.');
  const known = session.controls.filter(({ name }) => Number.isFinite(values[name]));
  if (!known.length && Object.keys(values).length) throw new Error('No control of this character is named in the pose.');
  return session.controls.map((control, index) => [index, Number.isFinite(values[control.name]) ? values[control.name] : control.default]);
}

/**
 * A USD layer, as usda text, that animates the character: an over on every SkelAnimation, with time
 * samples of `frames`: [{time, values}].  Put it above the asset in `subLayers`, or sublayer both.
 */
export function poseToUsda(session, frames, framesPerSecond) {
  const states = frames.map(({ time, values }) => ({ time, ...stateAt(session, values) }));
  const animations = animationsOf(session);
  const overs = [...animations].map(([path, animation]) => ({
    path: path.split('/').filter(Boolean),
    lines: animationLines(session, animation, states),
  }));
  const controls = JSON.stringify({ names: session.controls.map(({ name }) => name), frames: frames.map(frameValues) });
  const first = session.character.root.split('/')[1] ?? '';
  return [
    '#usda 1.0',
    '(',
    `    defaultPrim = ${quoted(first)}`,
    `    startTimeCode = ${number(frames[0].time)}`,
    `    endTimeCode = ${number(frames.at(-1).time)}`,
    `    timeCodesPerSecond = ${number(framesPerSecond)}`,
    `    framesPerSecond = ${number(framesPerSecond)}`,
    '    customLayerData = {',
    '        dictionary usdrigui = {',
    `            string controls = ${quoted(controls)}`,
    '        }',
    '    }',
    ')',
    '',
    ...nestedOvers(overs),
    '',
  ].join('\n');
}

const frameValues = ({ time, values }) => ({ time, values: Array.from(values, rounded) });

/** Frames [{time, values}] from a layer that `poseToUsda` wrote; throws an Error for people otherwise. */
export function framesFromUsda(text, session) {
  const match = /string controls = ("(?:[^"\\]|\\.)*")/.exec(text);
  if (!text.startsWith('#usda') || !match) throw new Error('This layer was not written by the viewer.');
  const { names, frames } = JSON.parse(unquoted(match[1]));
  const at = new Map(names.map((name, i) => [name, i]));
  const present = session.controls.some(({ name }) => at.has(name));
  if (!present) throw new Error('No control of this character is named in the layer.');
  return frames.map(({ time, values }) => ({
    time,
    values: Float64Array.from(session.controls, ({ name, default: rest }) => values[at.get(name)] ?? rest),
  }));
}

// --- USD text ----------------------------------------------------------------------------------------

/** Channel weights and local joint transforms at control values. */
function stateAt(session, values) {
  const { deformer } = session;
  deformer.drive(values);
  const state = {
    weights: Array.from(deformer.weights),
    locals: session.character.joints.map((_, joint) => Array.from(deformer.skeletons.localAt(joint, deformer.moves))),
  };
  deformer.drive(session.values);
  return state;
}

/** What to write on each SkelAnimation: its channels by position, and its joints if any control moves one. */
function animationsOf(session) {
  const { channels, joints, skeletons } = session.character;
  const found = new Map();
  const at = (path) => {
    if (!found.has(path)) found.set(path, { channels: [], joints: [] });
    return found.get(path);
  };
  channels.forEach(({ animation, index }, channel) => {
    if (animation && index >= 0) at(animation).channels[index] = channel;
  });
  if (session.controls.some(({ drive }) => drive.joints.length)) {
    joints.forEach(({ skeleton }, joint) => {
      if (skeletons[skeleton].animation) at(skeletons[skeleton].animation).joints.push(joint);
    });
  }
  return found;
}

function animationLines(session, { channels, joints }, states) {
  const lines = [];
  if (channels.length) {
    const weights = ({ weights }) => Array.from(channels, (channel) => number(channel === undefined ? 0 : weights[channel]));
    lines.push(...samples('float[] blendShapeWeights', states, weights));
  }
  if (joints.length) {
    const parts = states.map(({ time, locals }) => ({ time, parts: joints.map((joint) => decomposed(locals[joint])) }));
    const of = (name) => (state) => state.parts.map((part) => `(${part[name].map(number).join(', ')})`);
    const tokens = joints.map((joint) => quoted(session.character.joints[joint].path));
    lines.push(`uniform token[] joints = [${tokens.join(', ')}]`);
    lines.push(...samples('quatf[] rotations', parts, of('rotation')));
    lines.push(...samples('half3[] scales', parts, of('scale')));
    lines.push(...samples('float3[] translations', parts, of('translation')));
  }
  return lines;
}

function samples(attribute, states, items) {
  const rows = states.map((state) => `    ${number(state.time)}: [${items(state).join(', ')}],`);
  return [`${attribute}.timeSamples = {`, ...rows, '}'];
}

/** Translation, quaternion [w, x, y, z] and scales of a local transform (a SkelAnimation holds no shear). */
function decomposed(local) {
  const rows = [0, 4, 8].map((at) => local.slice(at, at + 3));
  const scale = rows.map((row) => Math.hypot(...row) || 1);
  const mirror = determinant3(rows.flat()) < 0 ? -1 : 1;
  const unit = rows.flatMap((row, i) => row.map((value) => value / (scale[i] * mirror)));
  return { translation: local.slice(12, 15), rotation: quaternionOf(unit), scale: scale.map((value) => value * mirror) };
}

/** Overs nested by path, paths that share ancestors sharing the overs. */
function nestedOvers(overs) {
  const tree = { children: new Map(), lines: [] };
  for (const { path, lines } of overs) {
    let node = tree;
    for (const name of path) {
      if (!node.children.has(name)) node.children.set(name, { children: new Map(), lines: [] });
      node = node.children.get(name);
    }
    node.lines = lines;
  }
  const written = (node, indent) =>
    [...node.children].flatMap(([name, child]) => [
      `${indent}over ${quoted(name)}`,
      `${indent}{`,
      ...child.lines.map((line) => `${indent}    ${line}`),
      ...written(child, `${indent}    `),
      `${indent}}`,
    ]);
  return written(tree, '');
}

function quoted(text) {
  const escaped = text.replace(/["\\]/g, '\\$&').replace(/\n/g, '\\n');
  return `"${escaped}"`;
}

const unquoted = (text) => text.slice(1, -1).replace(/\\(["\\n])/g, (_, character) => (character === 'n' ? '\n' : character));
const rounded = (value) => Number(value.toPrecision(9));
const number = (value) => String(rounded(value) + 0);
