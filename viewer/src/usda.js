// USD as text: prims nested by path, quoted strings, numbers; and the strings of a name out of a layer.

import { parsed } from './by_name.js';
import { rounded } from './vectors.js';

/** A layer of prims by path ({type, metadata, lines}, of which any may be missing), with lines of metadata. */
export function layerText(prims, metadata = []) {
  const head = metadata.length ? ['(', ...metadata.map((line) => `    ${line}`), ')'] : [];
  return ['#usda 1.0', ...head, '', ...rendered(nested(prims)), ''].join('\n');
}

/** Metadata, `customData` or `customLayerData`, in which the viewer keeps what it reads again. */
export const keeping = (home, ...lines) => [`${home} = {`, '    dictionary usdrigui = {', ...lines.map((line) => `        ${line}`), '    }', '}'];

/** Prims nested by path, those that share ancestors sharing the overs. */
function nested(prims) {
  const tree = { children: new Map() };
  for (const [path, prim] of prims) {
    let node = tree;
    for (const name of path.split('/').filter(Boolean)) {
      if (!node.children.has(name)) node.children.set(name, { children: new Map(), type: 'over', metadata: '', lines: [] });
      node = node.children.get(name);
    }
    Object.assign(node, prim);
  }
  return tree;
}

function rendered({ children }, indent = '') {
  return [...children].flatMap(([name, child]) => [
    `${indent}${child.type} ${quoted(name)}${child.metadata && ' ('}`,
    ...(child.metadata ? [...child.metadata.split('\n').map((line) => `${indent}    ${line}`), `${indent})`] : []),
    `${indent}{`,
    ...child.lines.map((line) => `${indent}    ${line}`),
    ...rendered(child, `${indent}    `),
    `${indent}}`,
  ]);
}

export function quoted(text) {
  const escaped = text.replace(/["\\]/g, '\\$&').replace(/\n/g, '\\n');
  return `"${escaped}"`;
}

const unquoted = (quotation) => quotation.slice(1, -1).replace(/\\(.)/g, (_, character) => (character === 'n' ? '\n' : character));

/** Values of the strings after `before` in a text, as the page or USD itself has quoted them. */
export function stringsIn(text, before = '') {
  const found = text.matchAll(new RegExp(`${before}("(?:[^"\\\\]|\\\\.)*"|'(?:[^'\\\\]|\\\\.)*')`, 'g'));
  return [...found].map(([, quotation]) => unquoted(quotation));
}

/** Values of the strings of a name in a layer. */
export const stringsNamed = (name, text) => stringsIn(text, `string ${name} = `);

/** What the text of an attribute says: the [time, value] of its samples or knots, tuples and arrays as arrays; and the number for all times, if any. */
export function valuesIn(text) {
  const value = (words) => parsed(words.replaceAll('(', '[').replaceAll(')', ']'));
  const samples = [...text.matchAll(/^ +([-+.\de]+): (.*?)(?:;.*)?,$/gm)].map(([, time, words]) => [Number(time), value(words)]);
  return { samples, one: value(/^[^\n=]* = ([-+.\de]+)/.exec(text)?.[1] ?? '') };
}

export const number = (value) => String(rounded(value) + 0);
export const tuple = (values) => `(${[...values].map(number).join(', ')})`;
