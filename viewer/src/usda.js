// USD as text: prims nested by path, quoted strings, numbers; and the strings of a name out of a layer.

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

/** Values of the strings of a name in a layer, as the page or USD itself has quoted them. */
export function stringsNamed(name, text) {
  const found = text.matchAll(new RegExp(`string ${name} = ("(?:[^"\\\\]|\\\\.)*"|'(?:[^'\\\\]|\\\\.)*')`, 'g'));
  return [...found].map(([, quotation]) => quotation.slice(1, -1).replace(/\\(.)/g, (_, character) => (character === 'n' ? '\n' : character)));
}

const rounded = (value) => Number(value.toPrecision(9));
export const number = (value) => String(rounded(value) + 0);
