// Pages that share a file, each over a face of its own; what USD makes of the file the tests of the server have.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Live } from '../src/live.js';
import { saidKeys } from '../src/animation_layer.js';
import { Session } from '../src/session.js';
import { stringsNamed } from '../src/usda.js';

const drive = (channel) => ({ values: [0, 1], channels: [channel], weights: [[0], [1]], joints: [], rotations: [[], []], translations: [[], []], scales: [[], []] });

/** A face of weights alone, by the names of its controls. */
function faceOf(root, names) {
  return new Session({
    root, clip: null, meshes: [], joints: [], pointCount: 0, bind: [], base: new Float64Array(0),
    skeletons: [{ path: `${root}/Skel`, animation: `${root}/Anim`, toRoot: [] }],
    channels: names.map((token, index) => ({ token, index, animation: `${root}/Anim` })),
    baseWeights: names.map(() => 0),
    controls: names.map((name, i) => ({ name, label: name, kind: 'blendShape', minimum: 0, default: 0, maximum: 1, attribute: `${root}/UI/${name}.rigUI:control:${name}:value`, drive: drive(i), reading: { rises: [[i, 1]] } })),
    layout: { sections: [{ elements: [], handleWidth: 1 }], elements: [], baseValues: names.map(() => 0), colours: {} },
  });
}

/** A server of one file: what pages save, and what programs have changed of it since. */
function serve() {
  let text = '';
  let revision = 0;
  const none = { changed: {}, written: [], names: {} };
  let changes = none;
  let refusal = null;
  let puts = 0;
  globalThis.fetch = async (_, { method, headers, body }) => {
    const tag = { ETag: `"${revision}"` };
    if (refusal) return new Response(refusal, { status: 507 });
    if (method === 'GET') {
      if (headers['If-None-Match'] === tag.ETag) return new Response(null, { status: 304, headers: tag });
      return new Response(text && JSON.stringify({ work: stringsNamed('work', text)[0], ...changes }), { headers: tag });
    }
    if (headers['If-Match'] !== tag.ETag) return new Response('', { status: 412 });
    puts++;
    text = body;
    changes = none;
    return new Response('', { headers: { ETag: `"${++revision}"` } });
  };
  const change = (found) => {
    changes = { ...none, ...found };
    revision++;
  };
  const refuse = (words) => (refusal = words);
  return { change, refuse, puts: () => puts, works: () => JSON.parse(stringsNamed('work', text)[0]) };
}

const NAMES = ['jaw', 'brow'];

/** A page of characters, each given by the root of it. */
function pageOf(...roots) {
  const sessions = roots.map((root) => faceOf(root, NAMES));
  const page = { sessions, said: [], live: new Live(sessions, 'edit.usda', (words) => page.said.push(words), '') };
  sessions.forEach((session) => page.live.follow(session));
  return page;
}

async function settle(...pages) {
  for (let turn = 0; turn < 12; turn++) for (const { live } of pages) await live.turn();
}

/** Key a control as an animator does. */
function key(session, name, frame, value) {
  const control = NAMES.indexOf(name);
  session.go(frame);
  session.edit('Set', () => session.set([[control, value]]));
  session.key([control]);
}

const keysOn = ({ sessions: [first] }) => saidKeys(first).keys;

test('undo takes back one\'s own key, not the one of another page that came after it; redo gives it again', async () => {
  serve();
  const [one, other] = [pageOf('/A'), pageOf('/A')];
  await settle(one, other);
  key(one.sessions[0], 'jaw', 3, 0.5);
  await settle(one, other);
  key(other.sessions[0], 'brow', 5, 0.25);
  await settle(one, other);
  for (const [step, found] of [['undo', { brow: [[5, 0.25]] }], ['redo', { jaw: [[3, 0.5]], brow: [[5, 0.25]] }]]) {
    one.sessions[0][step]();
    await settle(one, other);
    assert.deepEqual([keysOn(one), keysOn(other)], [found, found]);
  }
  assert.deepEqual(one.said, ['edit.usda changed elsewhere: brow']);
});

test('keys of each character and the first and last frame are on every page; of what a page has not they stay', async () => {
  const server = serve();
  const [one, other] = [pageOf('/A', '/B'), pageOf('/A', '/B')];
  await settle(one, other);
  key(one.sessions[0], 'jaw', 3, 0.5);
  key(other.sessions[1], 'jaw', 5, 0.25);
  one.sessions[0].respan(101, 120);
  await settle(one, other);
  const all = [{ keys: { jaw: [[3, 0.5]] }, standing: {}, span: [101, 120] }, { keys: { jaw: [[5, 0.25]] }, standing: {} }];
  for (const { sessions, live } of [one, other]) assert.deepEqual([sessions.map(saidKeys), live.state], [all, 'saved']);
  const alone = pageOf('/A');
  alone.sessions[0].controls[0].name = 'lid';
  await settle(alone);
  key(alone.sessions[0], 'brow', 7, 0.5);
  await settle(alone);
  const [first, second] = server.works().characters;
  assert.deepEqual([first.keys, second], [{ brow: [[7, 0.5]], jaw: [[3, 0.5]] }, { root: '/B', ...all[1] }]);
});

test('of two values for one key the page that comes second is asked, once, and both have what it answers', async () => {
  serve();
  const [one, other] = [pageOf('/A'), pageOf('/A')];
  await settle(one, other);
  key(one.sessions[0], 'jaw', 3, 0.5);
  key(other.sessions[0], 'jaw', 3, 0.25);
  key(other.sessions[0], 'brow', 5, 0.75);
  await settle(one, other);
  assert.deepEqual([one, other].map(({ live }) => live.asked.flatMap(({ conflicts }) => conflicts)), [[], [['jaw', 3]]]);
  assert.deepEqual(other.said, ['Changed here and elsewhere, as here now: jaw at frame 3']);
  assert.deepEqual([keysOn(one), keysOn(other)], Array(2).fill({ jaw: [[3, 0.25]], brow: [[5, 0.75]] }));
  other.live.takeTheirs();
  await settle(one, other);
  assert.deepEqual([keysOn(one), keysOn(other)], Array(2).fill({ jaw: [[3, 0.5]], brow: [[5, 0.75]] }));
  assert.deepEqual([one.live.asked, other.live.asked, one.said.at(-1)], [[], [], 'edit.usda changed elsewhere: jaw']);
  key(one.sessions[0], 'jaw', 3, 1);
  key(other.sessions[0], 'jaw', 3, 0);
  await settle(one, other);
  for (const [name, frame, open] of [['brow', 9, 1], ['jaw', 3, 0]]) {
    key(one.sessions[0], name, frame, 0.5);
    await settle(one, other);
    assert.equal(other.live.asked.length, open, 'a question is open as long as its answer changes something');
  }
});

test('samples and values of programs come as keys, and what they remove goes', async () => {
  const server = serve();
  const page = pageOf('/A');
  await settle(page);
  for (const [name, frame, value] of [['jaw', 5, 0.5], ['jaw', 9, 0.25], ['brow', 5, 0.125]]) key(page.sessions[0], name, frame, value);
  const value = '/A/UI/jaw.rigUI:control:jaw:value';
  const ofValue = (text) => ({ changed: { [value]: text }, written: [value] });
  const samples = (...lines) => ofValue(`double ${value}.timeSamples = {\n${lines.map((line) => `    ${line},\n`).join('')}}\n`);
  const weights = {
    changed: { '/A/Anim.blendShapeWeights': 'float[] blendShapeWeights.timeSamples = {\n    5: [0.125, 0.75],\n    9: [nan, 1],\n}\n' },
    names: { '/A/Anim.blendShapes': 'uniform token[] blendShapes = ["brow", "jaw"]' },
  };
  for (const [did, changes, found] of [
    ['another weight at a frame, one that is no number', weights, [[5, 0.75], [9, 0.25]]],
    ['another value between the keys', samples('5: 0.75', '7: 1', '9: 0.25'), [[5, 0.75], [7, 1], [9, 0.25]]],
    ['a spline', samples('5: 0.75; post linear', '7: 0.5; pre (1, 0.5); post held', '9: 0.25'), [[5, 0.75], [7, 0.5], [9, 0.25]]],
    ['no value at a frame', samples('7: 1', '9: 0.25'), [[7, 1], [9, 0.25]]],
    ['one value at all frames', ofValue('double x = 0.5 (\n    doc = "1: 2"\n)\n'), [[7, 0.5], [9, 0.5]]],
    ['an attribute that is gone', ofValue(''), undefined],
    ['one value where there is no key', { ...ofValue('custom double x = 0.5'), written: [] }, undefined],
  ]) {
    await settle(page);
    server.change(changes);
    await settle(page);
    assert.deepEqual([keysOn(page).jaw, keysOn(page).brow, page.live.state], [found, [[5, 0.125]], 'saved'], did);
  }
  assert.deepEqual([saidKeys(page.sessions[0]).standing, page.live.asked], [{ jaw: 0.5 }, []]);
});

test('a file that cannot be read for a moment is told, and read again', async () => {
  const server = serve();
  const page = pageOf('/A');
  await settle(page);
  key(page.sessions[0], 'jaw', 3, 0.5);
  for (const words of ['FILE_NOT_USD at line 3', null]) {
    await settle(page);
    server.refuse(words);
    await settle(page);
    assert.deepEqual([page.live.refusal, page.live.state], words ? [words, 'refused'] : ['', 'saved']);
  }
});

test('what was only saved again is not written; a change that no key shows is taken back, and told as saved at once', async () => {
  const server = serve();
  const page = pageOf('/A');
  await settle(page);
  key(page.sessions[0], 'jaw', 3, 0.5);
  await page.live.turn();
  assert.deepEqual([server.puts(), page.live.state], [1, 'saved']);
  for (const [changed, puts] of [[{}, 1], [{ '/A/Anim.joints': '' }, 2]]) {
    server.change({ changed });
    await settle(page);
    assert.deepEqual([server.puts(), page.live.state, keysOn(page)], [puts, 'saved', { jaw: [[3, 0.5]] }]);
  }
});

test('one value for all frames goes where a key comes, also of a character that is not shown', async () => {
  const server = serve();
  const page = pageOf('/A');
  const other = pageOf('/A');
  const [session] = page.sessions;
  await settle(page, other);
  session.edit('Set', () => session.set([[1, 0.5]]));
  await settle(page, other);
  assert.deepEqual([server.works().standing, saidKeys(other.sessions[0]).standing], [{ brow: 0.5 }, { brow: 0.5 }]);
  key(other.sessions[0], 'brow', 9, 0.125);
  await settle(page, other);
  assert.deepEqual([server.works().standing, server.works().keys], [{}, { brow: [[9, 0.125]] }]);
  key(session, 'brow', 3, 0.25);
  key(other.sessions[0], 'brow', 3, 0.75);
  await settle(page, other);
  assert.deepEqual(server.works().keys, { brow: [[3, 0.75], [9, 0.125]] });
  other.sessions[0].leave();
  other.live.takeTheirs();
  await settle(page, other);
  assert.deepEqual([server.works().keys, keysOn(page), keysOn(other)], Array(3).fill({ brow: [[3, 0.25], [9, 0.125]] }));
});
