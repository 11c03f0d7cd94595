// The plain list of sliders: every control by name, searchable, and the baseline of the evaluation.

import { headingOf } from './dock.js';
import { button, hint, longName, make, setAll, valueField } from './dom.js';
import { known } from './vectors.js';

const STEPS = 1000;

export class ControlList {
  constructor(session, view) {
    this.session = session;
    this.view = view;
    this.search = make('input', {
      type: 'search',
      class: 'search',
      placeholder: 'Search controls  ( / )',
      'aria-label': 'Search controls',
      oninput: () => this.filter(),
      onkeydown: (event) => event.key === 'Escape' && this.clearSearch(),
    });
    this.rows = session.controls.map((control, index) => this.makeRow(control, index));
    this.body = make('div', { class: 'rows' }, ...this.sections());
    this.empty = hint('No control has this name.');
    this.empty.hidden = true;
    this.node = make('section', { class: 'list', 'aria-label': 'Controls' }, this.search, this.body, this.empty);
    session.on('pose', () => this.updateValues());
    session.on('selection', () => this.updateMarks(true));
    session.on('hover', () => this.updateMarks(false));
    session.on('options', () => this.updateMarks(false));
    session.on('layout', () => this.body.replaceChildren(...this.sections()));
    this.shown = new Float64Array(session.controls.length).fill(NaN);
    this.updateValues();
    this.updateMarks(false);
  }

  /** Rows in the rig's order; those that stand on the board and those without an element come after. */
  sections() {
    const names = new Map();
    this.rows.forEach((row, index) => {
      const element = this.session.elements.byControl.get(index);
      const name = !element ? 'Not in the layout' : element.onBoard ? headingOf(element) : '';
      known(names, name, () => []).push(row.node);
    });
    const order = [...names].sort(([a], [b]) => rankOf(a) - rankOf(b));
    return order.flatMap(([name, nodes]) => (name ? [make('h3', {}, name), ...nodes] : nodes));
  }

  makeRow(control, index) {
    const { session, view } = this;
    const element = session.elements.byControl.get(index);
    const slider = make('input', {
      type: 'range',
      min: 0,
      max: STEPS,
      step: 1,
      'aria-label': control.label,
      oninput: () => {
        const value = control.minimum + (slider.value / STEPS) * (control.maximum - control.minimum);
        session.edit(`Set ${control.label}`, () => session.set([[index, value]]), `list ${index}`);
      },
      ondblclick: () => session.reset([index]),
    });
    const properties = { type: 'text', inputMode: 'decimal', class: 'number', 'aria-label': `${control.label}, value`, onfocus: () => number.select() };
    const number = valueField(session, index, properties, 'list');
    const lock = button('', 'Lock: neither drags nor pulls change it', () => session.toggleLock(index), { class: 'lock', 'aria-label': `Lock ${control.label}` });
    const name = button(
      longName(control.label),
      control.label === control.name ? control.name : `${control.label} (${control.name})`,
      (event) => element && session.reveal(element, event.shiftKey ? 'toggle' : 'replace'),
      { class: 'name', tabIndex: -1, 'aria-label': control.label },
    );
    const chip = make('i', { class: 'chip', style: { background: session.colours[element?.side ?? 'none'] } });
    const node = make(
      'div',
      {
        class: 'row',
        'data-control': control.name,
        onpointerenter: () => view.pointAt(index),
        onpointerleave: () => view.pointAt(null),
      },
      chip,
      name,
      slider,
      number,
      lock,
    );
    return { node, slider, number, lock, index, element };
  }

  updateValues() {
    const { session, shown } = this;
    for (const { slider, number, index, node } of this.rows) {
      const value = session.values[index];
      if (value === shown[index]) continue;
      shown[index] = value;
      const { minimum, maximum } = session.controls[index];
      const range = maximum - minimum;
      slider.value = (STEPS * (value - minimum)) / range;
      const ends = [value, session.rest[index]].map((each) => (100 * (each - minimum)) / range);
      slider.style.setProperty('--from', `${Math.min(...ends)}%`);
      slider.style.setProperty('--at', `${Math.max(...ends)}%`);
      if (document.activeElement !== number) number.value = session.worded(index);
      node.classList.toggle('moved', value !== session.rest[index]);
    }
  }

  updateMarks(reveal) {
    const { session } = this;
    let first = null;
    for (const { node, lock, element, index } of this.rows) {
      const selected = element !== undefined && session.selection.has(element.index);
      node.classList.toggle('selected', selected);
      node.classList.toggle('hovered', element !== undefined && session.hover === element);
      setAll(lock, { 'aria-pressed': session.locks.has(index) });
      if (selected) first ??= node;
    }
    if (reveal && first && !this.node.contains(document.activeElement)) first.scrollIntoView({ block: 'nearest' });
  }

  filter() {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    const matches = ({ index }) => {
      const { name, label, source } = this.session.controls[index];
      const text = `${name} ${label} ${source}`.toLowerCase();
      return words.every((word) => text.includes(word));
    };
    let found = 0;
    for (const row of this.rows) {
      row.node.hidden = !matches(row);
      found += row.node.hidden ? 0 : 1;
    }
    this.body.classList.toggle('searching', words.length > 0);
    this.empty.hidden = found > 0;
    const elements = this.rows.filter((row) => words.length && !row.node.hidden && row.element).map((row) => row.element);
    if (words.length) this.session.select(new Set(elements));
  }

  clearSearch() {
    this.search.value = '';
    this.filter();
    this.session.select([]);
  }
}

const rankOf = (name) => (name === '' ? 0 : name === 'Not in the layout' ? 2 : 1);
