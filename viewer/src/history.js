// Undo and redo as pairs of functions.

const MERGE_WITHIN = 900; // milliseconds
const MOST = 200; // changes that are kept

export class History {
  done = [];
  undone = [];

  /**
   * Record a change that has already happened.  Changes in quick succession with the same `merge` name
   * (presses of an arrow key, steps of a list's slider) become one.  `states` are those that the functions give back.
   * @param {string | null} [merge]
   */
  push(label, undo, redo, merge = null, states = []) {
    const now = performance.now();
    const last = this.done.at(-1);
    if (merge && last?.merge === merge && now - last.when < MERGE_WITHIN) Object.assign(last, { redo, when: now, states: [...last.states, ...states] });
    else this.done.push({ label, undo, redo, merge, states, when: now });
    if (this.done.length > MOST) this.done.shift();
    this.undone = [];
  }

  /** All states that undo and redo give back. */
  get states() {
    return [...this.done, ...this.undone].flatMap(({ states }) => states);
  }

  /** Label of the change taken back, or null. */
  undo() {
    const change = this.done.pop();
    if (!change) return null;
    change.undo();
    this.undone.push({ ...change, merge: null });
    return change.label;
  }

  redo() {
    const change = this.undone.pop();
    if (!change) return null;
    change.redo();
    this.done.push(change);
    return change.label;
  }
}
