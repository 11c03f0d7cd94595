// Pages on one live file, without a browser: {scene, address, origin, rounds, times} on standard input.  In each round
// [actions of a page]... (on the first character, or ["of", its number, action]), or {path, from, to} of another program on the file, are done, then the pages write and look in turn until none has anything more to say.

import { readFileSync, writeFileSync } from 'node:fs';
import { text } from 'node:stream/consumers';

import { saidKeys } from '../../viewer/src/animation_layer.js';
import { Live } from '../../viewer/src/live.js';
import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';
import { act, at } from './acting.mjs';

const { scene, address, origin, rounds, times } = JSON.parse(await text(process.stdin));
const plain = globalThis.fetch;
globalThis.fetch = (where, { headers, ...rest }) => plain(where, { ...rest, headers: { ...headers, Origin: origin } });

const pages = [];
for (const _ of rounds[0]) {
  const { characters } = await readScene(scene);
  const sessions = characters.map((character) => new Session(character));
  const said = [];
  const live = new Live(sessions, 'edit.usda', (words) => said.push(words), address);
  sessions.forEach((session) => live.follow(session));
  pages.push({ session: sessions[0], sessions, live, said });
}
await settled();
const after = [];
for (const round of rounds) {
  if (round.path) writeFileSync(round.path, readFileSync(round.path, 'utf8').replace(round.from, round.to));
  else round.forEach((actions, i) => actions.forEach((action) => (action[0] === 'of' ? act(pages[i].sessions[action[1]], action[2]) : act(pages[i].session, action))));
  await settled();
  after.push(pages.map(({ session }) => saidKeys(session)));
}
const states = pages.map(({ live }) => live.state);
const frames = pages.map(({ session }) => times.map((time) => at(session, time)));
const all = pages.map(({ sessions }) => sessions.map(saidKeys));
process.stdout.write(JSON.stringify({ after, all, frames, said: pages.map(({ said }) => said), states }));

/** Turns of the pages, as their clocks would give them, the last of which only look. */
async function settled() {
  for (let turn = 0; turn < 12; turn++) for (const { live } of pages) await live.turn();
}
