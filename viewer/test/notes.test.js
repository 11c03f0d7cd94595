import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrbitCamera } from '../src/camera.js';
import { isSeenFrom, lookOf, notesIn, notesOf, pairOf, placeOf, posed, reviewLayer, saidPose, thinned } from '../src/notes.js';

const COLUMN = { left: 10, top: 20, width: 800, height: 600 };
const CONTROLS = [{ name: 'jaw', default: 0.25 }, { name: 'brow', default: 0 }];

function turned(azimuth) {
  const camera = new OrbitCamera([0, 0, 1], [0, -1, 0]);
  camera.frame([[0, 0, 0], [9, 9, 9]], COLUMN.width, COLUMN.height);
  camera.lookFrom([1, 2, 3], [0, -1, 0], 40);
  camera.turn(azimuth, 0.3);
  return camera;
}

const sessionOf = (root) => ({ controls: CONTROLS, character: { root } });
const noteOf = (id, text = '') => ({
  id, frame: 6, neutral: false, text, done: false, values: new Map([[1, 0.5]]), section: '', look: lookOf(turned(0.7), COLUMN), strokes: [[[0, 0.5], [1.25, -2]]],
});

test('a stroke stands where it was drawn, under pan and zoom, and is seen from its own direction alone', () => {
  const camera = turned(0.7);
  const look = lookOf(camera, COLUMN);
  const at = camera.unproject(COLUMN, 300, 200, camera.distance);
  const pair = pairOf(look, at);
  placeOf(look, pair).forEach((value, axis) => assert.ok(Math.abs(value - at[axis]) < 1e-7));
  camera.zoom(0.5);
  camera.pan(30, -40, COLUMN.height);
  const [x, y] = camera.projector(COLUMN)(placeOf(look, pair));
  assert.ok(Math.hypot(x - (410 + 2 * (300 - 410) + 30), y - (320 + 2 * (200 - 320) - 40)) < 1e-4);
  assert.ok(isSeenFrom(look, camera));
  assert.ok(!isSeenFrom(look, turned(0.72)));
  const again = turned(0);
  again.lookFrom(look.target, look.towards, look.distance);
  assert.ok(isSeenFrom(look, again));
});

test('points on a line are left out, corners stay', () => {
  const line = Array.from({ length: 50 }, (_, k) => [k, 0.1 * Math.sin(k)]);
  assert.deepEqual(thinned([...line, [49, 30]], 0.5), [line[0], line.at(-1), [49, 30]]);
  assert.deepEqual(thinned([[3, 3]], 1), [[3, 3]]);
});

test('a layer holds notes of several characters, which find theirs; others go to the first', () => {
  const text = 'a "quoted"\nline \\ string note = "x"';
  const layer = reviewLayer([[sessionOf('/A'), [noteOf('1', text)]], [sessionOf('/B'), []], [sessionOf('/World/C'), [noteOf('2')]]]);
  const said = notesIn(layer);
  const found = (root, roots) => notesOf(said, sessionOf(root), roots).map(({ id }) => id);
  assert.deepEqual([found('/A', ['/A', '/World/C']), found('/World/C', ['/A', '/World/C'])], [['1'], ['2']]);
  assert.deepEqual([found('/D', ['/D', '/A']), found('/A', ['/D', '/A'])], [['2'], ['1']]);
  assert.deepEqual(notesOf(said, sessionOf('/A'), ['/A', '/World/C']), [noteOf('1', text)]);
  assert.throws(() => notesIn('#usda 1.0'), /no notes/);
});

test('what is no note is left out, and so are controls that the character lacks', () => {
  const [said] = notesIn(reviewLayer([[sessionOf('/A'), [noteOf('1')]]]));
  const broken = [null, { ...said, strokes: [[[0, NaN]]] }, { ...said, look: { ...said.look, distance: 0 } }, { ...said, frame: 'x' }];
  assert.deepEqual(notesOf(broken.map((each) => each && { ...each, root: '/A' }).filter(Boolean), sessionOf('/A'), ['/A']), []);
  const other = { ...sessionOf('/A'), controls: [{ name: 'jaw', default: 0.25 }] };
  assert.deepEqual(notesOf([said], other, ['/A'])[0].values, new Map());
});

test('a pose is said by what is away from its default', () => {
  const said = saidPose({ controls: CONTROLS }, Float64Array.from([0.25, 0.5]));
  assert.deepEqual([...said], [[1, 0.5]]);
  assert.deepEqual([...posed({ controls: CONTROLS }, { values: said })], [0.25, 0.5]);
});
