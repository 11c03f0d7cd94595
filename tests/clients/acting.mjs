// A session in an animator's hands, without a browser.

import { keysGoing, keysWithin, withKeys } from '../../viewer/src/keying.js';

/** What an animator does: [name, ...arguments]. */
export function act(session, [name, ...rest]) {
  const index = new Map(session.controls.map((control, i) => [control.name, i]));
  const acts = {
    go: (frame) => session.go(frame),
    set: (values) => session.edit('Set', () => session.set(Object.entries(values).map(([each, value]) => [index.get(each), value]))),
    key: (names) => session.key(names.map((each) => index.get(each))),
    unkey: (names) => session.unkey(names.map((each) => index.get(each))),
    'go on': (way, names) =>
      session.rekey(way, keysGoing(way, session.keys, keysWithin(session.keys, names.map((each) => index.get(each)), [-Infinity, Infinity]))),
    bend: (names, slope) => session.rekey('bend', withKeys(session.keys, names.map((each) => index.get(each)).flatMap((control) => (session.keys.get(control) ?? []).map(([frame, value]) => [control, [frame, value, 'smooth', slope]])))),
    span: (first, last) => session.respan(first, last),
    reset: () => session.reset(),
    undo: () => session.undo(),
    redo: () => session.redo(),
    autoKey: (on) => session.setOption('autoKey', on),
  };
  acts[name](...rest);
}

/** Channel weights and local joint transforms as they are shown. */
export function shown({ deformer, character }) {
  const locals = character.joints.map((_, joint) => Array.from(deformer.skeletons.localAt(joint, deformer.moves)));
  return { weights: Array.from(deformer.weights), locals };
}

/** The same at a time. */
export function at(session, time) {
  session.go(time);
  return shown(session);
}
