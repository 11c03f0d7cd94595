// The animation as a USD layer, and back from one: over the asset it evaluates to what the page shows.
//
// A SkelAnimation holds all its weights in one array and its joints in three, so an attribute that a key reaches is
// written whole, merged with the clip; what no key reaches is left to the asset.  USD interpolates linearly, joints on
// the sphere: weights are exact at all times, joints at every whole frame and every sample of the clip and the keys.

import { decomposed } from './matrix.js';
import { keysFrom, parsed, sayKeys } from './by_name.js';
import { posed } from './notes.js';
import { keeping, layerText, number, quoted, stringsNamed } from './usda.js';
import { ascending, known } from './vectors.js';

/**
 * The layer as usda text ('' when nothing is animated by hand), to be put above the asset in `subLayers`, and the names
 * of controls that it cannot hold, since no Skeleton with an animation is known for them.
 */
export function animationLayer(session) {
  return layerAlone(animated(session, saidKeys(session)));
}

/** One layer of all characters, each with its work, and works of what none of them has; equal works give equal text. */
export function animationLayerOf(sessions, workOf, others) {
  return layerOf(sessions.map((session) => animated(session, workOf(session))), others);
}

/** A session's keys and what stands at all frames, by name. */
export function saidKeys(session) {
  const { animation, keys } = session;
  const constants = new Map([...session.allConstants()].filter(([control]) => !animation.isAnimated(control, keys)));
  return sayKeys(session, { keys, constants, span: session.span });
}

/** What is written of a character; keys are those of the work as a reader has them, to the digits that it says. */
function animated(session, stored) {
  const { animation } = session;
  const work = keysFrom(stored, session);
  const written = ascending([...work.keys.keys(), ...work.constants.keys()]);
  const states = written.length ? statesAt(session, timesOf(animation, work), (time) => animation.at(time, work)) : [];
  return contentOf(session, written, states, animation.range(work.keys, work.span), stored);
}

/** The present pose as such a layer, with one sample at the present frame. */
export function poseLayer(session) {
  const { frame, neutral, animation, values } = session;
  const base = neutral ? { weights: null, locals: null } : animation.clipAt(frame);
  const states = statesAt(session, [frame], () => ({ ...base, values }));
  const all = [...session.controls.keys()];
  const constants = new Map(all.map((control) => [control, values[control]]));
  return layerAlone(contentOf(session, all, states, [frame, frame], sayKeys(session, { keys: new Map(), constants })));
}

const layerAlone = (content) => ({ text: content.animations.size ? layerOf([content]) : '', unwritten: content.unwritten });

/**
 * Values by control index as SkelAnimations of default values, [{path of the character's own, lines}], with the channels and
 * joints that these controls drive alone; and names of controls that none drives.
 */
export function poseAnimations(session, values) {
  const { character, controls } = session;
  const states = statesAt(session, [null], () => ({ values: posed(session, { values }), weights: null, locals: null }));
  const { animations, unwritten } = animationsOf(session, [...values.keys()]);
  const driven = new Set([...values.keys()].flatMap((control) => controls[control].drive.channels));
  const own = (each) => ({ ...each, channels: each.channels.filter((channel) => driven.has(channel)), joints: each.joints.filter((joint) => each.driven.has(joint)) });
  return { animations: [...animations].map(([path, each]) => ({ path, lines: animationLines(character, own(each), states) })), unwritten };
}

/** Keys and constant values by control index from a layer that the viewer wrote; throws an Error for people otherwise. */
export function keysFromLayer(text, session) {
  const works = worksOf(text);
  const found = keysFrom(works.find(({ root }) => root === session.character.root) ?? works[0], session);
  if (!found.keys.size && !found.constants.size) throw new Error('No control of this character is named in the layer.');
  return found;
}

/** The works in a layer that the viewer wrote, whatever program saved it since: {root, keys, standing, span if set by hand} per character. */
function worksOf(text) {
  const [work] = stringsNamed('work', text);
  if (!text.startsWith('#usda') || !work) throw new Error('This layer was not written by the viewer.');
  return worksIn(work);
}

/** The works in what a layer keeps of them. */
export function worksIn(work) {
  const stored = parsed(work);
  return (stored?.characters ?? [stored]).filter(Boolean).map(({ root, keys = {}, standing = {}, span }) => ({ root, keys, standing, ...(span && { span }) }));
}

// --- states ------------------------------------------------------------------------------------------

/** The animation's times, and those at which a written control crosses a knot of its drive, where weights bend. */
function timesOf(animation, work) {
  const times = animation.times(work.keys, work.span);
  const bent = [...work.keys.keys()].filter((control) => animation.controls[control].drive.values.length > 2);
  if (!bent.length) return times;
  const values = times.map((time) => animation.at(time, work).values);
  const more = bent.flatMap((control) =>
    times.slice(1).flatMap((end, i) =>
      crossings(animation.controls[control].drive.values, [times[i], values[i][control]], [end, values[i + 1][control]]),
    ),
  );
  return ascending([...times, ...more]);
}

/** Times inside a piece that is linear from one [time, value] to another, at which it crosses knots. */
function crossings(knots, [start, from], [end, to]) {
  const inside = knots.filter((knot) => (knot - from) * (knot - to) < 0);
  return inside.map((knot) => start + ((knot - from) / (to - from)) * (end - start)).filter((time) => time > start && time < end);
}

/** Channel weights and local joint transforms at times. */
export function statesAt(session, times, at) {
  const { deformer, character } = session;
  const states = times.map((time) => {
    const { values, weights, locals } = at(time);
    deformer.setBase(weights, locals);
    deformer.drive(values);
    return {
      time,
      values: Float64Array.from(values),
      left: weights,
      weights: Array.from(deformer.weights),
      locals: character.joints.map((_, joint) => Array.from(deformer.skeletons.localAt(joint, deformer.moves))),
    };
  });
  session.showBase();
  deformer.drive(session.values);
  return states;
}

// --- what is written where ---------------------------------------------------------------------------

/** What a layer says of one character: {animations, unwritten, prims, range, rate, own, work}; `own` is how paths begin that it may write. */
function contentOf(session, controls, states, range, work) {
  const { character, animation } = session;
  const { animations, unwritten } = animationsOf(session, controls);
  const prims = new Map();
  for (const [path, each] of animations) {
    if (each.made) each.skeletons.forEach((skeleton) => bind(prims, character.skeletons[skeleton].path, path));
    put(prims, path, { type: each.made ? 'def SkelAnimation' : 'over', lines: animationLines(character, each, states) });
  }
  for (const control of withValues(character.controls, controls.filter((each) => isWhole(character, each, states)))) {
    const [prim, name] = character.controls[control].attribute.split('.');
    put(prims, prim, { type: 'over', lines: valueLines(name, control, states) });
  }
  const own = [`${character.root}/`, ...character.skeletons.map((each) => `${animationOf(each)}.`)];
  return { animations, unwritten, prims, range, rate: animation.rate, own, work: { root: character.root, ...work } };
}

/** Whether a clip leaves nothing in the weights of a control beside its value, as one does that moves them apart. */
function isWhole({ baseWeights, controls }, control, states) {
  const { channels } = controls[control].drive;
  return states.every(({ left }) => !left || channels.every((each) => Math.abs(left[each] - baseWeights[each]) < 1e-5));
}

/**
 * Those of the `written` controls that have an attribute of which the samples can be made again: whatever else drives
 * what they drive is among them, but for other axes of a joint.
 */
function withValues(all, written) {
  const meets = ({ drive, kind }, other) =>
    other.drive.channels.some((channel) => drive.channels.includes(channel)) ||
    ((kind !== 'joint' || other.kind !== 'joint') && other.drive.joints.some((joint) => drive.joints.includes(joint)));
  const found = written.filter((control) => all[control].attribute && all.every((other, i) => written.includes(i) || !meets(all[control], other)));
  return found.length === written.length ? found : withValues(all, found);
}

/** The parts of all characters as one layer, and works of other characters and controls. */
function layerOf(parts, others = []) {
  const [{ rate, work }] = parts;
  const works = new Map(others.map((each) => [each.root, each]));
  for (const { work: own } of parts) {
    const { keys, standing } = works.get(own.root) ?? {};
    works.set(own.root, { ...own, keys: { ...own.keys, ...keys }, standing: { ...own.standing, ...standing } });
  }
  const all = [...works.values()];
  return layerText(new Map(parts.flatMap(({ prims }) => [...prims])), [
    `defaultPrim = ${quoted(work.root.split('/')[1] ?? '')}`,
    `startTimeCode = ${number(Math.min(...parts.map(({ range }) => range[0])))}`,
    `endTimeCode = ${number(Math.max(...parts.map(({ range }) => range[1])))}`,
    `timeCodesPerSecond = ${number(rate)}`,
    `framesPerSecond = ${number(rate)}`,
    ...keeping(
      'customLayerData',
      `string work = ${quoted(JSON.stringify(all.length > 1 ? { characters: all } : all[0]))}`,
      `string[] own = [${parts.flatMap(({ own }) => own).map(quoted).join(', ')}]`,
    ),
  ]);
}

/**
 * What to write on each SkelAnimation that some of `controls` reach: all its channels if one of them is driven, all
 * its joints likewise; by path.  A Skeleton without an animation gets one of its own.
 */
function animationsOf({ character, controls: all }, controls) {
  const { channels, joints, skeletons } = character;
  const paths = skeletons.map(animationOf);
  const homes = channels.map((channel, index) => homesOf(character, paths, channel, index));
  const found = new Map();
  const at = (path) => known(found, path, () => emptyAnimation(character, paths, path));
  const unwritten = [];
  for (const control of controls) {
    const { drive, name } = all[control];
    const reached = drive.channels.flatMap((channel) => homes[channel]);
    reached.forEach((path) => (at(path).weighted = true));
    drive.joints.forEach((joint) => at(paths[joints[joint].skeleton]).driven.add(joint));
    if (drive.channels.length && !reached.length) unwritten.push(name);
  }
  for (const [path, each] of found) {
    channels.forEach((_, index) => each.weighted && homes[index].includes(path) && each.channels.push(index));
    each.channels.sort((a, b) => place(channels[a]) - place(channels[b]));
    const tokens = each.channels.map((channel) => channels[channel].token);
    each.channels = each.channels.filter((_, i) => tokens.indexOf(tokens[i]) === i);
    if (each.driven.size) each.joints = jointsOf(joints, each);
  }
  return { animations: found, unwritten };
}

/** The SkelAnimation of a Skeleton, its own or one to be made. */
export const animationOf = ({ path, animation }) => animation || `${path}/usdrigui_animation`;

const emptyAnimation = ({ skeletons, channels }, paths, path) => ({
  skeletons: [...skeletons.keys()].filter((index) => paths[index] === path),
  made: [...skeletons, ...channels].every(({ animation }) => animation !== path),
  weighted: false,
  driven: new Set(),
  channels: [],
  joints: [],
});

/** Channels that no animation lists come after those that one does. */
const place = ({ index }) => (index < 0 ? Infinity : index);

/** The animations that hold a channel: its own, or where none lists it those of the meshes that have its shapes. */
function homesOf({ meshes, joints, channels }, paths, { animation, index }, channel) {
  if (animation && index >= 0) return [animation];
  const having = meshes.filter(({ shapes }) => shapes.some((shape) => shape.channel === channel));
  const homes = having.flatMap(({ skin, shapes }) => {
    if (skin) return [paths[joints[skin.joints[0]].skeleton]];
    const listing = shapes.map((shape) => channels[shape.channel]).find((each) => each.animation);
    return listing ? [listing.animation] : paths; // the reader does not tell which Skeleton: every one gets it
  });
  return [...new Set(homes)];
}

/** Joints by token, once each: Skeletons that share an animation share its joints. */
function jointsOf(joints, { skeletons, driven }) {
  const byToken = new Map();
  joints.forEach(({ path, skeleton }, joint) => {
    if (skeletons.includes(skeleton) && (!byToken.has(path) || driven.has(joint))) byToken.set(path, joint);
  });
  return [...byToken.values()];
}

// --- USD text ----------------------------------------------------------------------------------------

function animationLines(character, { channels, joints }, states) {
  const lines = [];
  if (channels.length) {
    lines.push(tokens('blendShapes', channels.map((channel) => character.channels[channel].token)));
    lines.push(...samples('float[] blendShapeWeights', states, ({ weights }) => channels.map((channel) => number(weights[channel]))));
  }
  if (joints.length) {
    const parts = states.map(({ time, locals }) => ({ time, parts: joints.map((joint) => decomposed(locals[joint])) }));
    const of = (name) => (state) => state.parts.map((part) => `(${part[name].map(number).join(', ')})`);
    lines.push(tokens('joints', joints.map((joint) => character.joints[joint].path)));
    const turn = ({ rotation: [x, y, z, w] }) => `(${[w, x, y, z].map(number).join(', ')})`;
    lines.push(...samples('quatf[] rotations', parts, (state) => state.parts.map(turn)));
    lines.push(...samples('half3[] scales', parts, of('scale')));
    lines.push(...samples('float3[] translations', parts, of('translation')));
  }
  return lines;
}

/** A control's own attribute: samples, or one value where it keeps it. */
function valueLines(name, control, states) {
  const rows = states.map(({ time, values }) => [number(time), number(values[control])]);
  if (rows.every(([, value]) => value === rows[0][1])) return [`double ${name} = ${rows[0][1]}`];
  return [`double ${name}.timeSamples = {`, ...rows.map(([time, value]) => `    ${time}: ${value},`), '}'];
}

const tokens = (name, values) => `uniform token[] ${name} = [${values.map(quoted).join(', ')}]`;

/** Samples over time, or the default value where the only state has no time. */
function samples(attribute, states, items) {
  if (states[0].time === null) return [`${attribute} = [${items(states[0]).join(', ')}]`];
  const rows = states.map((state) => `    ${number(state.time)}: [${items(state).join(', ')}],`);
  return [`${attribute}.timeSamples = {`, ...rows, '}'];
}

/** Bind a Skeleton to an animation of its own. */
function bind(prims, skeleton, animation) {
  put(prims, skeleton, {
    type: 'over',
    metadata: 'prepend apiSchemas = ["SkelBindingAPI"]',
    lines: [`rel skel:animationSource = <${animation}>`],
  });
}

function put(prims, path, { type, metadata = '', lines }) {
  const before = prims.get(path) ?? { type: 'over', metadata: '', lines: [] };
  prims.set(path, { type: type === 'over' ? before.type : type, metadata: metadata || before.metadata, lines: [...before.lines, ...lines] });
}
