// An animator's work on one character as JSON: keys, constant values, what is changed and not keyed, locks, and
// elements put elsewhere.  Controls and elements go by name, so that a new layout of the character can take it up.

import { counted } from './dom.js';
import { WAYS, wayOf } from './interpolation.js';
import { joined, noteFrom, saidNote } from './notes.js';
import { poseFrom } from './pose_library.js';

/** Keys and constant values by names of controls, in the controls' order, and the frames as set by hand.  A file calls constants `standing`. */
export function sayKeys({ controls }, { keys, constants, span = null }) {
  const byNames = (map, say) => Object.fromEntries([...map].sort(([a], [b]) => a - b).map(([control, value]) => [controls[control].name, say(value)]));
  return {
    keys: byNames(keys, (track) => track.map(([frame, value, ...way]) => [rounded(frame), rounded(value), ...way])),
    standing: byNames(constants, rounded),
    ...(span && { span }),
  };
}

/** The opposite of `sayKeys`; controls that the character lacks and values that are none are left out. */
export function keysFrom({ keys, standing, span }, { controls, animation }) {
  const own = animation.isFree && isSpan(span) ? span : null;
  return { keys: byControl(keys, controls, isTrack), constants: byControl(standing, controls, Number.isFinite), span: own };
}

/** Values by names of controls, and back; what the character lacks and what is no number is left out. */
export const valuesByName = (session, values) => sayKeys(session, { keys: new Map(), constants: values }).standing;
export const byName = (values, controls) => byControl(values, controls, Number.isFinite);

/** All work of a session; null where there is none. */
export function workOf(session) {
  const { frame, neutral, own: values, controls, elements, moved, locks, shelf, notes, received, sound, span } = session;
  const from = neutral ? session.rest : session.given;
  const changed = [...values.keys()].filter((index) => values[index] !== from[index]);
  if (!session.keys.size && !session.constants.size && !changed.length && !moved.size && !locks.size && !shelf.length && !sound && !span && !isReviewed(session)) return null;
  return {
    frame,
    neutral,
    ...sayKeys(session, session),
    changed: Object.fromEntries(changed.map((index) => [controls[index].name, values[index]])),
    locks: [...locks].map((index) => controls[index].name),
    shelf: shelf.map((pose) => ({ ...pose, values: valuesByName(session, pose.values) })),
    notes: notes.map((note) => saidNote(session, note)),
    received,
    sound,
    moved: [...moved].map(([index, entry]) => [elements.list[index].name, entry, elements.placement(elements.list[index])]),
  };
}

/** Whether keys and constant values say all of a session's work. */
export const isAllKeys = (session) =>
  !session.unkeyed().length && !session.moved.size && !session.locks.size && !session.shelf.length && !session.sound && !isReviewed(session);

/** Whether notes are other than those that came with the page. */
const isReviewed = ({ notes, arrived }) => notes !== arrived;

/** Take up work in a session, as one undoable step; what the character does not have is left out. */
export function resume(session, work) {
  const { controls, elements } = session;
  const before = session.snapshot();
  const { keys, constants, span } = keysFrom(work, session);
  session.locks = new Set(controls.flatMap(({ name }, index) => (work.locks?.includes(name) ? [index] : [])));
  for (const [name, entry, placement] of work.moved ?? []) {
    const element = elements.list.find((each) => each.name === name && each.members.length === placement.members.length);
    if (!element) continue;
    elements.restore(element, placement);
    session.moved.set(element.index, entry);
  }
  const neutral = work.neutral === true;
  const frame = Number.isFinite(work.frame) ? work.frame : session.frame;
  const given = neutral ? Float64Array.from(session.rest) : session.animation.at(frame, { keys, constants }).values;
  const values = Float64Array.from(given);
  byControl(work.changed, controls, Number.isFinite).forEach((value, index) => (values[index] = value));
  const shelf = (work.shelf ?? []).map((pose) => poseFrom(pose, session)).filter(Boolean);
  const sound = isSound(work.sound) ? work.sound : null;
  const since = session.notes.filter(({ id }) => !work.received?.includes(id)); // what came after this work was kept
  const notes = joined(since, (work.notes ?? []).map((note) => noteFrom(note, session)).filter(Boolean));
  session.received = [...new Set([...session.received, ...(work.received ?? [])])];
  session.restore({ frame, neutral, keys, constants, given, values, shelf, notes, sound, span });
  session.step('Restore work', before);
  session.emit('options');
  session.emit('layout');
}

/** "12 keys of 3 controls, 2 changes that are not keyed". */
export function worded({ keys, standing, changed, moved, shelf, notes, sound, span }) {
  const tracks = Object.values(keys ?? {});
  const sum = tracks.reduce((total, track) => total + track.length, 0);
  const loose = Object.keys({ ...standing, ...changed }).length;
  return [
    sum ? `${counted(sum, 'key')} of ${counted(tracks.length, 'control')}` : '',
    loose ? `${counted(loose, 'control')} changed without a key` : '',
    moved?.length ? `${counted(moved.length, 'element')} moved` : '',
    shelf?.length ? `${counted(shelf.length, 'pose')} on the shelf` : '',
    notes?.length ? counted(notes.length, 'note') : '',
    sound ? `the place of ${sound.name}` : '',
    span ? `frames ${span[0]} to ${span[1]}` : '',
  ].filter(Boolean).join(', ') || 'locks';
}

function byControl(entries, controls, isValid) {
  const index = new Map(controls.map(({ name }, i) => [name, i]));
  const known = Object.entries(entries ?? {}).filter(([name, value]) => index.has(name) && isValid(value));
  return new Map(known.map(([name, value]) => [index.get(name), value]));
}

const isSpan = (span) => Array.isArray(span) && span.length === 2 && span.every(Number.isInteger) && span[0] < span[1];
const isSound = (sound) => typeof sound?.name === 'string' && Number.isFinite(sound.start) && sound.seconds >= 0;
const isKey = (key) =>
  Array.isArray(key) && [2, 3].includes(key.length) && key.slice(0, 2).every(Number.isFinite) && WAYS.includes(wayOf(key));
const isTrack = (track) => Array.isArray(track) && track.length > 0 && track.every(isKey);
const rounded = (value) => Number(value.toPrecision(9));
