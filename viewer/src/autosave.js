// Keeps the work on a character in the browser's own storage, and offers back what an earlier page has left there.
// Each page writes to a slot of its own, so that two pages on one character lose nothing of each other.

import { parsed } from './by_name.js';
import { worded, workOf } from './work.js';

const DELAY = 300; // milliseconds after a change

export class Autosave {
  /** `storage` null: the browser keeps nothing for this page; `isElsewhere` tells whether all work is kept elsewhere. */
  constructor(session, storage, isElsewhere = () => false) {
    this.isElsewhere = isElsewhere;
    this.session = session;
    this.storage = storage;
    this.prefix = `usdrigui ${session.character.identity} `;
    this.slot = `${this.prefix}${Date.now().toString(36)}${Math.random().toString(36).slice(2, 8)}`;
    this.stored = null; // the work that the browser holds, as text
    this.filed = null; // and that of the last saved file, which holds no notes: a review does
  }

  /** Follow the session; `onfail` hears once when something cannot be stored. */
  listen(onfail) {
    this.onfail = onfail;
    for (const event of ['changed', 'time', 'options']) this.session.on(event, () => this.schedule());
    this.session.on('saved', () => (this.filed = withoutNotes(this.session)));
  }

  schedule() {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.flush(), DELAY);
  }

  /** Store the work now; during a trial of the evaluation there is none. */
  flush() {
    clearTimeout(this.timer);
    if (!this.storage || this.session.trial) return;
    const work = this.isElsewhere() ? null : workOf(this.session);
    const text = JSON.stringify(work);
    try {
      if (work) this.storage.setItem(this.slot, JSON.stringify({ saved: Date.now(), work }));
      else this.storage.removeItem(this.slot);
      this.stored = text;
    } catch {
      if (!this.failed) this.onfail?.();
      this.failed = true;
    }
  }

  /** Whether work would be lost with the page: neither stored here nor saved to a file as it is. */
  get isUnsaved() {
    const { session } = this;
    if (this.isElsewhere() || JSON.stringify(workOf(session)) === this.stored) return false;
    const rest = withoutNotes(session);
    return (rest !== 'null' && rest !== this.filed) || (session.notes !== session.arrived && session.notes !== session.sent);
  }

  /** The newest work that another page has left: {slot, saved, work, words}; null without any. */
  get offered() {
    if (!this.storage) return null;
    const slots = Object.keys(this.storage).filter((slot) => slot.startsWith(this.prefix) && slot !== this.slot);
    const found = slots.map((slot) => ({ slot, ...parsed(this.storage.getItem(slot)) })).filter(({ work }) => work);
    const newest = found.sort((a, b) => b.saved - a.saved)[0];
    return newest ? { ...newest, words: worded(newest.work) } : null;
  }

  /** Store nothing more, and nothing of what was. */
  forget() {
    clearTimeout(this.timer);
    this.storage?.removeItem(this.slot);
  }

  discard({ slot }) {
    this.storage.removeItem(slot);
  }
}

/** The browser's storage, or null where it gives none: private windows, files in some browsers, settings. */
export function browserStorage() {
  try {
    const { localStorage } = window;
    localStorage.setItem('usdrigui', '');
    localStorage.removeItem('usdrigui');
    return localStorage;
  } catch {
    return null;
  }
}

/** All work but the notes, as text. */
const withoutNotes = (session) => JSON.stringify(workOf(Object.create(session, { notes: { value: session.arrived } })));
