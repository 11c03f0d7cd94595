// Bundles src/, three.js and gl-matrix into one script and one style sheet, committed with the Python package so
// that installing it needs no Node.js.  `npm run check` fails when the committed files are out of date.
// gl-matrix is one module in assets/ besides, which src/ imports: so Node.js alone runs the tests of src/, without npm.
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

const check = process.argv.includes('--check');
let stale = false;

/** Write a file that is out of date, or say so. */
async function settle(target, contents) {
  const committed = await readFile(target).catch(() => null);
  if (committed?.equals(contents)) return;
  stale = true;
  if (check) console.error(`${target.pathname.split('/').at(-1)} is out of date: run \`npm ci && npm run build\` in viewer/`);
  else await writeFile(target, contents);
}

const maths = await build({
  stdin: { contents: "export { glMatrix, mat3, mat4, quat, quat2, vec3 } from 'gl-matrix';", resolveDir: 'node_modules' },
  bundle: true,
  minify: true,
  write: false,
  format: 'esm',
  charset: 'utf8',
  outfile: 'gl-matrix.js',
  banner: { js: '// @ts-nocheck\n// gl-matrix, https://glmatrix.net, under the MIT licence in usdrigui/view/assets/gl-matrix-LICENSE.txt' },
});
await settle(new URL('assets/gl-matrix.js', import.meta.url), Buffer.from(maths.outputFiles[0].contents));

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

for (const [name, contents] of files) await settle(new URL(name, ASSETS), contents);
if (stale && check) process.exit(1);
