// What of a character is shown and chosen: options, the section and level that are looked at, what is selected, hidden and
// pointed at.  Listeners hear of changes.

import { Deformer } from './deform.js';
import { download } from './dom.js';
import { Elements } from './elements.js';
import { Levels } from './levels.js';
import { known } from './vectors.js';

const DEFAULT_OPTIONS = {
  arrangement: 'face', // 'face': controls on the face; 'beside': on a copy of it, the clean face next to it
  handles: true,
  labels: 'hover', // or 'all'
  opacity: 0.9,
  fade: true,
  occlusion: 'ghost', // 'overlay' draws all, 'ghost' hidden ones faintly, 'hide' not at all
  follow: true,
  heat: true,
  symmetric: false,
  rearrange: false,
  autoKey: false,
  draw: false, // strokes of a review over the view
  onion: false,
  trails: false, // of the selected handles
  shot: false, // through its camera, until somebody looks elsewhere
  interpolation: 'linear', // of the first key of a control
  locality: 0.1,
  skinDrag: true,
};

export class Display {
  /** @type {any} */ section;
  /** @type {Set<string>} */ within; // names of its elements

  constructor(character) {
    this.character = character;
    this.controls = character.controls;
    this.deformer = new Deformer(character);
    this.elements = new Elements(character, this.deformer);
    this.levels = new Levels(this.elements.list);
    this.colours = character.layout.colours; // by side
    this.options = { ...DEFAULT_OPTIONS };
    this.selection = new Set();
    this.hidden = new Set();
    this.hover = null;
    this.quiet = false; // influence stays away after a release, until something else is pointed at
    this.listeners = new Map();
  }

  on(event, listener) {
    known(this.listeners, event, () => new Set()).add(listener);
  }

  /** A name for a file of this character. */
  fileNamed(what) {
    return `${this.character.root.split('/').at(-1) || 'character'}.${what}`;
  }

  /** Download a text as a file of this character; `say` hears of the controls that it could not hold. */
  save(what, { text, unwritten = [] }, say = (words) => words) {
    if (text) download(this.fileNamed(what), text);
    this.emit('saved');
    if (unwritten.length) say(`No animation drives ${unwritten.join(', ')}`);
  }

  /** Let a node renew itself, now and as the options change. */
  updating(node) {
    for (const event of ['options', 'layout']) this.on(event, () => node.update());
    node.update();
    return node;
  }

  emit(event) {
    this.listeners.get(event)?.forEach((listener) => listener());
  }

  // --- selection -------------------------------------------------------------------------------------

  select(elements, mode = 'replace') {
    if (mode === 'replace') this.selection.clear();
    for (const element of elements) {
      if (mode === 'toggle' && this.selection.has(element.index)) this.selection.delete(element.index);
      else this.selection.add(element.index);
    }
    this.emit('selection');
  }

  get selectedElements() {
    return [...this.selection].map((index) => this.elements.list[index]);
  }

  /** Controls of the selected elements; all controls when nothing is selected. */
  get chosenControls() {
    const chosen = this.selectedElements.flatMap((element) => element.members.map((member) => member.control));
    return chosen.length ? chosen : [...this.controls.keys()];
  }

  setHover(element) {
    if (this.hover === element) return;
    this.hover = element;
    this.quiet = false;
    this.emit('hover');
  }

  hide(elements) {
    elements.forEach((element) => this.hidden.add(element.index));
    this.selection.clear();
    this.emit('selection');
    this.emit('options');
  }

  showAll() {
    this.hidden.clear();
    this.emit('options');
  }

  /** Look at one of the character's sections: of a character in several parts, a part or one side of it. */
  show(index) {
    this.section = this.character.layout.sections[index];
    this.within = new Set(this.section.elements);
    this.elements.width = this.section.handleWidth;
    this.selection.clear();
    this.emit('section');
  }

  /** Whether an element is shown: in the section that is, not hidden by hand, and on the level that is open. */
  isShown(element) {
    return this.within.has(element.name) && !this.hidden.has(element.index) && this.levels.shows(element);
  }

  /** Show the members of the coarse elements among `elements` in their place or, of members, the coarse ones again. */
  openOrClose(elements = this.selectedElements) {
    const coarse = elements.filter((element) => element.inner.length);
    const closing = elements.flatMap((element) => (element.inner.length ? [] : this.levels.coarseOf(element)));
    if (!coarse.length && !closing.length) return false;
    this.levels.toggle(coarse, true);
    this.levels.toggle(coarse.length ? [] : closing, false);
    this.select(this.elements.list.filter((each) => this.isShown(each) && this.replaced(each, coarse, closing)));
    this.emit('options');
    return true;
  }

  /** Select an element, and open a coarse one that it is a member of. */
  reveal(element, mode) {
    const section = this.character.layout.sections.findIndex(({ elements }) => elements.includes(element.name));
    if (section >= 0 && !this.within.has(element.name)) this.show(section); // layers of other programs have elements of no part
    if (!this.levels.shows(element)) {
      this.levels.toggle(this.levels.coarseOf(element).slice(0, 1), !element.inner.length);
      this.emit('options');
    }
    this.select([element], mode);
  }

  /** Whether an element has come in place of what was opened, or closed. */
  replaced(element, coarse, closing) {
    return coarse.length ? coarse.some(({ inner }) => inner.includes(element.name)) : closing.includes(element);
  }
}
