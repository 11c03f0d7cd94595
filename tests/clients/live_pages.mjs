// Two pages on one live file, without a browser.  On standard input a line of {scene, address, origin}, then lines of steps:
// ["act", page, ...actions], ["turn", page] of its clock, ["settle"]: turns until none has anything more to say, ["show", times].
// Each line is answered with what the pages hold: keys and standing values, the state of the link, what was asked since.

import { createInterface } from 'node:readline';

import { saidKeys } from '../../viewer/src/animation_layer.js';
import { Live } from '../../viewer/src/live.js';
import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';
import { act, at } from './acting.mjs';

const pages = [];
const steps = {
  act: (page, ...actions) => actions.forEach((action) => act(pages[page].session, action)),
  turn: (page) => pages[page].live.turn(),
  settle: async () => {
    for (let turn = 0; turn < 12; turn++) for (const { live } of pages) await live.turn();
  },
  show: (times) => pages.forEach((page) => (page.frames = times.map((time) => at(page.session, time)))),
};

for await (const line of createInterface({ input: process.stdin })) {
  const asked = JSON.parse(line);
  if (asked.scene) await open(asked);
  else for (const [step, ...rest] of asked) await steps[step](...rest);
  const found = pages.map(({ session, live, frames, known }) => {
    const asked = live.asked.filter((each) => !known.has(each));
    asked.forEach((each) => known.add(each));
    return { ...saidKeys(session), state: live.state, revision: live.revision, frames, asked: asked.flatMap(({ conflicts }) => conflicts) };
  });
  process.stdout.write(`${JSON.stringify(found)}\n`);
}

async function open({ scene, address, origin }) {
  const plain = globalThis.fetch;
  globalThis.fetch = (where, { headers, ...rest }) => plain(where, { ...rest, headers: { ...headers, Origin: origin } });
  for (let page = 0; page < 2; page++) {
    const { characters } = await readScene(scene);
    const { controls, root } = characters[0];
    controls.forEach((control, i) => (control.attribute = `${root}/rigUI/c${i}.rigUI:control:c${i}:value`));
    const session = new Session(characters[0]);
    const live = new Live([session], 'edit.usda', () => {}, address);
    live.follow(session);
    pages.push({ session, live, known: new Set() });
  }
  await steps.settle();
}
