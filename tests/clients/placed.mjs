// Where the viewer has elements, without a browser: JSON of cases on standard input, [{scene, times}]; out come, per case, all
// values with handle and tracks of each element at each time.

import { text } from 'node:stream/consumers';

import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';

const found = [];
for (const { scene, times } of JSON.parse(await text(process.stdin))) {
  const { characters } = await readScene(scene);
  const session = new Session(characters[0]);
  found.push(times.map((time) => {
    session.go(time);
    return { values: Array.from(session.values), elements: session.elements.list.map(({ handle, tracks }) => ({ handle, tracks })) };
  }));
}
process.stdout.write(JSON.stringify(found));
