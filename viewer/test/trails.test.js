// Trails of a handle on a skin of two points, which its control moves along a bend, and another control carries.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Arrangement } from '../src/arrangement.js';
import { withKeys } from '../src/keying.js';
import { Session } from '../src/session.js';
import { Trails } from '../src/trails.js';

const drive = (channel) => ({ values: [0, 1], channels: [channel], weights: [[0], [1]], joints: [], rotations: [[], []], translations: [[], []], scales: [[], []] });
const shape = (channel, ...offsets) => ({ channel, weights: [1], step: 1, points: [0, 1], offsets });
const identity = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];

/** What a page has of it: {session, trails, view, timeline}. */
function opened() {
  const names = ['brow', 'jaw'];
  const follows = { held: [0], deforms: true, joint: -1 };
  const brow = {
    name: 'brow', label: 'brow', side: 'left', mesh: 0, point: 0, axes: [[0]], inner: [], mirror: '', onBoard: false, category: '', normal: [0, 0, 1],
    follows: { character: follows, board: follows }, members: [{ control: 0, values: [0, 1], track: [[0, 0, 0], [0, 100, 0]], magnification: 1 }],
  };
  const mesh = { path: '/F/M', start: 0, count: 2, points: Float32Array.from([0, 0, 0, 9, 0, 0]), triangles: [], visible: true, toRoot: identity, shapes: [shape(0, 0, 100, 0, 0, 0, 0), shape(1, 40, 0, 0, 40, 0, 0)] };
  const session = new Session({
    root: '/F', clip: null, up: [0, 1, 0], meshes: [mesh], joints: [], pointCount: 2, bind: [], base: new Float64Array(0), skeletons: [], baseWeights: [0, 0],
    channels: names.map((token, index) => ({ token, index, animation: '' })),
    controls: names.map((name, i) => ({ name, label: name, kind: 'blendShape', minimum: 0, default: 0, maximum: 1, attribute: null, drive: drive(i), reading: null })),
    layout: { sections: [{ elements: ['brow'], handleWidth: 1, view: [0, 0, 1] }], elements: [brow], baseValues: [0, 0], colours: { left: '#4af' }, planeNormal: [1, 0, 0] },
  });
  const asked = [];
  const view = { controlsColumn: {}, camera: { projector: () => ([x, y]) => [x, y, 1] }, overlay: new Arrangement(session), changed: (what) => asked.push(what) };
  const timeline = { played: [1, 21] };
  const track = (...keys) => keys.map(([frame, value]) => [0, [frame, value]]);
  session.rekey('Key', withKeys(new Map(), [...track([1, 0], [11, 1], [21, 0.5]), [1, [1, 0, 'smooth']], [1, [21, 1]]]));
  return { session, view, timeline, asked, trails: new Trails(session, view, timeline) };
}

const near = (a, b) => a.slice(0, 2).every((value, axis) => Math.abs(value - b[axis]) < 1e-4);

test('a trail leads through the place of its handle at every frame, marks its keys, and leaves what is shown as it is', () => {
  const { session, view, trails } = opened();
  session.select(session.elements.list);
  assert.deepEqual(trails.shown(), []);
  session.setOption('trails', true);
  session.go(8);
  const shown = () => [Array.from(session.deformer.points), Array.from(session.values), session.elements.list[0].handle];
  const before = structuredClone(shown());
  const [{ colour, places }] = trails.shown();
  assert.deepEqual(shown(), before);
  assert.equal(colour, '#4af');
  assert.deepEqual(places.map(({ frame }) => frame), Array.from({ length: 21 }, (_, i) => i + 1));
  assert.deepEqual(places.filter(({ isKey }) => isKey).map(({ frame }) => frame), [1, 11, 21]);
  for (const { frame, at } of places) {
    session.go(frame);
    const map = view.overlay.mapOf(session.elements.list[0], view.camera.projector());
    assert.ok(near(at, map(session.elements.list[0].handle)), `frame ${frame}`);
  }
  assert.ok(near(places[10].at, [20, 100]) && near(places[20].at, [40, 50]));
});

test('trails follow keys, frames that play and the selection; a trial has none', () => {
  const { session, timeline, trails, asked } = opened();
  session.setOption('trails', true);
  assert.deepEqual(trails.shown(), []);
  session.select(session.elements.list);
  const [before] = trails.shown();
  session.rekey('Key', withKeys(session.keys, [[0, [11, 0.25]]]));
  assert.ok(asked.includes('overlay'));
  assert.ok(near(trails.shown()[0].places[10].at, [20, 25]) && near(before.places[10].at, [20, 100]));
  session.undo();
  assert.deepEqual(trails.shown(), [before]);
  timeline.played = [11, 14];
  assert.deepEqual(trails.shown()[0].places, before.places.slice(10, 14));
  timeline.played = [1, 3000];
  const { length } = trails.shown()[0].places;
  assert.ok(length > 400 && length < 700, 'a long shot has fewer places than frames');
  session.trial = true;
  assert.deepEqual(trails.shown(), []);
});
