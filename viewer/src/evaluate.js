// The evaluation of the paper's section 5: match target poses with the slider list, the controls on the
// face and the controls beside it; time and errors as CSV.

import { download, make } from './dom.js';
import { History } from './history.js';

export const INTERFACES = {
  list: 'Slider list',
  face: 'Controls on the face',
  beside: 'Controls on a copy beside the face',
};

/** The six orders of three interfaces; participant n takes the n-th, so twelve people meet each twice. */
export const ORDERS = [
  ['list', 'face', 'beside'],
  ['face', 'beside', 'list'],
  ['beside', 'list', 'face'],
  ['list', 'beside', 'face'],
  ['face', 'list', 'beside'],
  ['beside', 'face', 'list'],
];

const SIMPLE = [1, 2]; // controls in the two simple faces of a block
const COMPLEX = [6, 8]; // and in the two complex ones that only this block has
const COMMON = 13; // controls in the face that every block repeats

/**
 * The trials of one participant, as in section 5.1: per interface two simple and three complex faces, one
 * of which is the same for all; the same faces in the same sequence for everybody.
 */
export function trialsFor(participant, session) {
  const order = ORDERS[(participant - 1) % ORDERS.length];
  const random = sequence(20230806);
  const common = randomPose(session, COMMON, random);
  const own = order.map(() => [...SIMPLE, ...COMPLEX].map((count) => randomPose(session, count, random)));
  return order.flatMap((name, block) => [
    ...own[block].map((target, i) => ({ block: block + 1, name, face: `${block + 1}${'abcd'[i]}`, target })),
    { block: block + 1, name, face: 'common', target: common },
  ]);
}

/** Values with `count` laid-out controls away from rest; opposed controls are never used together. */
function randomPose(session, count, random) {
  const values = Float64Array.from(session.rest);
  const elements = session.elements.list.filter((element) => !element.onBoard);
  const pool = [...(elements.length >= count ? elements : session.elements.list)];
  for (let i = 0; i < count && pool.length; i++) {
    const [element] = pool.splice(Math.floor(random() * pool.length), 1);
    const { control } = element.members[Math.floor(random() * element.members.length)];
    const { minimum, maximum } = session.controls[control];
    const end = maximum > session.rest[control] ? maximum : minimum;
    values[control] += (0.4 + 0.6 * random()) * (end - session.rest[control]);
  }
  return values;
}

/** Numbers in [0, 1) by the 32-bit generator mulberry32, the same in every browser. */
function sequence(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Relative squared error (section 5.2): sum |u - t|^2 / sum |n - t|^2 over control values or points. */
export function relativeError(set, target, neutral) {
  let off = 0;
  let whole = 0;
  for (let i = 0; i < target.length; i++) {
    off += (set[i] - target[i]) ** 2;
    whole += (neutral[i] - target[i]) ** 2;
  }
  return whole > 0 ? off / whole : 0;
}

const COLUMNS = [
  'participant', 'block', 'interface', 'trial', 'face', 'target_controls', 'seconds', 'share_of_time', 'edits',
  'weight_error_squared', 'vertex_error_squared',
];

/** The results as CSV text; the share of time is of the participant's total, as in the paper's figure 15. */
export function toCsv(participant, results) {
  const total = results.reduce((sum, { seconds }) => sum + seconds, 0);
  const rows = results.map((each, i) => [
    participant, each.block, each.name, i + 1, each.face, each.controls, each.seconds.toFixed(2),
    (total ? each.seconds / total : 0).toFixed(5), each.edits, each.weightError.toFixed(6), each.vertexError.toFixed(6),
  ]);
  return `${[COLUMNS, ...rows].map((row) => row.join(',')).join('\n')}\n`;
}

export class Evaluation {
  constructor(app) {
    this.app = app;
    this.running = null;
    this.panel = make('div', { class: 'evaluation', hidden: true, role: 'dialog', 'aria-label': 'Evaluation' });
    app.session.on('edited', () => this.running && this.running.edits++);
  }

  open() {
    const number = make('input', { type: 'number', min: 1, value: 1, 'aria-label': 'Participant number' });
    const order = make('p', { class: 'hint' });
    const describe = () => {
      const names = ORDERS[(Math.max(1, Number(number.value)) - 1) % ORDERS.length].map((name) => INTERFACES[name]);
      order.textContent = `Order: ${names.join(' → ')}`;
    };
    number.addEventListener('input', describe);
    describe();
    this.show(
      make('h2', {}, 'Match the target face'),
      make('p', {}, 'Fifteen faces, five with each of three interfaces. Change the right-hand face until it looks like the target, then press Done. Pulling the skin is off, so that the interfaces can be compared.'),
      make('label', { class: 'field' }, make('span', {}, 'Participant'), number),
      order,
      make(
        'div',
        { class: 'actions' },
        make('button', { type: 'button', class: 'primary', onclick: () => this.start(Math.max(1, Number(number.value) || 1)) }, 'Start'),
        make('button', { type: 'button', onclick: () => this.close() }, 'Cancel'),
      ),
    );
  }

  show(...children) {
    this.panel.replaceChildren(...children);
    this.panel.classList.remove('strip');
    this.panel.hidden = false;
  }

  start(participant) {
    const { session } = this.app;
    session.trial = true;
    this.before = { work: session.snapshot(), history: session.history, options: { ...session.options } };
    this.participant = participant;
    this.trials = trialsFor(participant, session);
    this.results = [];
    this.next();
  }

  next() {
    const trial = this.trials[this.results.length];
    if (!trial) {
      this.finish();
      return;
    }
    const { session } = this.app;
    session.history = new History();
    session.select([]);
    session.clear();
    this.neutral = Float32Array.from(session.deformer.points);
    this.targetPoints = Float32Array.from(session.deformer.pose(trial.target));
    session.reshape();
    this.app.arrangeForTrial(trial.name, this.targetPoints);
    this.running = { ...trial, began: performance.now(), edits: 0 };
    const progress = `${this.results.length + 1} of ${this.trials.length}`;
    this.show(
      make('span', { class: 'strip-title' }, INTERFACES[trial.name]),
      make('span', { class: 'hint' }, progress),
      make('button', { type: 'button', class: 'primary', onclick: () => this.done() }, 'Done'),
      make('button', { type: 'button', onclick: () => this.finish() }, 'Stop'),
    );
    this.panel.classList.add('strip');
  }

  done() {
    const { session } = this.app;
    const { target, began, ...rest } = this.running;
    this.results.push({
      ...rest,
      seconds: (performance.now() - began) / 1000,
      controls: [...target.keys()].filter((i) => target[i] !== session.rest[i]).length,
      weightError: relativeError(session.values, target, session.rest),
      vertexError: relativeError(session.deformer.points, this.targetPoints, this.neutral),
    });
    this.next();
  }

  finish() {
    this.running = null;
    this.app.endTrials(this.before);
    if (!this.results.length) {
      this.close();
      return;
    }
    const csv = toCsv(this.participant, this.results);
    this.show(
      make('h2', {}, 'Thank you'),
      this.summary(),
      make(
        'div',
        { class: 'actions' },
        make('button', { type: 'button', class: 'primary', onclick: () => download(`evaluation-${this.participant}.csv`, csv, 'text/csv') }, 'Save CSV'),
        make('button', { type: 'button', onclick: () => this.close() }, 'Close'),
      ),
    );
  }

  /** Time and mean errors per interface. */
  summary() {
    const total = this.results.reduce((sum, { seconds }) => sum + seconds, 0);
    const rows = Object.entries(INTERFACES).map(([name, label]) => {
      const own = this.results.filter((each) => each.name === name);
      const mean = (key) => (own.length ? (own.reduce((sum, each) => sum + each[key], 0) / own.length).toFixed(3) : '–');
      const seconds = own.reduce((sum, each) => sum + each.seconds, 0);
      const cells = [label, `${seconds.toFixed(0)} s`, `${Math.round((100 * seconds) / total)} %`, mean('weightError'), mean('vertexError')];
      return make('tr', {}, ...cells.map((cell) => make('td', {}, cell)));
    });
    const heads = ['', 'Time', 'Share', 'Weight error', 'Vertex error'].map((head) => make('th', {}, head));
    return make('table', {}, make('tr', {}, ...heads), ...rows);
  }

  close() {
    this.panel.hidden = true;
  }
}
