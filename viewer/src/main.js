// The page: reads the scene, builds the panels around the viewport, and wires them to one session.

import './style.css';
import { Autosave, browserStorage } from './autosave.js';
import { ControlList } from './control_list.js';
import { Bar, LOOKS } from './bar.js';
import { byName } from './by_name.js';
import { button, make } from './dom.js';
import { Evaluation, trialsFor } from './evaluate.js';
import { Inspector } from './inspector.js';
import { Stops, leaveField, listenToKeys } from './keyboard.js';
import { Live } from './live.js';
import { Pull } from './pull.js';
import { notesIn, notesOf } from './notes.js';
import { Review } from './review.js';
import { readScene } from './scene.js';
import { Session } from './session.js';
import { Timeline } from './timeline.js';
import { Trails } from './trails.js';
import { View } from './view.js';
import { isAllKeys, resume } from './work.js';

const IN_TRIALS = new Set(['Ctrl+z', 'Ctrl+Shift+z', 'Ctrl+y', 'Escape']); // keys that help no interface more than another
const POSE = 'string pose = '; // stands in every shelf
const LIST = 320; // pixels that the list of controls takes in a trial
const ROOMY = 1200; // pixels of width from which the panel is open at first

const SHORTCUTS = [
  ['Drag a handle', 'its control; Ctrl for fine steps'],
  ['Touch', 'one finger drags, two pan, pinch and turn; handles under one finger move apart, a fan of them around it: touch one of these'],
  ['Drag the skin', 'best fit of the controls that act there'],
  ['Drag empty space, Alt-drag', 'orbit; right or middle button pans, wheel zooms'],
  ['Click the skin', 'list what acts there'],
  ['Shift-click', 'add to the selection; on skin: pin (or rest a finger there)'],
  ['Shift-drag', 'select handles in a box'],
  ['Double-click a handle', 'reset it'],
  ['Tab, arrow keys', 'go through the handles, and move them (Shift: more, Ctrl: less)'],
  ['S  H  L', 'symmetry, show or hide handles, all labels'],
  ['Hold H, B, I', 'hide all elements, show the pose before, show what the selection moves'],
  ['C  P  N', 'the list of controls, the panel, the notes of a review'],
  ['Double-click the skin', 'look at a region closely, and back'],
  ['M', 'open the selected coarse element into its members, or close it'],
  ['0  R', 'zero, reset the selection'],
  ['K', 'key the selection and all that changed'],
  ['1  2  3  4  F  V', "front, three-quarter, side, back; F: closer, on the face or the selection, and back; V: as the shot's camera"],
  ['Space', 'play'],
  ['D', 'all keys in rows or as curves: drag moves (Ctrl: copies, Alt: scales those picked), a drag from an empty place picks, Space plays these, Delete takes away'],
  ['O  T', 'onion skin: the keys before and after as outlines; motion trails of the selected handles on the face, a dot for each key'],
  ['Ctrl+C, Ctrl+V', 'copy and paste the pose of the selection, or of all'],
  ['/  ?', 'search, these gestures and keys'],
  ['Ctrl+Z, Ctrl+Shift+Z', 'undo, redo'],
  ['Esc', 'cancel the drag, clear the selection'],
];

class App {
  /** @type {View} */ view;
  /** @type {Timeline} */ timeline;
  /** @type {ControlList} */ list;
  /** @type {Inspector} */ inspector;
  /** @type {Review} */ review;
  /** @type {Evaluation} */ evaluation;

  constructor(scene) {
    this.tell = (text) => this.say(text);
    this.scene = scene;
    this.node = /** @type {HTMLElement} */ (document.getElementById('app'));
    this.notice = make('div', { class: 'notice', role: 'status', hidden: true });
    this.offer = make('div', { class: 'offer', role: 'alertdialog', 'aria-label': 'Work from before', hidden: true });
    this.storage = browserStorage();
    this.kept = scene.characters.map(() => null);
    this.roots = scene.characters.map(({ root }) => root);
    const received = receivedLayers();
    this.reviews = received.filter((layer) => !layer.includes(POSE)).flatMap((layer) => notesIn(layer));
    this.targets = received.filter((layer) => layer.includes(POSE));
    this.live = this.makeLive();
    this.open(0);
    this.live?.run();
    for (const event of ['pagehide', 'beforeunload']) window.addEventListener(event, (leaving) => this.leave(leaving));
    listenToKeys(this.shortcuts(), {
      h: (on) => this.view.hold('bare', on),
      b: (on) => this.session.looks || this.session.compare(on),
      i: (on) => this.view.hold('showsInfluence', on),
    }, (name) => this.session.trial && !IN_TRIALS.has(name));
  }

  /** Show one of the scene's characters, as it was left. */
  open(index) {
    if (this.evaluation?.running) this.evaluation.finish();
    this.timeline?.stop();
    this.kept[this.index]?.autosave.flush();
    this.session?.leave();
    this.index = index;
    const { session, autosave } = (this.kept[index] ??= this.begin(this.scene.characters[index]));
    this.session = session;
    this.live?.follow(session);
    autosave.listen(() => this.say('This browser has no room to keep your work: save it before you close the page'));
    this.view = new View(this.session, this.sessions.filter((each) => each !== session), this.tell);
    this.timeline = new Timeline(this.session, this.tell);
    this.trails = new Trails(this.session, this.view, this.timeline);
    this.list = new ControlList(this.session, this.view);
    this.inspector = new Inspector(this.session, this.view, this.timeline, this.tell);
    this.review = new Review(this.session, this.view, this.timeline, this.tell, this.roots, () => this.reviewed());
    this.evaluation = new Evaluation(this);
    this.stops = new Stops(this.session, this.view);
    this.help = this.makeHelp();
    this.view.node.append(this.evaluation.panel, this.help, this.offer, this.notice);
    // The view comes first for the keyboard, wherever it is on the screen.
    const middle = make('div', { class: 'middle' }, this.view.node, this.list.node, this.inspector.node, this.review.node);
    this.node.replaceChildren(middle, new Bar(this).node, this.timeline.sheet.node, this.timeline.node);
    this.node.className = 'ready';
    this.fold('list', false);
    this.fold('review', this.session.arrived.length > 0);
    this.fold('inspector', window.innerWidth >= ROOMY && !this.session.arrived.length);
    this.offerWork(autosave);
  }

  begin(character) {
    const session = new Session(character);
    session.notes = session.arrived = notesOf(this.reviews, session, this.roots);
    session.received = session.notes.map(({ id }) => id);
    const isElsewhere = () => Boolean(this.live?.holds(session)) && isAllKeys(session);
    return { session, autosave: new Autosave(session, this.storage, isElsewhere) };
  }

  /** Those of all characters, those not looked at yet among them. */
  get sessions() {
    return this.scene.characters.map((character, index) => (this.kept[index] ??= this.begin(character)).session);
  }

  /** [session, notes] of every character. */
  reviewed() {
    return this.sessions.map((session) => [session, session.notes]);
  }

  /** The link to the layer that this page was opened for; every change is a key there, or stands at all frames. */
  makeLive() {
    const { live } = document.body.dataset;
    if (!live) return null;
    this.kept = this.scene.characters.map((character) => this.begin(character));
    const sessions = this.kept.map(({ session }) => session);
    for (const session of sessions) {
      session.options.autoKey = true;
      if (session.animation.clip) session.go(session.frame);
    }
    return new Live(sessions, live, this.tell);
  }

  // --- work from before ------------------------------------------------------------------------------

  /** Offer what an earlier page has left of this character. */
  offerWork(autosave) {
    const found = autosave.offered;
    this.offer.hidden = !found;
    if (!found) return;
    const choice = (label, act) => button(label, '', () => {
      act();
      autosave.discard(found);
      this.offerWork(autosave);
    });
    const restore = () => {
      resume(this.session, found.work);
      autosave.flush();
    };
    const when = new Date(found.saved).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
    this.offer.replaceChildren(
      make('span', {}, `Your work of ${when}: ${found.words}`),
      choice('Restore', restore),
      choice('Discard', () => {}),
    );
  }

  /** Keep all work, and let the browser ask where some cannot be kept. */
  leave(event) {
    const kept = this.kept.filter(Boolean).map(({ autosave }) => autosave);
    kept.forEach((autosave) => autosave.flush());
    if (kept.some((autosave) => autosave.isUnsaved)) event.preventDefault();
  }

  // --- bar -------------------------------------------------------------------------------------------

  /** Show one of the characters as if for the first time. */
  startAfresh(index = this.index) {
    this.kept[index]?.autosave.forget();
    this.kept[index] = null;
    this.open(index);
  }

  /** Fold a panel away or open it: narrow pages have room for one, others for the list and one. */
  fold(panel, open = this[panel].node.hidden) {
    const others = ['list', 'inspector', 'review'].filter((each) => each !== panel);
    const giving = window.innerWidth < ROOMY ? others : others.filter((each) => each !== 'list' && panel !== 'list');
    if (open) giving.forEach((each) => (this[each].node.hidden = true));
    this[panel].node.hidden = !open;
    this.node.classList.toggle('reviewing', !this.review.node.hidden);
    if (this.review.node.hidden) this.session.options.draw = false;
    this.session.emit('options');
  }

  makeHelp() {
    const rows = SHORTCUTS.flatMap(([keys, what]) => [make('dt', {}, keys), make('dd', {}, what)]);
    return make('div', { class: 'help', hidden: true }, make('h2', {}, 'Gestures and keys'), make('dl', {}, ...rows));
  }

  showHelp() {
    this.help.hidden = !this.help.hidden;
  }

  setArrangement(value) {
    this.session.setOption('arrangement', value);
    this.view.home(this.view.camera.azimuth, this.view.camera.elevation);
  }

  undo() {
    this.sayDone('Undone', 'undo', this.session.undo());
  }

  redo() {
    this.sayDone('Redone', 'redo', this.session.redo());
  }

  sayDone(done, todo, label) {
    this.say(label ? `${done}: ${label}` : `Nothing to ${todo}`);
  }

  say(text) {
    this.notice.textContent = text;
    this.notice.hidden = false;
    clearTimeout(this.silence);
    this.silence = setTimeout(() => (this.notice.hidden = true), Math.max(2400, 70 * text.length)); // time to read it
  }

  // --- keys ------------------------------------------------------------------------------------------

  shortcuts() {
    const flip = (name) => () => this.session.flipOption(name);
    const looks = LOOKS.map(([, azimuth, elevation], i) => [i + 1, () => this.view.home(azimuth, elevation)]);
    return {
      'Ctrl+z': () => this.undo(),
      'Ctrl+Shift+z': () => this.redo(),
      'Ctrl+y': () => this.redo(),
      'Ctrl+a': () => this.session.select(this.view.overlay.elementsIn([-1e9, -1e9, 1e9, 1e9])),
      s: flip('symmetric'),
      h: flip('handles'),
      c: () => this.fold('list'),
      p: () => this.fold('inspector'),
      n: () => this.fold('review'),
      l: () => this.session.setOption('labels', this.session.options.labels === 'all' ? 'hover' : 'all'),
      0: () => this.session.zero(this.session.chosenControls),
      r: () => this.session.reset(this.session.chosenControls),
      m: () => this.session.openOrClose() || this.say('Nothing selected has members'),
      k: () => this.timeline.key(),
      d: () => this.timeline.openSheet(),
      o: flip('onion'),
      t: flip('trails'),
      v: () => (this.session.character.shotCamera ? this.session.flipOption('shot') : this.say('The stage has no camera, or several and no render settings that choose one')),
      'Ctrl+c': () => this.session.copy(),
      'Ctrl+v': () => this.session.paste(),
      ...Object.fromEntries(looks),
      f: () => this.view.frameClosely(),
      ' ': () => this.timeline.toggle(),
      '/': () => {
        this.fold('list', true);
        this.list.search.focus();
      },
      '?': () => this.showHelp(),
      'Shift+?': () => this.showHelp(),
      Escape: () => this.escape(),
    };
  }

  escape() {
    if (leaveField() || this.view.gestures.cancel()) return;
    if (!this.help.hidden) this.help.hidden = true;
    else if (this.session.options.draw) this.review.setPen(false);
    else this.session.select([]);
  }

  // --- evaluation ------------------------------------------------------------------------------------

  /** What results belong to: digests of the character and of its layout, and the version that made the page. */
  identity() {
    const { identity, layoutDigest } = this.session.character;
    return { character: identity, layout: layoutDigest, version: this.scene.version };
  }

  /** Show the target beside the face and one interface only. */
  arrangeForTrial(name, targetPoints) {
    const columns = { list: ['target', 'clean'], face: ['target', 'controls'], beside: ['target', 'clean', 'controls'] };
    const captions = { target: 'Target', clean: 'Your face', controls: name === 'beside' ? 'Controls' : 'Your face' };
    this.node.classList.add('trial');
    this.node.classList.toggle('trial-list', name === 'list');
    this.list.node.hidden = name !== 'list';
    Object.assign(this.session.options, {
      skinDrag: false, rearrange: false, symmetric: false, heat: false, handles: name !== 'list',
    });
    this.view.stage.setTarget(targetPoints);
    this.session.emit('options');
    this.view.setColumns(columns[name], (kind) => captions[kind], () => this.view.commonRoom(LIST));
  }

  endTrials({ work, history, options }) {
    this.node.classList.remove('trial', 'trial-list');
    this.fold('list', false);
    Object.assign(this.session.options, options);
    this.view.stage.setTarget(null);
    this.session.history = history;
    this.session.trial = false;
    this.session.restore(work);
    this.session.emit('options');
    this.view.setColumns(null);
  }
}

/** Layers that came with the page: reviews, and shelves of poses to be matched. */
const receivedLayers = () => JSON.parse(document.getElementById('reviews')?.textContent ?? '[]');

/** What tests and other pages may use: the pose by control name, and where things are on the screen. */
function publicInterface(app) {
  const names = () => app.session.controls.map(({ name }) => name);
  return {
    values: () => Object.fromEntries(names().map((name, i) => [name, app.session.values[i]])),
    set: (values) => app.session.edit('Set', () => app.session.set(byName(values, app.session.controls))),
    pull: (point, target) => {
      const pull = new Pull(app.session, { corners: [point, point, point], shares: [1, 0, 0] }, null);
      for (let round = 0; round < 3; round++) pull.to(target);
    },
    points: () => Array.from(app.session.deformer.points),
    elements: () => {
      app.view.freshen();
      return app.view.overlay.drawn.map(({ element, handle, tracks, hidden }) => ({
        name: element.name,
        controls: element.members.map(({ control }) => app.session.controls[control].name),
        handle: handle.slice(0, 2),
        world: element.handle,
        tracks: tracks.map((track) => track.map(({ at }) => at.slice(0, 2))),
        hidden,
      }));
    },
    trials: (participant) => trialsFor(participant, app.session),
    app,
  };
}

async function begin() {
  const text = document.getElementById('scene')?.textContent;
  try {
    const scene = await readScene(text);
    window.usdrigui = publicInterface(new App(scene));
  } catch (error) {
    const told = `The scene could not be shown: ${/** @type {Error} */ (error).message}`;
    document.getElementById('app')?.replaceChildren(make('p', { class: 'loading' }, told));
    throw error;
  }
}

begin();
