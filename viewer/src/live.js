// The live link: what is animated on the page is kept in one USD layer, by the server that the page comes from.
// The layer's revision is told with every write, so that pages and programs that share it see each other's changes
// before they replace it; changes of both sides are merged per control and frame (merging.js).

import { animationLayerOf, saidKeys, worksOf } from './animation_layer.js';
import { button, make } from './dom.js';
import { NOTHING, differing, merged } from './merging.js';
import { keysFrom, sayKeys } from './by_name.js';
import { sameContent } from './usda.js';

const EVERY = 300; // milliseconds between writes, at least
const LOOKS = 3; // a look at the file, or another try after a refusal, comes after so many turns

const WORDS = {
  open: 'reading',
  saved: 'saved',
  unsaved: 'saving',
  lost: 'link lost: save before you close',
  foreign: 'changed by another program, not replaced',
};

const TITLES = {
  saved: 'Every change is in this layer',
  lost: 'The command that serves this page has ended; the browser keeps your work, and Save animation layer downloads it',
  foreign: 'It holds more than the keys shown here, which a write would lose',
};

export class Live {
  /** `sessions` are those of all characters; `address` is where the layer called `name` is read and written. */
  constructor(sessions, name, say, address = 'edit') {
    this.sessions = sessions;
    this.name = name;
    this.say = say;
    this.address = address;
    this.base = new Map(); // session -> work, as the file was when both sides last agreed
    this.revision = '';
    this.changed = false;
    this.waited = 0;
    this.state = 'open';
    this.refusal = '';
  }

  /** What the bar shows of the link. */
  makeNode() {
    this.words = make('output', { class: 'link', role: 'status' });
    this.button = button('Replace', 'Write the keys of this page over it', () => this.replace(), { hidden: true });
    this.tell(this.state);
    return make('div', { class: 'group live' }, this.words, this.button);
  }

  /** Hear of a session's changes, as long as it is shown. */
  follow(session) {
    for (const event of ['changed', 'time']) session.on(event, () => (this.changed = true));
  }

  /** Read the file, then write and look again and again. */
  async run() {
    await this.turn();
    setTimeout(() => this.run(), EVERY);
  }

  /** One write or look, as is due; none amid a drag. */
  async turn() {
    if (this.isBusy) return;
    try {
      const isDue = this.waited++ % LOOKS === 0;
      if (this.changed && this.revision && this.state !== 'foreign' && (isDue || !this.refusal)) await this.push();
      else if (isDue) await this.pull();
    } catch (error) {
      if (!(error instanceof TypeError)) throw error; // what fetch throws without a server
      this.tell('lost');
    }
  }

  get isBusy() {
    return this.sessions.some(({ dragging, trial }) => dragging || trial);
  }

  /** Whether all that a session's keys and constant values say is in the file. */
  holds(session) {
    return this.state === 'saved' && this.agrees(session);
  }

  /** Whether a session says what the file did when both last agreed. */
  agrees(session, work = saidKeys(session)) {
    return !differing(this.baseOf(session), work).length;
  }

  // --- writing ---------------------------------------------------------------------------------------

  async push() {
    this.changed = false;
    const works = new Map(this.sessions.map((session) => [session, saidKeys(session)]));
    if (this.sessions.every((session) => this.agrees(session, works.get(session)))) {
      this.tell('saved');
      return;
    }
    if (!this.refusal) this.tell('unsaved');
    const answer = await this.ask('PUT', { 'If-Match': this.revision }, animationLayerOf(this.sessions, (session) => works.get(session)));
    if (answer.status === 412) {
      this.changed = true;
      await this.pull();
    } else if (answer.ok) {
      this.revision = answer.headers.get('ETag') ?? '';
      this.base = works;
      this.tell(this.changed ? 'unsaved' : 'saved');
    } else {
      this.changed = true;
      await this.refuse(answer);
    }
  }

  /** Say what hinders the server, once. */
  async refuse(answer) {
    const why = answer.status === 404 ? WORDS.lost : (await answer.text()).trim();
    if (why !== this.refusal) this.say(`${this.name}: ${why}`);
    this.tell('refused', why);
  }

  /** Write over what another program has made of the file. */
  replace() {
    this.base.clear();
    this.changed = true;
    this.tell('unsaved');
  }

  // --- reading ---------------------------------------------------------------------------------------

  async pull() {
    const answer = await this.ask('GET', { 'If-None-Match': this.revision });
    if (answer.status === 304) {
      // Also after a refusal: the file can be read again, and is as it was.
      if (this.state !== 'foreign') this.tell(this.changed ? 'unsaved' : 'saved');
    } else if (answer.ok) {
      const text = await answer.text();
      if (this.isBusy) return; // a drag has begun meanwhile: it is read after it
      const isFirst = !this.revision;
      this.revision = answer.headers.get('ETag') ?? '';
      this.take(text, isFirst);
    } else await this.refuse(answer);
  }

  /** Take up what the file holds now. */
  take(text, isFirst) {
    if (!text) {
      if (!isFirst) this.say(`${this.name} is gone: the next change writes it anew`);
      this.base.clear();
      this.tell('saved');
      return;
    }
    const works = readable(text);
    const workOf = ({ character }) => works.find(({ root }) => root === character.root) ?? NOTHING;
    const read = new Map(this.sessions.map((session) => [session, sayKeys(session, keysFrom(workOf(session), session))]));
    // A page may be opened on another clip or layout than the file was written on; while it is open, all is written alike.
    const isWhole = isFirst
      ? works.length && works.every(({ root }) => this.sessions.some(({ character }) => character.root === root)) &&
        this.sessions.every((session) => !differing(workOf(session), read.get(session)).length)
      : sameContent(text, animationLayerOf(this.sessions, (session) => read.get(session)));
    if (works.length) this.sessions.forEach((session) => this.merge(session, read.get(session), isFirst));
    this.tell(isWhole ? (this.changed ? 'unsaved' : 'saved') : 'foreign');
  }

  merge(session, theirs, isFirst) {
    const base = this.baseOf(session);
    const { conflicts, taken } = merged(base, saidKeys(session), theirs);
    if (taken.length) {
      session.rebase((state) => keysFrom(merged(base, sayKeys(session, state), theirs).work, session));
      if (!isFirst) this.say(`${this.name} changed elsewhere: ${few(taken.map((name) => labelOf(session, name)))}`);
    }
    this.base.set(session, theirs);
    this.changed ||= !this.agrees(session);
    if (conflicts.length) this.say(`Changed here and elsewhere, as here now: ${few(conflicts.map((each) => worded(session, each)))}`);
  }

  baseOf(session) {
    return this.base.get(session) ?? NOTHING;
  }

  // --- the server ------------------------------------------------------------------------------------

  ask(method, headers, body) {
    return fetch(this.address, { method, headers, body, cache: 'no-store', credentials: 'omit', redirect: 'error' });
  }

  tell(state, refusal = '') {
    Object.assign(this, { state, refusal });
    if (!this.words) return;
    this.words.textContent = `${this.name}: ${refusal || WORDS[state]}`;
    this.words.title = TITLES[state] ?? '';
    this.words.classList.toggle('wrong', !['open', 'saved', 'unsaved'].includes(state));
    this.button.hidden = state !== 'foreign';
  }
}

/** The works that a layer holds; none of one that the viewer did not write. */
function readable(text) {
  try {
    return worksOf(text);
  } catch {
    return [];
  }
}

const few = (names) => (names.length > 4 ? `${names.slice(0, 3).join(', ')} and ${names.length - 3} more` : names.join(', '));
const labelOf = ({ controls }, name) => controls.find((control) => control.name === name)?.label ?? name;
const worded = (session, [name, frame]) => `${labelOf(session, name)}${frame === null ? '' : ` at frame ${frame}`}`;
