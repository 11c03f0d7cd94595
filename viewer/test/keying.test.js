import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { changedKeys, copiedKeys, flipped, keysGoing, keysWithin, mirroredFrom, pastedKeys, removedKeys, retimed, tweened } from '../src/keying.js';
import { valueBetween, withKey } from '../src/interpolation.js';
import { Posing, oppositesOf, twinsOf } from '../src/posing.js';

const sorted = (keys) => [...keys].sort(([a], [b]) => a - b);
const KEYS = new Map([[0, [[1, 0.1], [5, 0.5]]], [2, [[5, 0.9]]]]);

test('keys are moved over what is there, copied, and taken away; those given stay as they are', () => {
  const later = (by) => ([frame, value]) => [retimed(by, 1, null)(frame), value];
  assert.deepEqual(sorted(changedKeys(KEYS, [[0, 1], [2, 5]], later(4)).keys), [[0, [[5, 0.1]]], [2, [[9, 0.9]]]]);
  assert.deepEqual(sorted(changedKeys(KEYS, [[0, 1], [0, 5]], later(4)).keys), [[0, [[5, 0.1], [9, 0.5]]], [2, [[5, 0.9]]]]);
  assert.deepEqual(changedKeys(KEYS, [[0, 1]], later(2), true).keys.get(0), [[1, 0.1], [3, 0.1], [5, 0.5]]);
  assert.deepEqual([...removedKeys(KEYS, [[2, 5], [0, 1], [1, 1]])], [[0, [[5, 0.5]]]]);
  assert.deepEqual(KEYS.get(0), [[1, 0.1], [5, 0.5]]);
});

test('ranges of keys are found, changed, copied elsewhere and told how to go on; each keeps its way', () => {
  const keys = new Map([[0, [[1, 0.1, 'stepped'], [5, 0.5]]], [2, [[5, 0.9, 'smooth']]]]);
  const range = keysWithin(keys, [0, 2], [2, 6]);
  assert.deepEqual(range, [[0, 5], [2, 5]]);
  assert.deepEqual(sorted(changedKeys(keys, range, ([frame, value], control) => [frame + 1, value / (control + 1)]).keys), [[0, [[1, 0.1, 'stepped'], [6, 0.5]]], [2, [[6, 0.3, 'smooth']]]]);
  const copied = copiedKeys(keys, [[0, 1], [2, 5]]);
  assert.deepEqual(copied, [[0, [0, 0.1, 'stepped']], [2, [4, 0.9, 'smooth']]]);
  assert.deepEqual(sorted(pastedKeys(keys, copied, 5)), [[0, [[1, 0.1, 'stepped'], [5, 0.1, 'stepped']]], [2, [[5, 0.9, 'smooth'], [9, 0.9, 'smooth']]]]);
  assert.deepEqual(sorted(keysGoing('linear', keys, [[0, 1], [0, 5], [2, 5]])), [[0, [[1, 0.1], [5, 0.5]]], [2, [[5, 0.9]]]]);
});

test('the slope of a key goes with it, as much less steep as time is slower, and turned round with it', () => {
  const keys = new Map([[0, [[1, 0.1, 'smooth', 0.06], [5, 0.5, 'stepped', 0.02], [9, 0.2]]]]);
  const both = keysWithin(keys, [0], [1, 5]);
  const changed = (frames) => changedKeys(keys, both, ([frame, value]) => [frames(frame), value]).keys.get(0);
  assert.deepEqual(changed((frame) => frame + 1), [[2, 0.1, 'smooth', 0.06], [6, 0.5, 'stepped', 0.02], [9, 0.2]]);
  assert.deepEqual(changed(retimed(-2, 5, [1, 5])).map((key) => key.slice(0, 3)), [[1, 0.1, 'smooth'], [3, 0.5, 'stepped'], [9, 0.2]]);
  assert.ok(changed(retimed(-2, 5, [1, 5])).slice(0, 2).every((key, i) => Math.abs(key[3] - [0.12, 0.04][i]) < 1e-6));
  assert.deepEqual(changed((frame) => 6 - frame), [[1, 0.5, 'stepped', -0.02], [5, 0.1, 'smooth', -0.06], [9, 0.2]]);
  assert.deepEqual(changed(() => 4), [[4, 0.5, 'stepped'], [9, 0.2]]);
  assert.deepEqual(copiedKeys(keys, [[0, 5]]), [[0, [0, 0.5, 'stepped', 0.02]]]);
  assert.deepEqual(pastedKeys(keys, [[0, [0, 0.3]]], 1).get(0)[0], [1, 0.3]);
  assert.deepEqual(keysGoing('smooth', keys, both).get(0).slice(0, 2), [[1, 0.1, 'smooth'], [5, 0.5, 'smooth']]);
});

test('a smooth curve passes a key at its slope; a new value keeps it', () => {
  const track = [[0, 0, 'smooth'], [10, 1, 'smooth', 0.1], [20, 0]];
  assert.ok(Math.abs(valueBetween(track, 0, 5) - (0.5 - 10 * 0.1 / 8)) < 1e-12);
  assert.ok(Math.abs(valueBetween(track, 1, 15) - (0.5 + 10 * 0.1 / 8)) < 1e-12);
  assert.deepEqual(withKey(track, 10, 0.7)[1], [10, 0.7, 'smooth', 0.1]);
});

test('a range is scaled about the end that is farther from the key that is held', () => {
  assert.deepEqual([10, 14, 20].map(retimed(10, 20, [10, 20])), [10, 18, 30]);
  assert.deepEqual([10, 14, 20].map(retimed(5, 12, [10, 20])), [16, 18, 20]);
});

test('a tween lies between the keys on both sides, and needs both', () => {
  assert.deepEqual(tweened(KEYS, [0, 1, 2], 3, 0.25), [[0, 0.1 + 0.25 * 0.4]]);
  assert.deepEqual(tweened(KEYS, [0], 5, 0.5), []);
});

/** 0 and 1 are twins, 2 and 3 the ends of an axis to the sides, 4 goes both ways by itself, 5 is in the middle. */
function sides(values) {
  const opposites = [[], [], [3], [2], [], []];
  return {
    values,
    controls: values.map((_, i) => ({ minimum: i === 4 ? -1 : 0, maximum: 1 })),
    rest: values.map(() => 0),
    twins: Int32Array.from([1, 0, -1, -1, -1, -1]),
    opposites,
    crosses: (i) => i >= 2 && i <= 4,
    sideOf: (i) => ['left', 'right'][i],
    mirrored: (from) => values[from],
  };
}

test('a flip swaps sides and turns what goes to one side; twice it is the pose itself', () => {
  const values = [0.2, 0.7, 0.4, 0, 0.3, 0.6];
  const apply = (given) => given.map((value, i) => new Map(flipped(sides(given))).get(i) ?? value);
  assert.deepEqual(apply(values), [0.7, 0.2, 0, 0.4, -0.3, 0.6]);
  assert.deepEqual(apply(apply(values)), values);
});

test('one side is mirrored on the other', () => {
  assert.deepEqual(mirroredFrom('left', sides([0.2, 0.7, 0, 0, 0, 0])), [[1, 0.2]]);
  assert.deepEqual(mirroredFrom('right', sides([0.2, 0.7, 0, 0, 0, 0])), [[0, 0.7]]);
});

const FACE = JSON.parse(readFileSync(new URL('../../tests/mirrored_poses.json', import.meta.url)));

test('a face is mirrored and flipped as in Blender', () => {
  const index = new Map(FACE.controls.map(({ name }, i) => [name, i]));
  const elements = FACE.elements.map((each) => ({ ...each, members: each.members.map((name) => ({ control: index.get(name) })) }));
  const [opposites, rest] = [oppositesOf(elements, index.size), FACE.controls.map((control) => control.rest)];
  const sideOf = (i) => elements.find(({ members }) => members.some(({ control }) => control === i)).side;
  for (const pose of FACE.poses) {
    const values = FACE.controls.map(({ name, rest: still }) => pose.values[name] ?? still);
    const mirrored = (from, to) => Posing.prototype.mirrored.call({ rest, values, controls: FACE.controls }, from, to);
    const asked = { values, rest, opposites, controls: FACE.controls, twins: twinsOf(elements, opposites), mirrored, sideOf };
    const given = { flipped: flipped({ ...asked, crosses: (i) => FACE.crosses.includes(FACE.controls[i].name) }) };
    for (const side of ['left', 'right']) given[side] = mirroredFrom(side, asked);
    for (const [name, found] of Object.entries(given)) {
      const after = [...values];
      for (const [i, value] of found) after[i] = Math.min(FACE.controls[i].maximum, Math.max(FACE.controls[i].minimum, value));
      assert.deepEqual(after, FACE.controls.map((control, i) => pose[name][control.name] ?? values[i]), name);
    }
  }
});
