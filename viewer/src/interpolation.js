// Keys of one control, [[frame, value, way, slope]] in ascending order, and what lies between them.  The way of a key says how
// its value goes to the next: 'linear' (which is left out), 'smooth' or 'stepped'.  Smooth ways pass it at its slope, in values
// per frame, where it has one of its own.
//
// USD reads the samples that are written linearly, so what lies between is linear between whole frames here as well, and a stepped
// key lets go a moment before the next one: the layer holds both exactly (docs/decisions/140).

import { mixed } from './vectors.js';

export const WAYS = ['linear', 'smooth', 'stepped'];

const LET_GO = 2 ** -7; // frames before the next key

export const wayOf = (key) => key[2] ?? 'linear';

/** @returns {any[]} */
export const keyOf = (frame, value, way = 'linear', slope = null) => [frame, value, ...(slope !== null ? [way, slope] : way === 'linear' ? [] : [way])];

/** Keys with one more, or another in its place; without a way, with that and the slope of the key there, else the way of the one before or after. */
export function withKey(track, frame, value, way = wayAt(track, frame), slope = track.find(([key]) => key === frame)?.[3]) {
  return [...withoutKey(track, frame), keyOf(frame, value, way, slope)].sort(([a], [b]) => a - b);
}

export const withoutKey = (track, frame) => track.filter(([key]) => key !== frame);

function wayAt(track, frame) {
  const near = track.findLast(([key]) => key <= frame) ?? track[0];
  return near && wayOf(near);
}

/** The value at a time between two keys, the one at `index` and the next. */
export function valueBetween(track, index, time) {
  const [[start, from], [end, to]] = [track[index], track[index + 1]];
  const way = wayOf(track[index]);
  if (way === 'linear') return mixed(from, to, (time - start) / (end - start));
  const [low, high] = way === 'stepped' ? letGo(start, end, time) : [Math.max(start, Math.floor(time)), Math.min(end, Math.ceil(time))];
  const at = (when) => (way === 'smooth' ? smoothAt(track, index, when) : when === end ? to : from);
  return high > low ? mixed(at(low), at(high), (time - low) / (high - low)) : at(low);
}

/** Times inside the keys, besides these and whole frames, at which values bend. */
export const bendsOf = (track) => track.slice(1).flatMap(([end], i) => (wayOf(track[i]) === 'stepped' ? [turnOf(track[i][0], end)] : []));

const turnOf = (start, end) => Math.max(start, end - LET_GO);

function letGo(start, end, time) {
  const turn = turnOf(start, end);
  return time <= turn ? [start, start] : [turn, end];
}

/** A cubic through both keys with their slopes. */
function smoothAt(track, index, time) {
  const [[start, from], [end, to]] = [track[index], track[index + 1]];
  const length = end - start;
  const t = (time - start) / length;
  const [out, into] = [index, index + 1].map((key) => length * slopeOf(track, key));
  const rest = 1 - t;
  return from * (1 + 2 * t) * rest * rest + out * t * rest * rest + to * t * t * (3 - 2 * t) - into * t * t * rest;
}

/** The slope at a key: its own, or one with which curves never leave the keys' values, flat at the first, the last and where the values turn, else the weighted harmonic mean of both sides. */
export function slopeOf(track, key) {
  const [before, here, after] = [track[key - 1], track[key], track[key + 1]];
  if (here.length > 3) return here[3];
  if (!before || !after) return 0;
  const [left, right] = [here[0] - before[0], after[0] - here[0]];
  const [rise, fall] = [(here[1] - before[1]) / left, (after[1] - here[1]) / right];
  if (rise * fall <= 0) return 0;
  const [heavy, light] = [left + 2 * right, 2 * left + right];
  return (heavy + light) / (heavy / rise + light / fall);
}
