// The panel on the right: what is selected, what acts at a clicked point, how things are shown, poses and
// layout in and out.

import { keysFromLayer, poseLayer } from './animation_layer.js';
import { headingOf } from './dock.js';
import { actions, button, capitalised, counted, download, field, hint, longName, make, segmented, slider, takeFile, toggle, valueField } from './dom.js';
import { poseFromJson, poseToJson } from './pose_io.js';
import { Shelf } from './shelf.js';
import { sideName } from './view.js';

const MOST_RANKED = 12;

export class Inspector {
  constructor(session, view, timeline, say) {
    this.session = session;
    this.view = view;
    this.timeline = timeline;
    this.say = say;
    /** @type {any[]} */
    this.numbers = [];
    this.chosen = make('div', { class: 'chosen' });
    this.ranked = make('div', { class: 'ranked' });
    this.influences = section('Acts here', this.ranked, false);
    this.influences.hidden = true;
    this.node = make(
      'aside',
      { class: 'inspector', 'aria-label': 'Inspector' },
      section('Selection', this.chosen),
      this.influences,
      section('Display', this.display()),
      section('Pulling the skin', this.pulling(), false),
      section('Pose', this.poses()),
      section('Shelf', new Shelf(session, view, say).node),
      this.layoutSection(),
    );
    view.onInfluences = (hit) => this.showInfluences(hit);
    session.on('selection', () => {
      if (!this.choosing) this.influences.hidden = true; // the point clicked before says nothing about another choice
      this.showSelection();
    });
    session.on('pose', () => this.updateNumbers());
    this.showSelection();
  }

  // --- selection -------------------------------------------------------------------------------------

  showSelection() {
    const { session } = this;
    const elements = session.selectedElements;
    this.numbers = [];
    if (!elements.length) {
      this.chosen.replaceChildren(
        hint('Drag a handle, or pull the skin. Click the skin to see what acts there; shift-drag selects.'),
      );
      return;
    }
    this.chosen.replaceChildren(
      ...elements.slice(0, 8).map((element) => this.elementCard(element)),
      ...(elements.length > 8 ? [hint(`and ${elements.length - 8} more`)] : []),
      actions(
        button('Zero', 'Selected controls to their defaults (0)', () => session.zero(session.chosenControls)),
        button('Reset', 'Selected controls to the base pose (R)', () => session.reset(session.chosenControls)),
        button('Hide', 'Hide the selected elements', () => session.hide(session.selectedElements)),
        button('Key', 'Key the selected controls and all that changed, at this frame (K)', () => this.timeline.key()),
      ),
    );
    this.updateNumbers();
  }

  elementCard(element) {
    const side = [sideName(element.side), element.onBoard ? headingOf(element) : ''].filter(Boolean).join(' · ');
    return make(
      'div',
      { class: 'card', style: { borderLeftColor: this.session.colours[element.side] } },
      make('div', { class: 'card-title' }, element.label),
      side ? hint(side) : null,
      this.levelButton(element),
      ...element.members.map(({ control }) => this.numberRow(control)),
      element.reason ? hint(`${capitalised(element.reason)}.`) : null,
    );
  }

  /** Of a coarse element: show its members; of a member: show the coarse one again. */
  levelButton(element) {
    const coarse = this.session.levels.coarseOf(element);
    if (!coarse.length) return null;
    const [label, title] = element.inner.length
      ? [`Open: ${element.inner.length} members`, 'Show its members in its place (M)']
      : [`Close ${coarse.map((each) => each.label).join(', ')}`, 'Show it again in place of its members (M)'];
    return button(label, title, () => this.session.openOrClose([element]), { class: 'level' });
  }

  numberRow(index) {
    const { session } = this;
    const control = session.controls[index];
    const { minimum, maximum } = control;
    const input = valueField(session, index, { type: 'number', step: (maximum - minimum) / 100, min: minimum, max: maximum }, 'number');
    this.numbers.push({ input, index });
    const ends = `${session.worded(index, minimum)} … ${session.worded(index, maximum)}`;
    return make('label', { class: 'number-row', title: `${control.name}: ${ends}` }, longName(control.label), input);
  }

  updateNumbers() {
    for (const { input, index } of this.numbers) {
      if (document.activeElement !== input) input.value = this.session.worded(index);
    }
  }

  // --- influences ------------------------------------------------------------------------------------

  /** The controls that move a clicked point, strongest first. */
  showInfluences(hit) {
    const { session, view } = this;
    const place = session.place(hit);
    const found = session.influence.rank(session.values, () => session.traced(place));
    session.deformer.drive(session.values);
    this.influences.hidden = false;
    this.influences.open = true;
    this.ranked.replaceChildren(
      ...(found.length ? [] : [hint('No control moves this point.')]),
      ...found.slice(0, MOST_RANKED).map(({ control, share }) => {
        const { label, name } = session.controls[control];
        const element = session.elements.byControl.get(control);
        const percent = Math.round(100 * share);
        const choose = (event) => {
          this.choosing = true; // from the list, which stays
          if (element) session.select([element], event.shiftKey ? 'toggle' : 'replace');
          this.choosing = false;
        };
        const row = button(longName(label), label, choose, {
          class: 'ranked-row',
          'aria-label': label,
          'data-control': name,
          onpointerenter: () => view.pointAt(control),
          onpointerleave: () => view.pointAt(null),
        });
        row.prepend(make('i', { style: { width: `${percent}%`, background: session.colours[element?.side ?? 'none'] } }));
        row.append(make('small', {}, `${percent} %`));
        return row;
      }),
    );
    this.influences.scrollIntoView({ block: 'nearest' });
  }

  // --- display ---------------------------------------------------------------------------------------

  option(name, choices, label) {
    const { session } = this;
    const node = segmented(label, choices, () => session.options[name], (value) => session.setOption(name, value));
    return make('div', { class: 'field' }, make('span', {}, label), session.updating(node));
  }

  check(name, label, title) {
    const { session } = this;
    const input = make('input', { type: 'checkbox', onchange: () => session.setOption(name, input.checked) });
    input.update = () => (input.checked = session.options[name]);
    return make('label', { class: 'check', title }, session.updating(input), label);
  }

  slide(name, label, title, low, high) {
    const { session } = this;
    const properties = { min: low, max: high, step: (high - low) / 100, 'aria-label': label };
    const input = slider(properties, () => session.options[name], (value) => session.setOption(name, value));
    return field(label, session.updating(input), { title });
  }

  display() {
    const { session } = this;
    const showAll = button('Show hidden elements', '', () => session.showAll());
    showAll.update = () => (showAll.hidden = !session.hidden.size);
    return make(
      'div',
      {},
      this.option('occlusion', [
        ['overlay', 'Overlay', 'Draw everything on top'],
        ['ghost', 'Ghost', 'Draw what the face covers faintly'],
        ['hide', 'Depth', 'Do not draw what the face covers'],
      ], 'Covered'),
      this.option('labels', [
        ['hover', 'Hover', 'Name the handle under the pointer'],
        ['all', 'All', 'Name every handle (L)'],
      ], 'Labels'),
      this.slide('opacity', 'Opacity', 'How strongly handles and tracks are drawn', 0.1, 1),
      this.check('fade', 'Fade the others while dragging'),
      this.check('heat', 'Show the area of influence', 'Heat map of the hovered or selected control'),
      this.check('onion', 'Onion skin', 'The keys before and after as outlines, amber and blue (O)'),
      this.check('trails', 'Motion trails', 'The ways of the selected handles on the face through the frames that play, a dot for each key (T)'),
      this.session.character.shotCamera && this.check('shot', "The shot's camera", 'Look as the camera of the stage does, frame by frame, until you turn, move or zoom (V)'),
      this.check('follow', 'Elements follow the skin', 'Off: they stay where they are at rest'),
      session.updating(showAll),
      session.updating(this.drawnBy()),
    );
  }

  /** Says so when the graphics card has no part in the picture. */
  drawnBy() {
    const note = hint('Drawn by the processor: this browser has no WebGL, or only one in software.');
    note.update = () => (note.hidden = this.view.stage.drawnBy !== 'processor');
    return note;
  }

  pulling() {
    const { session } = this;
    const pins = make('div', { class: 'field' });
    pins.update = () => {
      const clear = button('Remove all', '', () => {
        session.pins = [];
        session.emit('options');
      });
      pins.replaceChildren(make('span', {}, `Pins: ${session.pins.length}`), session.pins.length ? clear : '');
    };
    return make(
      'div',
      {},
      this.check('skinDrag', 'The skin can be pulled'),
      this.slide('locality', 'Locality', 'Controls that matter less than this at the grabbed point stay as they are', 0.01, 0.6),
      session.updating(pins),
      hint('Shift-click the skin to pin it; click a pin to take it out.'),
    );
  }

  // --- poses -----------------------------------------------------------------------------------------

  poses() {
    const { session, say } = this;
    return actions(
      button('Zero all', 'Every control to its default', () => session.zero()),
      button('Reset all', 'Every control to the pose of the layout', () => session.reset()),
      button('Copy', 'Keep the values of the selection, or of all controls', () => session.copy()),
      button('Paste', 'Give the controls the values that were kept', () => session.paste()),
      button('Flip', 'The pose seen in a mirror', () => session.flip()),
      button('Left to right', 'The pose of the character’s left on its right, too', () => session.mirror('left')),
      button('Right to left', 'The pose of the character’s right on its left, too', () => session.mirror('right')),
      button('Copy JSON', 'The pose to the clipboard', () => this.copy()),
      button('Save JSON', 'Download the pose', () => session.save('pose.json', { text: poseToJson(session) })),
      button('Save pose layer', 'Download the pose as a USD layer', () => session.save('pose.usda', poseLayer(session), say)),
      button('Load…', 'A pose or layer saved before', () => takeFile('.json,.usda,.usd', say, ({ text }) => this.load(text))),
    );
  }

  async copy() {
    try {
      await navigator.clipboard.writeText(poseToJson(this.session));
      this.say('Pose copied');
    } catch {
      this.say('The browser does not let this page write to the clipboard: use Save JSON');
    }
  }

  /** Take over a pose (JSON) or the keys or the pose of a layer (usda). */
  load(text) {
    const { session } = this;
    const { keys, constants } = text.startsWith('#usda') ? keysFromLayer(text, session) : { keys: new Map(), constants: poseFromJson(text, session) };
    if (keys.size) session.load('Load keys', keys, constants);
    else session.edit('Load pose', () => session.set(constants));
    this.say('Pose loaded');
  }

  // --- layout ----------------------------------------------------------------------------------------

  /** The section with *Save corrections*, opened when somebody begins to rearrange. */
  layoutSection() {
    const { session } = this;
    const found = section('Layout', this.layout(), false);
    let before = false;
    session.on('options', () => {
      const { rearrange } = session.options;
      if (rearrange && !before) {
        found.open = true;
        found.scrollIntoView();
      }
      before = rearrange;
    });
    return found;
  }

  layout() {
    const { session, view } = this;
    const { layout } = session.character;
    const moved = hint();
    moved.update = () => {
      const count = view.rearranging.moved.size;
      moved.textContent = count ? `${counted(count, 'element')} moved` : 'Drag an element to another point of the face, or off it.';
      save.disabled = !count;
    };
    const rearrange = toggle('Rearrange', 'Drag elements to other points of the face', () => session.options.rearrange, () => session.flipOption('rearrange'));
    const save = button('Save corrections', 'Download the changes for `usdrigui process --corrections`: they hold for every later version', () =>
      download(session.fileNamed('corrections.usda'), view.rearranging.corrections()),
    );
    const facts = [
      `${layout.elements.length} elements, ${session.controls.length} controls`,
      layout.leftOff.length ? `${layout.leftOff.length} left off` : null,
    ].filter(Boolean);
    const left = layout.leftOff.map(([control, , reason]) => make('li', {}, make('b', {}, control), ` ${reason}`));
    return make(
      'div',
      {},
      actions(session.updating(rearrange), save),
      session.updating(moved),
      hint(facts.join(' · ')),
      left.length ? make('details', { class: 'left-off' }, make('summary', {}, 'Left off'), make('ul', {}, ...left)) : null,
    );
  }
}

function section(title, content, open = true) {
  return make('details', { class: 'section', open }, make('summary', {}, title), content);
}
