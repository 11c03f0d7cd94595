import assert from 'node:assert/strict';
import { test } from 'node:test';
import { QUESTIONS, dealt, eventsCsv, lackOf, posesOfClip, relativeError, sessionFor, toCsv, trialsFor } from '../src/evaluate.js';

/** Twenty elements of one control each; some controls go to 45, as degrees do. */
function character() {
  const controls = Array.from({ length: 20 }, (_, i) => ({ minimum: 0, maximum: i % 2 ? 45 : 1 }));
  const list = controls.map((_, control) => ({ onBoard: false, members: [{ control }] }));
  return { controls, rest: new Float64Array(20), elements: { list } };
}

test('a practice face comes before each block, and the fifteen are those of every participant', () => {
  const session = character();
  const faces = sessionFor(4, session);
  assert.deepEqual(faces.map(({ face }) => face === 'practice'), Array.from({ length: 18 }, (_, i) => i % 6 === 0));
  assert.deepEqual(faces.filter(({ face }) => face !== 'practice'), trialsFor(4, session));
  for (let i = 0; i < 18; i += 6) assert.equal(faces[i].name, faces[i + 1].name);
});

test('degrees weigh no more than weights: errors are in shares of each control\'s range', () => {
  const [neutral, target] = [[0, 0], [1, 45]];
  assert.equal(relativeError([1, 0], target, neutral, [1, 45]), 0.5);
  assert.ok(relativeError([1, 0], target, neutral) > 0.99);
});

test('answers are rows of the file; what is said in words is quoted', () => {
  const results = [{ block: 1, name: 'list', face: '1a', controls: 1, seconds: 2, edits: 1, weightError: 0, vertexError: 0 }];
  const lines = toCsv(3, results, { direct: 5, comment: 'good, "very"\nindeed' }).trim().split('\n');
  assert.equal(lines.length, 4);
  assert.ok(lines.slice(0, 3).every((line) => line.split(',').length === 24));
  assert.ok(lines[2].includes(',direct,5,'));
  assert.ok(lines[3].includes(',comment,"good, ""very"" indeed",'));
  assert.ok('direct' in QUESTIONS);
});

test('every row says to which study it belongs', () => {
  const results = [{ block: 1, name: 'list', face: '1a', controls: 1, seconds: 2, edits: 1, weightError: 0, vertexError: 0, facePixels: 500, targetPixels: 500, window: '1366x768@1', device: 'mouse', paused: 3 }];
  const setting = { level: 'amateur', order: 'list-face-beside', targets: 'the poses given', character: 'c', layout: 'l', version: '1' };
  const [heads, ...rows] = toCsv(3, results, { direct: 5 }, setting).trim().split('\n').map((line) => line.split(','));
  for (const row of rows) for (const name of ['level', 'order', 'targets', 'character', 'layout', 'version']) assert.equal(row[heads.indexOf(name)], setting[name]);
  for (const [name, value] of [['paused', '3.00'], ['face_pixels', '500.0'], ['target_pixels', '500.0'], ['window', '1366x768@1'], ['device', 'mouse']]) assert.equal(rows[0][heads.indexOf(name)], value);
});

test('an artist\'s poses are dealt by the number of their controls, the fullest to every block', () => {
  const session = character();
  const poses = Array.from({ length: 14 }, (_, i) => new Map(Array.from({ length: i }, (__, control) => [control, 0.5])));
  const [common, blocks] = dealt(poses.reverse(), session);
  const count = (face) => face.filter((value) => value).length;
  assert.equal(count(common), 13);
  assert.deepEqual(blocks.map((block) => block.map(count)), [[1, 4, 7, 10], [2, 5, 8, 11], [3, 6, 9, 12]]);
  assert.equal(trialsFor(2, session, poses).length, 15);
  assert.match(lackOf(poses.slice(1), session), /^12 of .* needs 13/, 'one moves nothing');
  assert.equal(lackOf(poses, session), '');
});

/** The same with a clip that goes through the `peaks` of its controls, each of four frames. */
function animated(peaks) {
  const session = character();
  const clipAt = (frame) => {
    const values = new Float64Array(20).fill(1e-4);
    const { maximum } = session.controls[Math.floor(frame / 4) % 20];
    values[Math.floor(frame / 4) % 20] = maximum * [0.25, 0.9, 0.5, 0][frame % 4];
    return { values };
  };
  return { ...session, animation: { times: () => Array.from({ length: 4 * peaks }, (_, i) => i), clipAt } };
}

test('poses of the clip are its extremes, none like another; where it has too few there are fewer', () => {
  const session = animated(13);
  const found = posesOfClip(session);
  const moved = found.map((pose) => [...pose].filter(([, value]) => value));
  assert.deepEqual(moved, Array.from({ length: 13 }, (_, i) => [[i, 0.9 * session.controls[i].maximum]]));
  assert.equal(trialsFor(1, session, found).length, 15);
  assert.equal(posesOfClip(animated(3)).length, 9, 'three controls at three values each; rest is none');
  assert.deepEqual(posesOfClip(animated(0)), []);
});

test('what the hand did is a file of its own', () => {
  const events = [{ event: 'grab', at: 1500, control: 'jaw', x: 10.4, y: 20, pixels: 99.7 }];
  const lines = eventsCsv(3, [{ face: '1a', name: 'face', events }, { face: '1b', name: 'face' }]).trim().split('\n');
  assert.deepEqual(lines.slice(1), ['3,1,1a,face,grab,1.500,"jaw",10,20,100']);
});
