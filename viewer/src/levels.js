// Two levels of a layout: coarse elements first, and in place of an opened one its members; mirrors
// usdrigui/visible.py.  Opening an element opens the one on the other side with it.

import { known } from './vectors.js';

export class Levels {
  constructor(elements) {
    this.named = new Map(elements.map((element) => [element.name, element]));
    this.holders = new Map();
    for (const coarse of elements) {
      for (const name of coarse.inner) known(this.holders, name, () => []).push(coarse.name);
    }
    this.opened = new Set();
  }

  /** The coarse elements that an element is or belongs to. */
  coarseOf(element) {
    if (element.inner.length) return [element];
    return (this.holders.get(element.name) ?? []).map((name) => this.named.get(name));
  }

  shows(element) {
    if (this.opened.has(element.name)) return false;
    const holders = this.holders.get(element.name);
    return !holders || holders.some((name) => this.opened.has(name));
  }

  toggle(elements, open) {
    for (const element of elements) {
      for (const name of [element.name, element.mirror]) {
        if (!this.named.get(name)?.inner.length) continue;
        this.opened[open ? 'add' : 'delete'](name);
      }
    }
  }
}
