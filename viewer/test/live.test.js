// A page and its file, over a face of weights alone; what USD makes of the file the tests of the server have.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Live } from '../src/live.js';
import { Session } from '../src/session.js';

const drive = { values: [0, 1], channels: [0], weights: [[0], [1]], joints: [], rotations: [[], []], translations: [[], []], scales: [[], []] };

function face() {
  return new Session({
    root: '/A', clip: null, meshes: [], joints: [], pointCount: 0, bind: [], base: new Float64Array(0),
    skeletons: [{ path: '/A/Skel', animation: '/A/Anim', toRoot: [] }],
    channels: [{ token: 'jaw', index: 0, animation: '/A/Anim' }],
    baseWeights: [0],
    controls: [{ name: 'jaw', label: 'jaw', kind: 'blendShape', minimum: 0, default: 0, maximum: 1, attribute: '', drive, reading: { rises: [[0, 1]] } }],
    layout: { sections: [{ elements: [], handleWidth: 1 }], elements: [], baseValues: [0], colours: {} },
  });
}

/** A server of one file, which refuses while `file.refusal` says why. */
function serve() {
  const file = { text: '', refusal: '' };
  globalThis.fetch = async (_, { method, headers, body }) => {
    const tag = `"${file.text.length}"`;
    if (file.refusal) return new Response(file.refusal, { status: 507 });
    if (method === 'PUT') file.text = body;
    else if (headers['If-None-Match'] === tag) return new Response(null, { status: 304, headers: { ETag: tag } });
    return new Response(method === 'PUT' ? '' : file.text, { headers: { ETag: `"${file.text.length}"` } });
  };
  return file;
}

async function settle(live) {
  for (let turn = 0; turn < 6; turn++) await live.turn();
}

test('a file that cannot be read for a moment is told, and read again', async () => {
  const file = serve();
  const session = face();
  const said = [];
  const live = new Live([session], 'edit.usda', (words) => said.push(words), '');
  live.follow(session);
  await settle(live);
  session.go(3);
  session.edit('Set', () => session.set([[0, 0.5]]));
  session.key([0]);
  await settle(live);
  assert.match(file.text, /"jaw\\":\[\[3,0.5\]\]/);
  for (const refusal of ['FILE_PERMISSION', '']) {
    file.refusal = refusal;
    await settle(live);
    assert.deepEqual([live.refusal, live.state], refusal ? [refusal, 'refused'] : ['', 'saved']);
  }
  assert.deepEqual(said, ['edit.usda: FILE_PERMISSION']);
});
