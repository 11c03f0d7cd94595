// The bar over the view: what is always in sight, and groups, those of most worth first, that go into a menu where they do not fit.

import { button, make, segmented, toggle } from './dom.js';

/** @type {[string, number, number][]} */
export const LOOKS = [['Front', 0, 0], ['¾', 0.7, 0.05], ['Side', Math.PI / 2, 0], ['Back', Math.PI, 0]];

export class Bar {
  /** `app`: the page, whose commands the bar offers. */
  constructor(app) {
    this.app = app;
    this.groups = [this.chooser(), this.tabs(), ...this.toggles(), this.looks(), app.live?.makeNode(), this.study()].filter(Boolean);
    this.row = make('div', { class: 'bar-row' });
    this.menu = make('details', { class: 'menu' }, make('summary', { title: 'More', 'aria-label': 'More' }, '⋯'), make('div', { class: 'menu-items' }));
    this.title = make('h1', {}, app.scene.title);
    this.node = make('header', { class: 'bar' }, this.title, this.row, this.menu, this.always());
    new ResizeObserver(() => this.fit()).observe(this.node);
  }

  /** Show each group for which those before it leave room; the others go into the menu. */
  fit() {
    const items = /** @type {HTMLElement} */ (this.menu.lastElementChild);
    this.row.replaceChildren();
    items.replaceChildren();
    this.menu.hidden = false; // its own room is taken off first
    for (const group of this.groups) {
      this.row.append(group);
      if (this.row.scrollWidth > this.row.clientWidth) items.append(group);
    }
    this.menu.hidden = !items.children.length;
  }

  act(label, title, onclick, name = label) {
    return button(label, title, onclick, { 'aria-label': name });
  }

  always() {
    const { app } = this;
    return make(
      'div',
      { class: 'group' },
      this.act('↶', 'Undo (Ctrl+Z)', () => app.undo(), 'Undo'),
      this.act('↷', 'Redo (Ctrl+Shift+Z)', () => app.redo(), 'Redo'),
      this.act('Key', 'Key the selected controls and all that changed, at this frame (K)', () => app.timeline.key()),
      this.panel('inspector', 'Panel', 'Selection, display, poses, layout (P)'),
      this.act('?', 'Gestures and keys (?)', () => app.showHelp(), 'Shortcuts'),
    );
  }

  panel(name, label, title) {
    return this.app.session.updating(toggle(label, title, () => !this.app[name].node.hidden, () => this.app.fold(name)));
  }

  chooser() {
    const { scene, index } = this.app;
    if (scene.characters.length < 2) return null;
    const options = scene.characters.map(({ root }, i) => make('option', { value: i, selected: i === index }, root));
    return make('select', { 'aria-label': 'Character', onchange: ({ target }) => this.app.open(Number(target.value)) }, ...options);
  }

  /** One tab for each section of a character in several parts. */
  tabs() {
    const { session } = this.app;
    const { sections } = session.character.layout;
    if (sections.length < 2) return null;
    const choices = sections.map((section, i) => [section, section.title, `Show: ${section.title} (${i + 1} of ${sections.length})`]);
    const tabs = segmented('Part', choices, () => session.section, (section) => session.show(sections.indexOf(section)));
    session.on('section', () => tabs.update());
    return tabs;
  }

  toggles() {
    const { app } = this;
    const { session } = app;
    const option = (name, label, title) =>
      session.updating(toggle(label, title, () => session.options[name], () => session.flipOption(name)));
    return [
      option('symmetric', 'Symmetry', 'Both sides at once (S)'),
      this.panel('list', 'List', 'All controls as sliders (C)'),
      this.panel('review', 'Review', 'Notes: words and strokes at frames, to send and to open (N)'),
      option('handles', 'Handles', 'Show or hide the handles (H)'),
      session.updating(segmented('Where the controls are', [
        ['face', 'On face', 'Controls on the face'],
        ['beside', 'On copy', 'Controls on a copy of the face, the clean face next to it'],
      ], () => session.options.arrangement, (value) => app.setArrangement(value))),
      option('rearrange', 'Rearrange', 'Drag elements to other points of the face'),
    ];
  }

  looks() {
    const look = ([label, azimuth, elevation]) => this.act(label, `View: ${label}`, () => this.app.view.home(azimuth, elevation), `View: ${label}`);
    return make('div', { class: 'group looks' }, ...LOOKS.map(look));
  }

  study() {
    if (!('study' in document.body.dataset)) return null;
    return this.act('Evaluate', 'Match target faces with three interfaces', () => this.app.evaluation.open());
  }
}
