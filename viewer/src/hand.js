// What a hand does in a trial, for models of its time: presses that take a handle or a slider, presses beside a handle that
// take none, releases, and how far the pointer went before.

const NEAR = 2; // widths of a handle from its middle within which a press that takes nothing has missed it

export class Hand {
  constructor(app) {
    this.app = app;
    this.device = '';
    /** @type {any} */
    this.rows = null; // of the trial that runs: {event, at (milliseconds), control, x, y, pixels}
    this.taken = null;
    this.path = 0;
    /** @type {any} */
    this.pressed = null;
    for (const kind of ['pointerdown', 'pointermove', 'pointerup']) app.node.addEventListener(kind, (event) => this.follow(event), true);
  }

  /** Begin to write down, or stop with null. */
  record(rows) {
    Object.assign(this, { rows, taken: null, pressed: null, last: null, path: 0 });
  }

  follow(event) {
    if (!this.rows) return;
    const { clientX: x, clientY: y, type } = event;
    if (this.last) this.path += Math.hypot(x - this.last[0], y - this.last[1]);
    this.last = [x, y];
    this.device = event.pointerType;
    if (type === 'pointerdown') {
      const slider = event.target.closest?.('[data-control] input[type="range"]');
      this.pressed = { at: performance.now(), x, y, pixels: this.path, slider: slider?.closest('[data-control]').dataset.control };
      this.path = 0;
    } else if (type === 'pointerup' && this.pressed) this.release(x, y);
  }

  /** Called while a handle is dragged: what the press has taken. */
  take(element) {
    this.taken ??= element.members.map(({ control }) => this.app.session.controls[control].name).join('+');
  }

  release(x, y) {
    const { slider, ...press } = this.pressed;
    const control = this.taken ?? slider ?? '';
    if (control) {
      this.rows.push({ event: 'grab', control, ...press });
      this.rows.push({ event: 'release', control, at: performance.now(), x, y, pixels: this.path });
      this.path = 0;
    } else if (this.isNearHandle(press)) this.rows.push({ event: 'miss', control, ...press });
    Object.assign(this, { pressed: null, taken: null });
  }

  isNearHandle({ x, y }) {
    const { view } = this.app;
    const { left, top } = view.node.getBoundingClientRect();
    return view.session.options.handles && view.overlay.drawn.some(({ handle, width }) => Math.hypot(handle[0] + left - x, handle[1] + top - y) < NEAR * width);
  }
}
