// Bundles src/, three.js and gl-matrix into one script and one style sheet, committed with the Python package so
// that installing it needs no Node.js.  `npm run check` fails when the committed files are out of date.
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { readdir, readFile, writeFile } from 'node:fs/promises';

const ASSETS = new URL('../usdrigui/view/assets/', import.meta.url);

// The built script ends with a digest of what it was built from, so that whether it is up to date can be told
// without Node.js (tests/package/test_viewer_is_built.py): SHA-256 over name and contents of every file.
async function digestOfSources() {
  const names = (await readdir(new URL('src/', import.meta.url))).sort().map((name) => `src/${name}`);
  const hash = createHash('sha256');
  for (const name of [...names, 'build.mjs', 'package-lock.json']) {
    hash.update(`${name}\0`).update(await readFile(new URL(name, import.meta.url))).update('\0');
  }
  return hash.digest('hex');
}

const result = await build({
  entryPoints: { viewer: 'src/main.js' },
  bundle: true,
  minify: true,
  write: false,
  format: 'iife',
  target: ['chrome100', 'firefox110'],
  charset: 'utf8',
  legalComments: 'inline',
  outdir: 'out',
  footer: { js: `// sources ${await digestOfSources()}` },
});

const files = new Map(result.outputFiles.map((file) => [file.path.split('/').at(-1), Buffer.from(file.contents)]));
for (const [name, path] of [['three', 'LICENSE'], ['gl-matrix', 'LICENSE.md']]) {
  files.set(`${name}-LICENSE.txt`, await readFile(new URL(`node_modules/${name}/${path}`, import.meta.url)));
}

let stale = false;
for (const [name, contents] of files) {
  const target = new URL(name, ASSETS);
  const committed = await readFile(target).catch(() => null);
  if (committed?.equals(contents)) continue;
  stale = true;
  if (process.argv.includes('--check')) console.error(`${name} is out of date: run \`npm ci && npm run build\` in viewer/`);
  else await writeFile(target, contents);
}
if (stale && process.argv.includes('--check')) process.exit(1);
