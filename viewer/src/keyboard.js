// Keys: shortcuts for the whole page, and every element reachable by Tab and moved by the arrow keys.

import { make, setAll } from './dom.js';
import { axisToward, movedAlong } from './drag.js';
import { sideName } from './view.js';

const STEP = 0.02;
const ARROWS = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }; // y down, as on the screen
const REST = 300; // milliseconds without a change, after which all that is spoken is brought up to date

/** Invisible stops, one per element, that Tab visits inside the viewport. */
export class Stops {
  constructor(session, view) {
    this.session = session;
    this.view = view;
    this.nodes = session.elements.list.map((element) => this.makeStop(element));
    view.node.append(make('div', { class: 'stops', role: 'group', 'aria-label': 'Elements on the face' }, ...this.nodes));
    session.on('pose', () => this.speakSoon());
    session.on('options', () => this.leaveOut());
    this.leaveOut();
    this.speak();
  }

  makeStop(element) {
    const { session } = this;
    const side = sideName(element.side);
    return make('div', {
      role: 'slider',
      tabIndex: 0,
      'aria-label': side ? `${element.label}, ${side}` : element.label,
      'data-element': element.name,
      onfocus: () => {
        session.select([element]);
        session.setHover(element);
      },
      onblur: () => session.setHover(null),
      onkeydown: (event) => this.key(event, element),
    });
  }

  /** Only what is shown can be visited. */
  leaveOut() {
    this.nodes.forEach((node, index) => (node.hidden = !this.session.isShown(this.session.elements.list[index])));
  }

  /** Keep what a screen reader says up to date: of the focused element at once, of the others when the pose rests. */
  speakSoon() {
    const index = this.nodes.indexOf(document.activeElement);
    if (index >= 0) this.speak([index]);
    clearTimeout(this.resting);
    this.resting = setTimeout(() => this.speak(), REST);
  }

  speak(spoken = this.nodes.keys()) {
    for (const each of spoken) {
      const element = this.session.elements.list[each];
      const [first] = element.members;
      const { minimum, maximum } = this.session.controls[first.control];
      const words = element.members.map(({ control }) => `${this.session.controls[control].label} ${this.session.worded(control)}`);
      setAll(this.nodes[each], {
        'aria-valuemin': minimum,
        'aria-valuemax': maximum,
        'aria-valuenow': this.session.values[first.control],
        'aria-valuetext': words.join(', '),
      });
    }
  }

  key(event, element) {
    const factor = event.shiftKey ? 5 : event.ctrlKey || event.metaKey ? 0.1 : 1;
    if (ARROWS[event.key]) {
      const [axis, sign] = this.along(element, ARROWS[event.key]);
      this.nudge(element, axis, sign * STEP * factor);
    } else if (event.key === 'Home' || event.key === 'End') this.nudge(element, 0, event.key === 'Home' ? -Infinity : Infinity);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** [axis, sign] of an arrow: up and right are more of a slider; what goes several ways goes that of the arrow. */
  along(element, [x, y]) {
    if (element.axes.length === 1) return [0, x - y];
    return axisToward(this.view.beginDrag(element), [x, y]);
  }

  /** Move along one axis by a share of its range. */
  nudge(element, axis, share) {
    const { session } = this;
    const changes = movedAlong(element, axis, share, session.controls, session.rest, session.values);
    session.edit(`Nudge ${element.label}`, () => session.set(changes), `nudge ${element.index}`);
  }
}

const FIELDS = 'input[type=text], input[type=number], input[type=search], textarea';

/** Give the keys back to the page where words or numbers are being typed; whether they were. */
export function leaveField() {
  const field = document.activeElement;
  if (!(field instanceof HTMLElement) || !field.matches(FIELDS)) return false;
  field.blur();
  return true;
}

const TAP = 250; // milliseconds: a key held longer than this is over when it is let go

/**
 * Shortcuts of the page; `actions` maps names of keys to functions, `held` to functions of whether the key is down.
 * A key in both acts when it was but tapped.  `isLocked` says of a name that it does nothing now.
 */
export function listenToKeys(actions, held = {}, isLocked = (name) => name === '') {
  const down = new Map();
  const free = (event) => !(/** @type {Element} */ (event.target).matches(FIELDS));
  document.addEventListener('keydown', (event) => {
    const target = /** @type {Element} */ (event.target);
    const name = [event.ctrlKey || event.metaKey ? 'Ctrl+' : '', event.shiftKey ? 'Shift+' : '', event.key.length === 1 ? event.key.toLowerCase() : event.key].join('');
    if ((!free(event) && name !== 'Escape') || isLocked(name)) return;
    if (held[name]) {
      if (!event.repeat && !down.has(name)) down.set(name, performance.now());
      if (!event.repeat) held[name](true);
      event.preventDefault();
      return;
    }
    const action = actions[name];
    if (!action) return;
    if (target.matches('button, summary, a') && (name === ' ' || name === 'Enter')) return;
    if (action() !== false) event.preventDefault();
  });
  const release = (name) => {
    const since = down.get(name);
    if (since === undefined) return;
    down.delete(name);
    held[name](false);
    if (performance.now() - since < TAP) actions[name]?.();
  };
  document.addEventListener('keyup', (event) => release(event.key.toLowerCase()));
  window.addEventListener('blur', () => [...down.keys()].forEach(release));
}
