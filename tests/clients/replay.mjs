// Replays animators' sessions with the viewer's own sources, without a browser: JSON of cases on standard input,
// [{scene, actions, times}]; out come, per case, what the page shows at each time, and the layers that it saves.

import { text } from 'node:stream/consumers';

import { animationLayer, poseLayer, keysFromLayer } from '../../viewer/src/animation_layer.js';
import { keysGoing, keysWithin } from '../../viewer/src/keying.js';
import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';

const found = [];
for (const { scene, actions, times } of JSON.parse(await text(process.stdin))) {
  const { characters } = await readScene(scene);
  const session = new Session(characters[0]);
  actions.forEach((action) => act(session, action));
  const pose = { text: poseLayer(session).text, shown: shown(session) };
  const { text: layer, unwritten } = animationLayer(session);
  const frames = times.map((time) => at(session, time));
  found.push({ pose, layer, unwritten, frames, again: reloaded(characters[0], layer, times) });
}
process.stdout.write(JSON.stringify(found));

function act(session, [name, ...rest]) {
  const index = new Map(session.controls.map((control, i) => [control.name, i]));
  const acts = {
    go: (frame) => session.go(frame),
    set: (values) => session.edit('Set', () => session.set(Object.entries(values).map(([each, value]) => [index.get(each), value]))),
    key: (names) => session.key(names.map((each) => index.get(each))),
    unkey: (names) => session.unkey(names.map((each) => index.get(each))),
    'go on': (way, names) =>
      session.rekey(way, keysGoing(way, session.keys, keysWithin(session.keys, names.map((each) => index.get(each)), [-Infinity, Infinity]))),
    reset: () => session.reset(),
    undo: () => session.undo(),
    redo: () => session.redo(),
    autoKey: (on) => session.setOption('autoKey', on),
  };
  acts[name](...rest);
}

function shown({ deformer, character }) {
  const locals = character.joints.map((_, joint) => Array.from(deformer.skeletons.localAt(joint, deformer.moves)));
  return { weights: Array.from(deformer.weights), locals };
}

function at(session, time) {
  session.go(time);
  return shown(session);
}

/** The same times in another session that has loaded the layer. */
function reloaded(character, layer, times) {
  if (!layer) return null;
  const session = new Session(character);
  const { keys, standing } = keysFromLayer(layer, session);
  session.load('Load', keys, standing);
  return times.map((time) => at(session, time));
}
