// An animator's work on one character as JSON: keys, constant values, what is changed and not keyed, locks, and
// elements put elsewhere.  Controls and elements go by name, so that a new layout of the character can take it up.

import { byName, keysFrom, sayKeys, valuesByName } from './by_name.js';
import { counted } from './dom.js';
import { joined, noteFrom, saidNote } from './notes.js';
import { poseFrom } from './pose_library.js';

/** All work of a session; null where there is none. */
export function workOf(session) {
  const { frame, neutral, own: values, controls, elements, moved, locks, shelf, notes, received, sound, span } = session;
  const from = neutral ? session.rest : session.given;
  const changed = [...values.keys()].filter((index) => values[index] !== from[index]);
  if (!session.keys.size && !session.constants.size && !changed.length && !span && isBare(session)) return null;
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
export const isAllKeys = (session) => !session.unkeyed().length && isBare(session);

/** Whether there is nothing but values. */
const isBare = ({ moved, locks, shelf, sound, notes, arrived }) => !moved.size && !locks.size && !shelf.length && !sound && notes === arrived;

/** Take up work in a session, as one undoable step; what the character does not have is left out. */
export function resume(session, work) {
  const { controls, elements } = session;
  const before = session.snapshot();
  const { keys, constants, span } = keysFrom(work, session);
  session.locks = new Set(controls.flatMap(({ name }, index) => (work.locks?.includes(name) ? [index] : [])));
  for (const [name, entry, placement] of work.moved ?? []) {
    const element = elements.list.find((each) => each.name === name && each.members.length === placement.members.length);
    if (!element || !Array.isArray(entry)) continue; // those of older pages are none
    elements.restore(element, placement);
    session.moved.set(element.index, entry);
  }
  const neutral = work.neutral === true;
  const frame = Number.isFinite(work.frame) ? work.frame : session.frame;
  const given = neutral ? Float64Array.from(session.rest) : session.animation.at(frame, { keys, constants }).values;
  const values = Float64Array.from(given);
  byName(work.changed, controls).forEach((value, index) => (values[index] = value));
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

const isSound = (sound) => typeof sound?.name === 'string' && Number.isFinite(sound.start) && sound.seconds >= 0;
