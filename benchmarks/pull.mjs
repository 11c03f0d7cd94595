// Time of a pull of the skin: node benchmarks/pull.mjs [CONTROLS].
// All controls act at the pulled places (locality would leave some 20 to 60 of a face), two thirds of them are ends of
// signed axes; one place is pulled and two are pinned.  Prints milliseconds of processor time a move, each move done
// AGAIN times over, since asking for that time costs about as much as a move does.

import { fitPull } from '../viewer/src/direct.js';
import { random, scene } from '../tests/pulled_scenes.mjs';

const AGAIN = 20;
const count = Number(process.argv[2] ?? 150);
const times = [];
for (let seed = 1; seed <= 60; seed++) {
  const rng = random(seed);
  const made = scene(rng, Math.floor(count / 3), count - 2 * Math.floor(count / 3), 3, 1);
  const moves = made.controls.map((_, i) => i).map((i) => made.linearise(made.controls.map((each) => each.default)).motion(i));
  const model = { ...made, linearise: (values) => straight(made, moves, values) };
  const start = made.pose(rng);
  const origin = model.linearise(start).at;
  const way = [rng() - 0.5, rng() - 0.5, 0].map((each) => 6 * each * made.size);
  let now = start;
  for (let move = 1; move <= 10; move++) {
    const targets = origin.map((at, i) => at + (i < 3 ? (way[i] * move) / 10 : 0));
    const groups = start.map((_, i) => [i]);
    let found = null;
    const began = process.cpuUsage();
    for (let k = 0; k < AGAIN; k++) found = fitPull({ model, start, now, targets, groups, towards: [0, 0, 1], locality: 0 });
    const { user, system } = process.cpuUsage(began);
    if (seed > 5) times.push((user + system) / 1000 / AGAIN);
    now = start.map((value, i) => found.get(i) ?? value);
  }
}
times.sort((a, b) => a - b);
const at = (share) => times[Math.floor(share * (times.length - 1))].toFixed(2);
console.log(`${count} controls, ${times.length} moves: median ${at(0.5)} ms, 95th percentile ${at(0.95)} ms, longest ${at(1)} ms`);

/** Straight tracks, so that the time is that of the fit. */
function straight(made, moves, values) {
  const at = new Float64Array(9);
  values.forEach((value, i) => {
    for (let k = 0; k < 9; k++) at[k] += (value - made.off(i)) * moves[i][k];
  });
  return { at, motion: (i) => moves[i] };
}
