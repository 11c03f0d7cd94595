// USD as text: prims nested by path, quoted strings, numbers; and the strings of a name out of a layer.

import { rounded } from './vectors.js';

/** Prims nested by path, those that share ancestors sharing the overs. */
export function nested(prims) {
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

export function rendered({ children }, indent = '') {
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

/** Values of the strings of a name in a layer, as the page or USD itself has quoted them. */
export function stringsNamed(name, text) {
  const found = text.matchAll(new RegExp(`string ${name} = ("(?:[^"\\\\]|\\\\.)*"|'(?:[^'\\\\]|\\\\.)*')`, 'g'));
  return [...found].map(([, quotation]) => unquoted(quotation));
}

/**
 * Whether two layers say the same, whichever program wrote them: metadata of the layer in any order, strings in any quotes,
 * numbers to the digits of their type.
 */
export function sameContent(one, other) {
  const [a, b] = [one, other].map(statements);
  let digits = 1e-6;
  return a.length === b.length && a.every((words, i) => {
    if (typeof words[0] !== 'number') digits = words[0] === 'half3' ? 1e-3 : 1e-6;
    return words.length === b[i].length && words.every((word, k) => alike(word, b[i][k], digits));
  });
}

/** The words and numbers of each line. */
function statements(text) {
  const lines = text.split('\n').map((line) => line.trim()).filter(Boolean);
  const head = lines.indexOf(')');
  return [...lines.slice(0, head).sort(), ...lines.slice(head)].map(wordsOf);
}

function wordsOf(line) {
  const words = line.match(/"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|[^\s,:()[\]"']+|\S/g) ?? [];
  return words.map((word) => (/^["']./.test(word) ? unquoted(word) : Number.isFinite(Number(word)) ? Number(word) : word));
}

const alike = (a, b, digits) => a === b || (typeof a === 'number' && Math.abs(a - b) <= digits * Math.max(1, Math.abs(a)));

export const number = (value) => String(rounded(value) + 0);
export const tuple = (values) => `(${[...values].map(number).join(', ')})`;
