import assert from 'node:assert/strict';
import { test } from 'node:test';
import { QUESTIONS, relativeError, sessionFor, toCsv, trialsFor } from '../src/evaluate.js';

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
  assert.ok(lines.slice(0, 3).every((line) => line.split(',').length === 13));
  assert.ok(lines[2].endsWith(',direct,5'));
  assert.ok(lines[3].endsWith(',comment,"good, ""very"" indeed"'));
  assert.ok('direct' in QUESTIONS);
});
