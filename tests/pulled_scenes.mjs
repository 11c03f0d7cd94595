// Small scenes for pulls: places that each control moves along a polyline of its own, all moves added.

/** Numbers from 0 to 1, the same for the same seed (mulberry32). */
export function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

/** Opposed pairs that are off one line by some 20 degrees, and single controls; tracks of `pieces` pieces. */
export function scene(rng, pairCount, singles, places, pieces) {
  const directions = [];
  for (let pair = 0; pair < pairCount; pair++) {
    const way = vectors(rng, places, 1);
    directions.push(way, way.map((each, p) => plus(scaled(each, -0.5 - rng()), vectors(rng, places, 0.4)[p])));
  }
  while (directions.length < 2 * pairCount + singles) directions.push(vectors(rng, places, 1));
  const lows = directions.map(() => (rng() < 0.3 ? -1 : 0));
  const knots = lows.map((low) => Array.from({ length: pieces + 1 }, (_, k) => low + k / pieces));
  const tracks = directions.map((ways, i) => ways.map((way) => knots[i].map((at) => plus(scaled(way, Math.abs(at)), bend(rng, pieces)))));
  const pairs = Array.from({ length: pairCount }, (_, pair) => [2 * pair, 2 * pair + 1]);
  return scene.of(lows.map((low) => ({ minimum: low, default: 0, maximum: low + 1 })), knots, tracks, pairs);
}

/** The scene as direct.js asks for it: `tracks[control][place]` at the values `knots[control]`. */
scene.of = (controls, knots, tracks, pairs) => {
  const opposites = controls.map((_, i) => pairs.flatMap(([a, b]) => (a === i ? [b] : b === i ? [a] : [])));
  const places = tracks[0].map((_, place) => place);
  const positions = (values) => places.flatMap((place) => controls
    .map(({ default: off }, i) => minus(on(knots[i], tracks[i][place], values[i]), on(knots[i], tracks[i][place], off)))
    .reduce(plus, [0, 0, 0]));
  const linearise = (given) => {
    const values = [...given];
    const at = positions(values);
    const motion = (i) => {
      const step = values[i] + 1e-4 <= controls[i].maximum ? 1e-4 : -1e-4;
      const moved = positions(values.map((value, k) => (k === i ? value + step : value)));
      return moved.map((value, k) => (value - at[k]) / step);
    };
    return { at, motion };
  };
  return {
    controls, pairs, positions, linearise,
    minimum: (i) => controls[i].minimum,
    maximum: (i) => controls[i].maximum,
    off: (i) => controls[i].default,
    opposites: (i) => opposites[i],
    size: Math.max(...tracks.flat().map((track) => Math.hypot(...minus(track.at(-1), track[0])))),
    peak: (i) => Math.max(...tracks[i].map((track) => length(track))),
    /** A pose with one end of each pair at most. */
    pose: (rng) => {
      const values = controls.map(({ minimum, default: off, maximum }) => (rng() < 0.3 ? off : minimum + rng() * (maximum - minimum)));
      for (const pair of pairs) {
        const end = pair[rng() < 0.5 ? 0 : 1];
        values[end] = controls[end].default;
      }
      return values;
    },
  };
};

const vectors = (rng, count, size) => Array.from({ length: count }, () => [0, 1, 2].map(() => 2 * size * (rng() - 0.5)));
const bend = (rng, pieces) => (pieces === 1 ? [0, 0, 0] : vectors(rng, 1, 0.15)[0]);
const plus = (a, b) => a.map((value, i) => value + b[i]);
const minus = (a, b) => a.map((value, i) => value - b[i]);
const scaled = (a, factor) => a.map((value) => value * factor);
const length = (track) => track.slice(1).reduce((sum, point, k) => sum + Math.hypot(...minus(point, track[k])), 0);

function on(knots, points, value) {
  let piece = 0;
  while (piece < knots.length - 2 && value >= knots[piece + 1]) piece++;
  const share = (value - knots[piece]) / (knots[piece + 1] - knots[piece]);
  return points[piece].map((from, axis) => from + share * (points[piece + 1][axis] - from));
}
