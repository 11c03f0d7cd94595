// Where the viewer has elements at times, without a browser: JSON of cases on standard input, [{scene, times}]; out
// come, per case and time, handle and tracks of each element.

import { text } from 'node:stream/consumers';

import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';

const found = [];
for (const { scene, times } of JSON.parse(await text(process.stdin))) {
  const { characters } = await readScene(scene);
  const session = new Session(characters[0]);
  found.push(times.map((time) => {
    session.go(time);
    return session.elements.list.map(({ handle, tracks }) => ({ handle, tracks }));
  }));
}
process.stdout.write(JSON.stringify(found));
