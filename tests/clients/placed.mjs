// Where the viewer has points and elements, without a browser: JSON of cases on standard input, [{scene, times, poses}];
// out come, per case, all values with handle and tracks of each element at each time, and the same with all points at each pose.

import { text } from 'node:stream/consumers';

import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';

const placed = ({ elements }) => elements.list.map(({ handle, tracks }) => ({ handle, tracks }));

const found = [];
for (const { scene, times = [], poses = [] } of JSON.parse(await text(process.stdin))) {
  const { characters } = await readScene(scene);
  const session = new Session(characters[0]);
  const frames = times.map((time) => {
    session.go(time);
    return { values: Array.from(session.values), elements: placed(session) };
  });
  const posed = poses.map((values) => {
    session.values.set(values);
    session.deformer.setBase(null, null);
    session.reshape();
    return { points: Array.from(session.deformer.points), elements: placed(session) };
  });
  found.push({ frames, posed });
}
process.stdout.write(JSON.stringify(found));
