// Notes of a review: a frame or the neutral pose, the pose and the camera that a remark is about, the remark, and strokes drawn
// over the view.  A stroke lies in the plane through the camera's target that faces it, as pairs along its right and its above,
// so that it stands on the same place of the face in a page of any size.

import { cross, minus, normalised, plus, scaled } from './camera.js';
import { keeping, layerText, number, quoted, stringsNamed, tuple } from './usda.js';
import { byName, parsed, valuesByName } from './by_name.js';
import { clamp, dot, rounded } from './vectors.js';

const APERTURE = 24; // height of the picture behind a camera's lens, in its own tenths of units
const WIDTH = 0.004; // of a stroke, in heights of the view
const SAME = 1 - 1e-7; // cosine from which two directions are one

/**
 * @typedef {{target: number[], towards: number[], right: number[], distance: number, height: number, aspect: number}} Look
 * height: of what is seen in the plane of the target; aspect: its width to its height.
 */

/** What a camera sees in a column. @returns {Look} */
export function lookOf(camera, column) {
  const { target, towards, right, distance } = camera;
  return {
    target: target.map(exact),
    towards: towards.map(exact),
    right: right.map(exact),
    distance: exact(distance),
    height: exact(camera.pixelSize(1)),
    aspect: exact(column.width / column.height),
  };
}

/** Where the pair (along, up) of a stroke stands. */
export function placeOf({ target, towards, right }, [along, up]) {
  return plus(target, plus(scaled(right, along), scaled(cross(towards, right), up)));
}

/** The pair of a point of that plane. */
export function pairOf({ target, towards, right }, point) {
  const off = minus(point, target);
  return [dot(off, right), dot(off, cross(towards, right))];
}

/** Whether a camera still looks the way that the strokes were drawn: only then do they lie over what they mean. */
export const isSeenFrom = (look, { towards, right }) => dot(look.towards, towards) > SAME && dot(look.right, right) > SAME;

/** A stroke without the points that lie within `least` of a line between others (Ramer, Douglas and Peucker). */
export function thinned(points, least) {
  if (points.length < 3) return points;
  const [first, last] = [points[0], points.at(-1)];
  const offs = points.map((point) => offLine(point, first, last));
  const far = offs.indexOf(Math.max(...offs));
  if (offs[far] <= least) return [first, last];
  return [...thinned(points.slice(0, far + 1), least).slice(0, -1), ...thinned(points.slice(far), least)];
}

function offLine([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const share = length ? clamp(((x - ax) * dx + (y - ay) * dy) / length, 0, 1) : 0;
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}

// --- values ------------------------------------------------------------------------------------------

/** What a note says of the pose: controls away from their defaults. */
export function saidPose({ controls }, values) {
  return new Map([...values.entries()].filter(([index, value]) => value !== controls[index].default));
}

/** All values of a note's pose; controls of which it says nothing are at their defaults. */
export function posed({ controls }, { values }) {
  return Float64Array.from(controls, ({ default: off }, index) => values.get(index) ?? off);
}

// --- notes by names ----------------------------------------------------------------------------------

/** A note as JSON has it; equal notes give equal text. */
export function saidNote(session, { id, frame, neutral, text, done, values, section, look, strokes }) {
  return { id, root: session.character.root, frame, neutral, text, done, values: valuesByName(session, values), section, look, strokes };
}

/** A note of a session from its JSON; null where it is none. */
export function noteFrom(stored, { controls }) {
  const { id, frame, neutral, text, done, values, section, look, strokes } = stored ?? {};
  const isNote = typeof id === 'string' && Number.isFinite(frame) && isLook(look) && Array.isArray(strokes) && strokes.every(isStroke);
  if (!isNote) return null;
  return {
    id, frame, neutral: neutral === true, text: String(text ?? ''), done: done === true,
    values: byName(values, controls), section: String(section ?? ''), look, strokes,
  };
}

/** Notes of a session from their JSON; the first of the page's `roots` takes those of characters that are not there. */
export function notesOf(stored, session, roots) {
  const { root } = session.character;
  const own = stored.filter((each) => each.root === root || (root === roots[0] && !roots.includes(each.root)));
  return joined([], own.map((each) => noteFrom(each, session)).filter(Boolean));
}

/** Notes joined with others: one of the same id takes the place of the first. */
export function joined(notes, others) {
  const byId = new Map(notes.map((note) => [note.id, note]));
  others.forEach((note) => byId.set(note.id, note));
  return [...byId.values()];
}

const isVector = (value, length) => Array.isArray(value) && value.length === length && value.every(Number.isFinite);
const isStroke = (stroke) => Array.isArray(stroke) && stroke.length > 0 && stroke.every((pair) => isVector(pair, 2));
const isLook = (look) =>
  ['target', 'towards', 'right'].every((name) => isVector(look?.[name], 3)) &&
  Math.abs(dot(look.towards, look.right)) < 1e-3 && Boolean(normalised(look.towards)) && Boolean(normalised(look.right)) &&
  ['distance', 'height', 'aspect'].every((name) => look[name] > 0 && Number.isFinite(look[name]));

// --- the layer ---------------------------------------------------------------------------------------

/**
 * Notes as a USD layer: below each character a Scope of guides that holds, for each note, a Camera and the strokes as
 * BasisCurves, to be seen at its frame.  `parts` are [session, notes]; the page reads `customData.usdrigui.note`.
 */
export function reviewLayer(parts) {
  const prims = new Map();
  for (const [session, notes] of parts) {
    if (!notes.length) continue;
    const home = `${session.character.root}/RigUIReview`;
    prims.set(home, { type: 'def Scope', lines: ['uniform token purpose = "guide"'] });
    notes.forEach((note, index) => putNote(prims, `${home}/note_${index + 1}`, session, note));
  }
  const [first = ''] = [...prims.keys()].map((path) => path.split('/')[1]);
  return layerText(prims, [`defaultPrim = ${quoted(first)}`]);
}

function putNote(prims, path, session, note) {
  prims.set(path, {
    type: 'def Scope',
    metadata: [
      `displayName = ${quoted(titleOf(note))}`,
      `doc = ${quoted(note.text)}`,
      ...keeping('customData', `string note = ${quoted(JSON.stringify(saidNote(session, note)))}`),
    ].join('\n'),
  });
  prims.set(`${path}/view`, { type: 'def Camera', lines: cameraLines(note.look) });
  if (note.strokes.length) prims.set(`${path}/strokes`, { type: 'def BasisCurves', lines: curveLines(note) });
}

/** "Frame 12" */
export const titleOf = ({ frame, neutral }) => (neutral ? 'Neutral pose' : `Frame ${number(frame)}`);

function cameraLines({ target, towards, right, distance, height, aspect }) {
  const above = cross(towards, right);
  const rows = [[right, 0], [above, 0], [towards, 0], [plus(target, scaled(towards, distance)), 1]];
  const focal = (APERTURE * distance) / height;
  return [
    `float focalLength = ${number(focal)}`,
    `float horizontalAperture = ${number(APERTURE * aspect)}`,
    `float verticalAperture = ${APERTURE}`,
    `float2 clippingRange = (${number(0.01 * distance)}, ${number(100 * distance)})`,
    `matrix4d xformOp:transform = ( ${rows.map(([row, last]) => tuple([...row, last])).join(', ')} )`,
    'uniform token[] xformOpOrder = ["xformOp:transform"]',
  ];
}

function curveLines({ look, strokes, frame, neutral }) {
  const curves = strokes.map((stroke) => (stroke.length > 1 ? stroke : [stroke[0], stroke[0]]));
  const shown = [`    ${number(frame - 1)}: "invisible",`, `    ${number(frame)}: "inherited",`, `    ${number(frame + 1)}: "invisible",`];
  return [
    'uniform token type = "linear"',
    `int[] curveVertexCounts = [${curves.map((stroke) => stroke.length).join(', ')}]`,
    `point3f[] points = [${curves.flat().map((pair) => tuple(placeOf(look, pair))).join(', ')}]`,
    `float[] widths = [${number(WIDTH * look.height)}] (`,
    '    interpolation = "constant"',
    ')',
    'color3f[] primvars:displayColor = [(0.871, 0.397, 0.07)] (',
    '    interpolation = "constant"',
    ')',
    ...(neutral ? [] : ['token visibility.timeSamples = {', ...shown, '}']),
  ];
}

/** Notes in a layer that the viewer wrote, as JSON has them; throws an Error for people where there is none. */
export function notesIn(text) {
  const found = text.startsWith('#usda') ? stringsNamed('note', text).map((each) => parsed(each)).filter(Boolean) : [];
  if (!found.length) throw new Error('This layer holds no notes written by the viewer.');
  return found;
}

const exact = (value) => rounded(value) + 0; // no negative zero
