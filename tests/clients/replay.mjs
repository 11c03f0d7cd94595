// Replays animators' sessions with the viewer's own sources, without a browser: JSON of cases on standard input,
// [{scene, actions, times}]; out come, per case, what the page shows at each time, and the layers that it saves.

import { text } from 'node:stream/consumers';

import { animationLayer, poseLayer, keysFromLayer } from '../../viewer/src/animation_layer.js';
import { readScene } from '../../viewer/src/scene.js';
import { posesFromLayer, posesLayer } from '../../viewer/src/pose_library.js';
import { Session } from '../../viewer/src/session.js';
import { act, at, shown } from './acting.mjs';

const found = [];
for (const { scene, actions, times } of JSON.parse(await text(process.stdin))) {
  const { characters } = await readScene(scene);
  const session = new Session(characters[0]);
  actions.forEach((action) => act(session, action));
  const pose = { text: poseLayer(session).text, shown: shown(session) };
  const shelf = shelved(session);
  const { text: layer, unwritten } = animationLayer(session);
  const frames = times.map((time) => at(session, time));
  found.push({ pose, shelf, layer, unwritten, frames, again: reloaded(characters[0], layer, times) });
}
process.stdout.write(JSON.stringify(found));

/** The pose of all controls and of every other one as a layer; what comes back from it, and channels by pose. */
function shelved(session) {
  const { controls, values, deformer, character } = session;
  const some = [...controls.keys()].map((control) => [control, values[control]]);
  const poses = [some, some.filter(([control]) => control % 2)].filter((pose) => pose.length);
  session.put('Keep', { shelf: poses.map((pose, i) => ({ name: `"${i}" and 1/2`, values: new Map(pose), picture: '' })) });
  const { text, unwritten } = posesLayer(session, session.shelf);
  const expected = session.shelf.map((pose) => {
    deformer.setBase(null, null);
    deformer.drive(Float64Array.from(controls, ({ default: off }, i) => pose.values.get(i) ?? off));
    const driven = new Set([...pose.values.keys()].flatMap((control) => controls[control].drive.channels));
    return Object.fromEntries([...driven].map((channel) => [character.channels[channel].token, deformer.weights[channel]]));
  });
  session.showBase();
  session.reshape();
  const again = posesFromLayer(text, session).map(({ name, values: found }) => [name, Object.fromEntries(found)]);
  const kept = session.shelf.map(({ name, values: found }) => [name, Object.fromEntries(found)]);
  return { text, unwritten, expected, again, kept };
}

/** The same times in another session that has loaded the layer. */
function reloaded(character, layer, times) {
  if (!layer) return null;
  const session = new Session(character);
  const { keys, constants } = keysFromLayer(layer, session);
  session.load('Load', keys, constants);
  return times.map((time) => at(session, time));
}
