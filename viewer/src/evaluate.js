// The evaluation of the paper's section 5: match target poses with the slider list, the controls on the
// face and the controls beside it, then answer questions; time, errors and answers as CSV (`usdrigui study` sums them).

import { actions, button, download, field, hint, make } from './dom.js';
import { Hand } from './hand.js';
import { parsed } from './by_name.js';
import { posesOf } from './pose_library.js';
import { History } from './history.js';

const LEVELS = ['amateur', 'professional'];
const INTERFACES = {
  list: 'Slider list',
  face: 'Controls on the face',
  beside: 'Controls on a copy beside the face',
};

/** The six orders of three interfaces; participant n takes the n-th, so twelve people meet each twice. */
const ORDERS = [
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
const FACES = SIMPLE.length + COMPLEX.length + 1; // of a block
const NEEDED = 3 * (FACES - 1) + 1; // faces that differ
const LEAST = 0.02; // of its range: a clip that moves a control by less leaves it at rest
const UNLIKE = 0.1; // of a control's range between poses of the clip
const PRACTICE = 2; // controls in the face before each block, which is not counted

/** What is asked at the end, after the paper's figure 14: one answer from 1 to 5 each. */
export const QUESTIONS = {
  overall_list: ['Working with the slider list', 'poor', 'good'],
  overall_face: ['Working with the controls on the face', 'poor', 'good'],
  overall_beside: ['Working with the controls on a copy beside the face', 'poor', 'good'],
  easy: ['On the face: I could make the expressions without effort', 'no', 'yes'],
  unexpected: ['On the face: a control did something else than I thought', 'never', 'often'],
  cluttered: ['On the face: there was too much in one place', 'no', 'yes'],
  placed: ['On the face: a control stood where it acts', 'no', 'yes'],
  direct: ['On the face: it felt like moving the face itself', 'no', 'yes'],
};

/**
 * The trials of one participant, as in section 5.1: per interface two simple and three complex faces, one
 * of which is the same for all; the same faces in the same sequence for everybody.
 */
export function trialsFor(participant, session, poses = null) {
  const order = orderOf(participant);
  const random = sequence(20230806);
  const [common, own] = poses ? dealt(poses, session) : [
    randomPose(session, COMMON, random),
    order.map(() => [...SIMPLE, ...COMPLEX].map((count) => randomPose(session, count, random))),
  ];
  return order.flatMap((name, block) => [
    ...own[block].map((target, i) => ({ block: block + 1, name, face: `${block + 1}${'abcd'[i]}`, target })),
    { block: block + 1, name, face: 'common', target: common },
  ]);
}

const orderOf = (participant) => ORDERS[(participant - 1) % ORDERS.length];

/**
 * The common face and those of the blocks from an artist's poses (control -> value): the pose of most controls is the
 * common one; of the others every block has two of few controls and two of many.
 */
export function dealt(poses, session) {
  const faces = facesOf(poses, session);
  const blocks = ORDERS[0].map((_, block) => [0, 1, 2, 3].map((k) => faces[block + 3 * k]));
  return [faces[faces.length - 1], blocks];
}

/** The values of the poses that move a control of this character, those of few controls first. */
function facesOf(poses, session) {
  const asValues = (pose) => Float64Array.from(session.rest, (value, i) => pose.get(i) ?? value);
  const moved = (values) => values.reduce((count, value, i) => count + (value !== session.rest[i] ? 1 : 0), 0);
  const values = poses.map(asValues).map((each, i) => ({ each, i, count: moved(each) }));
  return values.filter(({ count }) => count).sort((a, b) => a.count - b.count || a.i - b.i).map(({ each }) => each);
}

/** Why poses are too few to be dealt, for people; '' where they are not. */
export function lackOf(poses, session) {
  const { length } = facesOf(poses, session);
  return length < NEEDED ? `${length} of the poses given move a control of this character; the evaluation needs ${NEEDED}.` : '';
}

/**
 * As many poses (control -> value) of the clip as are needed, in the order of their frames, each as unlike the others and rest as any frame
 * is; fewer where frames repeat.
 */
export function posesOfClip({ animation, controls, rest }) {
  const apart = (one, other) => controls.map(({ minimum, maximum }, i) => Math.abs(one[i] - other[i]) / (maximum - minimum || 1));
  const poses = animation.times(new Map()).map((time) => {
    const { values } = animation.clipAt(time);
    return apart(values, rest).map((share, i) => (share > LEAST ? values[i] : rest[i]));
  });
  const chosen = new Set();
  let away = poses.map((pose) => Math.max(...apart(pose, rest)));
  while (chosen.size < NEEDED && Math.max(...away) > UNLIKE) {
    const next = away.indexOf(Math.max(...away));
    chosen.add(next);
    away = away.map((before, i) => Math.min(before, Math.max(...apart(poses[i], poses[next]))));
  }
  return poses.filter((_, i) => chosen.has(i)).map((pose) => new Map(pose.entries()));
}

/** The faces of a participant's session in their order: before each block one to practise on. */
export function sessionFor(participant, session, poses = null) {
  const random = sequence(20210806);
  const practice = ORDERS[0].map(() => randomPose(session, PRACTICE, random));
  return trialsFor(participant, session, poses).flatMap((trial, i) => {
    const { block, name } = trial;
    return i % FACES ? [trial] : [{ block, name, face: 'practice', target: practice[block - 1] }, trial];
  });
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

/**
 * Relative squared error (section 5.2): sum |u - t|^2 / sum |n - t|^2 over control values or points; with `ranges`, values
 * count in shares of them, so that degrees and weights weigh alike.
 */
export function relativeError(set, target, neutral, ranges = null) {
  let off = 0;
  let whole = 0;
  for (let i = 0; i < target.length; i++) {
    const unit = ranges ? ranges[i] || 1 : 1;
    off += ((set[i] - target[i]) / unit) ** 2;
    whole += ((neutral[i] - target[i]) / unit) ** 2;
  }
  return whole > 0 ? off / whole : 0;
}

const COLUMNS = [
  'participant', 'block', 'interface', 'trial', 'face', 'target_controls', 'seconds', 'share_of_time', 'edits',
  'weight_error_squared', 'vertex_error_squared', 'question', 'answer', 'paused', 'face_pixels', 'target_pixels', 'window', 'device',
  'level', 'order', 'targets', 'character', 'layout', 'version',
];
const EVENTS = ['participant', 'trial', 'face', 'interface', 'event', 'seconds', 'control', 'x', 'y', 'pixels'];

/** The results as CSV text: a row per face, then one per answer; shares are of the participant's total, as in figure 15. */
export function toCsv(participant, results, answers = {}, setting = {}) {
  const total = secondsOf(results);
  const faces = results.map((each, i) => ({
    block: each.block, interface: each.name, trial: i + 1, face: each.face, target_controls: each.controls, seconds: each.seconds.toFixed(2),
    share_of_time: (total ? each.seconds / total : 0).toFixed(5), edits: each.edits,
    weight_error_squared: each.weightError.toFixed(6), vertex_error_squared: each.vertexError.toFixed(6), paused: (each.paused ?? 0).toFixed(2),
    face_pixels: (each.facePixels ?? 0).toFixed(1), target_pixels: (each.targetPixels ?? 0).toFixed(1), window: each.window, device: each.device,
  }));
  const answered = Object.entries(answers).map(([question, answer]) => ({ question, answer: quoted(answer) }));
  const rows = [...faces, ...answered].map((row) => ({ participant, ...setting, ...row }));
  return `${[COLUMNS, ...rows.map((row) => COLUMNS.map((name) => row[name] ?? ''))].map((cells) => cells.join(',')).join('\n')}\n`;
}

const secondsOf = (results) => results.reduce((sum, { seconds }) => sum + seconds, 0);

/** What the hand did (hand.js) in each trial as CSV text, in seconds from the beginning of the trial. */
export function eventsCsv(participant, results) {
  const rows = results.flatMap(({ face, name, events = [] }, i) => events.map(({ event, at, control, x, y, pixels }) =>
    [participant, i + 1, face, name, event, (at / 1000).toFixed(3), quoted(control), Math.round(x), Math.round(y), Math.round(pixels)].join(',')));
  return `${[EVENTS.join(','), ...rows].join('\n')}\n`;
}

const quoted = (answer) => (typeof answer === 'number' ? answer : `"${answer.replace(/"/g, '""').replace(/\s+/g, ' ')}"`);

export class Evaluation {
  constructor(app) {
    this.app = app;
    /** @type {any} */
    this.running = null;
    /** @type {any[]} */
    this.trials = [];
    /** @type {any[]} */
    this.results = [];
    this.panel = make('div', { class: 'evaluation', hidden: true, role: 'dialog', 'aria-label': 'Evaluation' });
    this.hand = new Hand(app);
    app.session.on('edited', () => this.running && this.running.edits++);
    app.session.on('dragging', () => this.running && app.session.dragging?.members && this.hand.take(app.session.dragging));
  }

  open() {
    const number = make('input', { type: 'number', min: 1, value: 1, 'aria-label': 'Participant number' });
    const order = hint();
    const describe = () => {
      const names = orderOf(Math.max(1, Number(number.value))).map((name) => INTERFACES[name]);
      order.textContent = `Order: ${names.join(' → ')}`;
    };
    number.addEventListener('input', describe);
    describe();
    const agreed = make('input', { type: 'checkbox' });
    const select = (name, choices) => make('select', { 'aria-label': name }, ...choices.map((each) => make('option', { value: each }, each || 'choose')));
    const level = select('Experience', ['', ...LEVELS]);
    const sets = this.sets();
    const chosen = select('Target faces', [...sets.keys()]);
    const first = button('Start', '', () => {
      this.setting = { level: level.value, targets: chosen.value };
      this.start(Math.max(1, Math.floor(Number(number.value)) || 1));
    }, { class: 'primary' });
    const allow = () => (first.disabled = !agreed.checked || !level.value);
    for (const input of [agreed, level]) input.addEventListener('change', allow);
    allow();
    const kept = this.kept();
    this.show(
      make('h2', {}, 'Match the target face'),
      make('p', {}, 'Fifteen faces, five with each of three interfaces, and one to practise on before each five. Change your face until it looks like the target, then press Done. Pulling the skin, shortcuts and playback are off, so that the interfaces can be compared.'),
      field('Participant', number),
      order,
      field('I animate faces as', level),
      field('Target faces', chosen),
      hint(this.lacking),
      make('label', { class: 'field' }, agreed, make('span', {}, 'I agree that my times, errors, answers and what my pointer does are saved under this number, without my name, and may be published. I can stop at any time.')),
      actions(
        first,
        kept && button(`Go on with participant ${kept.participant}`, `${kept.results.length} of 15 faces are done`, () => {
          this.setting = kept.setting;
          this.start(kept.participant, kept.results);
        }),
        button('Cancel', '', () => this.close()),
      ),
    );
  }

  /** The poses (control -> value) that may be matched, by a name for people: null for those drawn from the controls. */
  sets() {
    const { session, targets } = this.app;
    const of = (poses) => poses.map(({ values }) => values);
    const given = of(targets.flatMap((layer) => posesOf(layer, session)));
    const sets = new Map();
    const offer = (name, poses) => lackOf(poses, session) || sets.set(name, poses);
    offer('the poses given', given);
    offer('the shelf', of(session.shelf));
    sets.set('drawn from the controls', null);
    offer('the clip', posesOfClip(session));
    this.lacking = targets.length ? lackOf(given, session) : '';
    return sets;
  }

  // --- what is done so far, in the browser's storage ---------------------------------------------------

  get slot() {
    return `usdrigui study ${this.app.session.character.identity}`;
  }

  kept() {
    return parsed(this.app.storage?.getItem(this.slot));
  }

  keep(results) {
    try {
      if (results) this.app.storage?.setItem(this.slot, JSON.stringify({ participant: this.participant, results, setting: this.setting }));
      else this.app.storage?.removeItem(this.slot);
    } catch {
      this.app.say('This browser has no room to keep the session: finish it without closing the page');
    }
  }

  show(...children) {
    this.panel.replaceChildren(...children);
    this.panel.classList.remove('strip');
    this.panel.hidden = false;
  }

  /** Begin a participant's session, or go on after the faces that are done: with the practice of the block begun. */
  start(participant, results = []) {
    const { session, timeline } = this.app;
    timeline.stop();
    session.trial = true;
    this.before = { work: session.snapshot(), history: session.history, options: { ...session.options } };
    this.participant = participant;
    this.results = results;
    this.setting = { ...this.setting, order: orderOf(participant).join('-'), ...this.app.identity() };
    this.trials = sessionFor(participant, session, this.sets().get(this.setting.targets)).slice(Math.floor(results.length / FACES) * (FACES + 1));
    this.trials.splice(1, results.length % FACES);
    this.next();
  }

  next() {
    const trial = this.trials.shift();
    if (!trial) {
      this.ask();
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
    this.running = { ...trial, began: performance.now(), paused: 0, edits: 0, events: [] };
    this.hand.record(this.running.events);
    const progress = trial.face === 'practice' ? 'practice, not counted' : `${this.results.length + 1} of ${ORDERS[0].length * FACES}`;
    this.show(
      make('span', { class: 'strip-title' }, INTERFACES[trial.name]),
      make('span', { class: 'hint' }, progress),
      button('Done', '', () => this.done(), { class: 'primary' }),
      button('Pause', '', (event) => this.pause(event.target)),
      button('Stop', '', () => this.finish()),
    );
    this.panel.classList.add('strip');
  }

  /** Hide the faces, and count no time until the next press. */
  pause(pressed) {
    const { running } = this;
    const now = performance.now();
    if (running.since) running.paused += now - running.since;
    running.since = running.since ? 0 : now;
    this.app.node.classList.toggle('paused', Boolean(running.since));
    pressed.textContent = running.since ? 'Go on' : 'Pause';
  }

  done() {
    const { session, view } = this.app;
    if (this.running.since) this.pause(make('i'));
    const { target, began, paused, events, ...rest } = this.running;
    this.running = null;
    if (rest.face !== 'practice') {
      this.results.push({
        ...rest,
        seconds: (performance.now() - began - paused) / 1000,
        paused: paused / 1000,
        facePixels: view.faceHeight(rest.name === 'face' ? 'controls' : 'clean'),
        targetPixels: view.faceHeight('target'),
        window: `${window.innerWidth}x${window.innerHeight}@${window.devicePixelRatio}`,
        device: this.hand.device,
        events: events.map((each) => ({ ...each, at: each.at - began })),
        controls: [...target.keys()].filter((i) => target[i] !== session.rest[i]).length,
        weightError: relativeError(session.values, target, session.rest, session.controls.map(({ minimum, maximum }) => maximum - minimum)),
        vertexError: relativeError(session.deformer.points, this.targetPoints, this.neutral),
      });
      this.keep(this.results);
    }
    this.next();
  }

  /** Leave the trials; what is done is kept to go on with. */
  finish() {
    this.leave();
    if (this.results.length) this.thank({});
    else this.close();
  }

  leave() {
    this.running = null;
    this.hand.record(null);
    this.app.node.classList.remove('paused');
    if (this.app.session.trial) this.app.endTrials(this.before);
  }

  /** The questions, after the last face. */
  ask() {
    this.leave();
    const asked = Object.entries(QUESTIONS).map(([name, [words, low, high]]) => {
      const scores = [1, 2, 3, 4, 5].map((value) =>
        make('label', {}, make('input', { type: 'radio', name, value, required: true, 'aria-label': `${words}: ${value} of 5` }), String(value)));
      return make('fieldset', { class: 'question' }, make('legend', {}, words), make('span', { class: 'hint' }, low), ...scores, make('span', { class: 'hint' }, high));
    });
    const comment = make('textarea', { 'aria-label': 'What else you would like to say', placeholder: 'What else you would like to say', rows: 2 });
    const form = make('form', { class: 'questions', onsubmit: (event) => {
      event.preventDefault();
      const answers = Object.fromEntries([...new FormData(form)].map(([name, value]) => [name, Number(value)]));
      this.thank(comment.value.trim() ? { ...answers, comment: comment.value.trim() } : answers);
    } }, ...asked, comment, actions(make('button', { type: 'submit', class: 'primary' }, 'Done')));
    this.show(make('h2', {}, 'How was it?'), form);
  }

  thank(answers) {
    const csv = toCsv(this.participant, this.results, answers, this.setting);
    const save = () => {
      download(`evaluation-${this.participant}.csv`, csv, 'text/csv');
      if (Object.keys(answers).length) this.keep(null);
    };
    this.show(
      make('h2', {}, 'Thank you'),
      this.summary(),
      actions(
        button('Save CSV', '', save, { class: 'primary' }),
        button('Save events', '', () => download(`events-${this.participant}.csv`, eventsCsv(this.participant, this.results), 'text/csv')),
        button('Close', '', () => this.close()),
      ),
    );
  }

  /** Time and mean errors per interface. */
  summary() {
    const rows = Object.entries(INTERFACES).map(([name, label]) => {
      const own = this.results.filter((each) => each.name === name);
      const mean = (key) => (own.length ? (own.reduce((sum, each) => sum + each[key], 0) / own.length).toFixed(3) : '–');
      const seconds = secondsOf(own);
      const cells = [label, `${seconds.toFixed(0)} s`, `${Math.round((100 * seconds) / secondsOf(this.results))} %`, mean('weightError'), mean('vertexError')];
      return make('tr', {}, ...cells.map((cell) => make('td', {}, cell)));
    });
    const heads = ['', 'Time', 'Share', 'Weight error', 'Vertex error'].map((head) => make('th', {}, head));
    return make('table', {}, make('tr', {}, ...heads), ...rows);
  }

  close() {
    this.panel.hidden = true;
  }
}
