// A shelf of poses: each a name, a small picture and values of some controls or of all.  It is part of the session's work,
// and goes out and in as a USD layer of SkelAnimations, one Scope for each pose (docs/decisions/141).

import { posesLayer, posesFromLayer } from './pose_library.js';
import { actions, button, counted, field, hint, make, slider, takeFile } from './dom.js';
import { portrait } from './portrait.js';

export class Shelf {
  constructor(session, view, say) {
    this.session = session;
    this.view = view;
    this.say = say;
    this.share = 1; // of the way to a pose that a click goes
    this.grid = make('div', { class: 'shelf' });
    this.saving = button('Save shelf', 'Download the poses as a USD layer', () => this.save());
    this.node = make('div', {}, this.grid, this.amount(),
      actions(
        button('Keep pose', 'Put the pose of the selection, or of all controls, on the shelf', () => this.keep()),
        this.saving,
        button('Open…', 'Add the poses of a layer saved before', () => this.open())));
    session.on('time', () => this.update());
    this.update();
  }

  amount() {
    const input = slider({ min: 0, max: 100, title: 'How far a click goes from the present pose to the kept one', 'aria-label': 'Share of the pose' },
      () => 100 * this.share, (value) => {
        this.share = value / 100;
        input.update();
      });
    input.update();
    return field('Share', input);
  }

  update() {
    const { shelf } = this.session;
    if (this.shown === shelf) return;
    this.shown = shelf;
    this.saving.disabled = !shelf.length;
    const none = hint('No poses yet. Keep the present one; a click on its picture gives it back.');
    this.grid.replaceChildren(...(shelf.length ? shelf.map((pose) => this.item(pose)) : [none]));
  }

  item(pose) {
    const name = make('input', {
      type: 'text', value: pose.name, 'aria-label': `Name of the pose ${pose.name}`,
      onchange: () => this.put('Rename a pose', this.session.shelf.map((each) => (each === pose ? { ...pose, name: name.value || pose.name } : each))),
    });
    const words = `${pose.name}: ${counted(pose.values.size, 'control')}`;
    return make('div', { class: 'pose' },
      button(pose.picture ? make('img', { src: pose.picture, alt: '' }) : null, words, () => this.take(pose),
        { class: 'pose-picture', 'aria-label': `Take the pose ${pose.name}` }),
      name,
      button('×', 'Take it off the shelf', () => this.put('Take a pose off the shelf', this.session.shelf.filter((each) => each !== pose)),
        { class: 'pose-away', 'aria-label': `Take ${pose.name} off the shelf` }));
  }

  put(label, shelf) {
    this.session.put(label, { shelf });
  }

  keep() {
    const { session } = this;
    const picture = portrait(session, this.view.stage);
    const name = unused(`pose ${session.shelf.length + 1}`, session.shelf);
    this.put('Keep a pose', [...session.shelf, { name, values: session.copy(), picture }]);
  }

  /** The pose, of what is selected where it says something of it, as far as `share` says. */
  take({ name, values }) {
    const { session } = this;
    const selected = new Set(session.selection.size ? session.chosenControls : []);
    const both = [...values].filter(([control]) => selected.has(control));
    const pose = (both.length ? both : [...values]).map(([control, value]) => [control, session.values[control] + this.share * (value - session.values[control])]);
    session.asWritten(`Pose ${name}`, pose);
  }

  save() {
    this.session.save('poses.usda', posesLayer(this.session, this.session.shelf), this.say);
  }

  open() {
    return takeFile('.usda,.usd', this.say, ({ name, text }) => {
      const found = posesFromLayer(text, this.session);
      this.put(`Open ${name}`, [...this.session.shelf, ...found]);
      this.say(`${counted(found.length, 'pose')} added`);
    });
  }
}

function unused(name, shelf) {
  const taken = new Set(shelf.map((pose) => pose.name));
  for (let number = 2, free = name; ; free = `${name} (${number++})`) if (!taken.has(free)) return free;
}
