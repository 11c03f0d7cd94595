// Two pages on one animation: what both have said since they last agreed, merged per control and frame.
// Works are as `sayKeys` says them: {keys: {name: [[frame, ...]]}, standing: {name: value}, span: [first, last] if set by hand}.

import { ascending } from './vectors.js';

/**
 * `base` is what both began from.  What one of them changed is taken from it; where both changed one thing differently
 * `mine` stands, and a key over its removal.  `conflicts` are the [control, frame] of these, frame null for a
 * value that stands at all frames; `taken` the names of controls that are not as in `mine`.
 */
export function merged(base, mine, theirs) {
  const conflicts = [];
  const chosen = (what, b, m, t) => {
    if (same(m, b)) return t;
    if (same(t, b) || same(m, t)) return m;
    conflicts.push(what);
    return m ?? t;
  };
  const keys = perName(base.keys, mine.keys, theirs.keys, (name, ...tracks) => {
    const [b, m, t] = tracks.map((track) => new Map((track ?? []).map((key) => [key[0], key])));
    const frames = ascending([...b.keys(), ...m.keys(), ...t.keys()]);
    const track = frames.map((frame) => chosen([name, frame], b.get(frame), m.get(frame), t.get(frame))).filter(Boolean);
    return track.length ? track : undefined;
  });
  const standing = perName(base.standing, mine.standing, theirs.standing, (name, ...values) => chosen([name, null], ...values));
  const span = chosen(['frames', null], base.span, mine.span, theirs.span);
  const work = { keys, standing, ...(span && { span }) };
  return { work, conflicts, taken: differing(mine, work) };
}

export const NOTHING = { keys: {}, standing: {} };

/** Names of controls of which two works say different things; 'frames' where they do of the first and last one. */
export function differing(one, other) {
  const names = (part) => union(one[part], other[part]).filter((name) => !same(one[part][name], other[part][name]));
  return [...new Set([...names('keys'), ...names('standing'), ...(same(one.span, other.span) ? [] : ['frames'])])];
}

function perName(base, mine, theirs, merge) {
  const entries = union(base, mine, theirs).map((name) => [name, merge(name, base[name], mine[name], theirs[name])]);
  return Object.fromEntries(entries.filter(([, value]) => value !== undefined));
}

const union = (...parts) => [...new Set(parts.flatMap(Object.keys))].sort();
const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
