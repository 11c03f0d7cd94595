import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import test from 'node:test';

const SRC = new URL('../src/', import.meta.url);

/** Modules that import each other in a circle, as the path around it; null where there is none. */
function circleOf(imports) {
  const done = new Set();
  const around = (name, path) => {
    if (path.includes(name)) return [...path.slice(path.indexOf(name)), name];
    if (done.has(name)) return null;
    const found = (imports.get(name) ?? []).map((next) => around(next, [...path, name])).find(Boolean);
    done.add(name);
    return found ?? null;
  };
  return [...imports.keys()].map((name) => around(name, [])).find(Boolean) ?? null;
}

test('no modules import each other in a circle', async () => {
  assert.deepEqual(circleOf(new Map([['a', ['b']], ['b', ['c']], ['c', ['a']]])), ['a', 'b', 'c', 'a']);
  const names = (await readdir(SRC)).filter((name) => name.endsWith('.js'));
  const imports = new Map(await Promise.all(names.map(async (name) => {
    const text = await readFile(new URL(name, SRC), 'utf8');
    return [name, [...text.matchAll(/from '\.\/([^']+)'/g)].map(([, file]) => file)];
  })));
  assert.ok(imports.size > 40);
  assert.equal(circleOf(imports), null);
});
