// The live link: what is animated on the page is kept in one USD layer, by the server that the page comes from.
// The layer's revision is told with every write, so that pages and programs that share it see each other's changes
// before they replace them; changes of both sides are merged per control and frame (merging.js).  What else programs have
// written there the server keeps.

import { animationLayerOf, saidKeys, worksIn } from './animation_layer.js';
import { button, make } from './dom.js';
import { NOTHING, differing, merged } from './merging.js';
import { keysFrom, sayKeys } from './by_name.js';
import { withChanges } from './from_programs.js';

const EVERY = 300; // milliseconds between writes, at least
const LOOKS = 3; // a look at the file, or another try after a refusal, comes after so many turns

const WORDS = {
  open: 'reading',
  saved: 'saved',
  unsaved: 'saving',
  lost: 'link lost: save before you close',
};

const TITLES = {
  saved: 'Every change is in this layer',
  lost: 'The command that serves this page has ended; the browser keeps your work, and Save animation layer downloads it',
};

export class Live {
  /** `sessions` are those of all characters; `address` is where the layer called `name` is read and written. */
  constructor(sessions, name, say, address = 'edit') {
    this.sessions = sessions;
    this.name = name;
    this.say = say;
    this.address = address;
    this.base = new Map(); // session -> work, as the file was when both sides last agreed
    this.others = []; // works in the file of what the sessions do not have
    this.asked = []; // {session, conflicts, here, there} of the changes here and elsewhere that exclude each other
    this.revision = '';
    this.changed = false;
    this.isAhead = false; // somebody has changed samples in the file that its works do not say yet
    this.waited = 0;
    this.state = 'open';
    this.refusal = '';
  }

  /** What the bar shows of the link. */
  makeNode() {
    this.words = make('output', { class: 'link', role: 'status' });
    this.button = button('Take theirs', 'What was changed here and elsewhere is as here now', () => this.takeTheirs(), { hidden: true });
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
      if (this.changed && this.revision && (isDue || !this.refusal)) await this.push();
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
    if (!this.isAhead && this.sessions.every((session) => this.agrees(session, works.get(session)))) {
      this.tell();
      return;
    }
    if (!this.refusal) this.tell('unsaved');
    const layer = animationLayerOf(this.sessions, (session) => works.get(session), this.others);
    const answer = await this.send('PUT', { 'If-Match': this.revision }, layer);
    if (answer.status === 412) {
      this.changed = true;
      await this.pull();
    } else if (answer.ok) {
      this.revision = answer.headers.get('ETag') ?? '';
      this.isAhead = false;
      this.base = works;
      this.tell();
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

  /** Answer what is asked: as elsewhere. */
  takeTheirs() {
    this.asked.splice(0).forEach(({ session, here, there }) => bring(session, here, there));
    this.changed = true;
    this.tell();
  }

  // --- reading ---------------------------------------------------------------------------------------

  async pull() {
    const answer = await this.send('GET', { 'If-None-Match': this.revision });
    if (answer.status === 304) {
      this.tell(); // also after a refusal: the file is as it was
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
    const told = JSON.parse(text);
    this.isAhead = Object.keys(told.changed).length > 0;
    this.others = worksIn(told.work);
    for (const session of this.sessions) {
      const stored = this.others.find(({ root }) => root === session.character.root) ?? NOTHING;
      const found = this.others.length ? stored : this.baseOf(session);
      this.merge(session, sayKeys(session, withChanges(session, found, told)), isFirst);
      for (const { name } of session.controls) {
        delete stored.keys[name];
        delete stored.standing[name];
      }
    }
    this.tell();
  }

  /** Take up what others have made of the last agreement; where both changed one thing it is as here, until somebody says that it is as theirs. */
  merge(session, theirs, isFirst) {
    const base = this.baseOf(session);
    const mine = saidKeys(session);
    const { work: here, conflicts, taken } = merged(base, mine, theirs);
    if (taken.length) {
      bring(session, base, theirs);
      if (!isFirst) this.say(`${this.name} changed elsewhere: ${few(taken.map((name) => labelOf(session, name)))}`);
    }
    this.base.set(session, theirs);
    this.changed ||= this.isAhead || !this.agrees(session);
    if (!conflicts.length) return;
    this.say(`Changed here and elsewhere, as here now: ${few(conflicts.map((each) => worded(session, each)))}`);
    this.asked.push({ session, conflicts, here, there: merged(base, theirs, mine).work });
  }

  baseOf(session) {
    return this.base.get(session) ?? NOTHING;
  }

  // --- the server ------------------------------------------------------------------------------------

  send(method, headers, body) {
    return fetch(this.address, { method, headers, body, cache: 'no-store', credentials: 'omit', redirect: 'error' });
  }

  tell(state = this.changed ? 'unsaved' : 'saved', refusal = '') {
    // A question is open as long as its answer would change something.
    this.asked = this.asked.filter(({ session, here, there }) => merged(here, saidKeys(session), there).taken.length);
    Object.assign(this, { state, refusal });
    if (!this.words) return;
    this.words.textContent = `${this.name}: ${refusal || WORDS[state]}`;
    this.words.title = TITLES[state] ?? '';
    this.words.classList.toggle('wrong', ['lost', 'refused'].includes(state));
    this.button.hidden = !this.asked.length;
  }
}

/** What others have made of `base` comes to a session's present state and to all that undo and redo give back. */
const bring = (session, base, theirs) => session.rebase((state) => keysFrom(merged(base, sayKeys(session, state), theirs).work, session));

const few = (names) => (names.length > 4 ? `${names.slice(0, 3).join(', ')} and ${names.length - 3} more` : names.join(', '));
const labelOf = ({ controls }, name) => controls.find((control) => control.name === name)?.label ?? name;
const worded = (session, [name, frame]) => `${labelOf(session, name)}${frame === null ? '' : ` at frame ${frame}`}`;
