// Time: plays the rig's animation with one's own keys over it (animation.js says how), sets keys and saves them.

import { animationLayer } from './animation_layer.js';
import { DopeSheet } from './dope_sheet.js';
import { along, button, counted, download, make, takeFile, toggle } from './dom.js';
import { Sound } from './sound.js';
import { ascending, clamp } from './vectors.js';

export class Timeline {
  /** @type {HTMLInputElement[]} */ ends;

  constructor(session, say) {
    this.session = session;
    this.say = say;
    this.rate = session.animation.rate;
    this.playing = false;
    this.sound = new Sound(session);
    this.sheet = new DopeSheet(session, say, this.sound);
    this.node = this.build();
    session.on('editing', () => this.stop());
    session.on('time', () => this.update());
    session.on('options', () => this.update());
    this.update();
  }

  get frame() {
    return this.session.frame;
  }

  build() {
    this.playButton = button('▶', 'Play or stop (Space); picked keys: between the first and the last of them', () => this.toggle(), { class: 'play' });
    this.autoButton = toggle('Auto-key', 'Every drag sets keys at this frame', () => this.session.options.autoKey, () => this.session.flipOption('autoKey'));
    this.sheetButton = toggle('Keys', 'All keys in rows: drag moves them, Ctrl-drag copies, Delete takes them away (D)', () => !this.sheet.node.hidden, () => this.openSheet());
    this.slider = make('input', {
      type: 'range',
      step: 1,
      'aria-label': 'Frame',
      oninput: () => {
        this.go(Number(this.slider.value));
        this.sound.blip(this.frame);
      },
    });
    this.ticks = make('div', { class: 'ticks', 'aria-hidden': 'true' });
    this.waves = make('div', { class: 'waves', 'aria-hidden': 'true' });
    this.soundButton = button('Sound…', '', () => this.openSound());
    this.soundStart = make('input', {
      type: 'number', class: 'sound-start', title: 'The frame at which the sound begins', 'aria-label': 'The frame at which the sound begins',
      onchange: () => this.session.put('Move the sound', { sound: { ...this.session.sound, start: Math.round(Number(this.soundStart.value)) } }, 'sound'),
    });
    const end = (words, which) => make('input', { type: 'number', class: 'span-end', title: words, 'aria-label': words, onchange: () => this.setSpan(which) });
    this.ends = ['First frame', 'Last frame'].map(end);
    this.number = make('output', { class: 'frame' });
    this.unkeyed = make('output', { class: 'unkeyed', title: 'Changed here and not keyed: they end with this frame. K keys them.' });
    return make(
      'footer',
      { class: 'timeline', 'aria-label': 'Time' },
      this.playButton,
      button('‹', 'Previous key, or the frame before where there is none', () => this.step(-1)),
      button('›', 'Next key, or the frame after where there is none', () => this.step(1)),
      this.number,
      this.unkeyed,
      this.ends[0],
      make('div', { class: 'scrub' }, this.waves, this.ticks, this.slider),
      this.ends[1],
      button('Delete key', 'Take away the keys of the selected controls, or all keys, at this frame', () => this.unkey()),
      this.autoButton,
      this.tween(),
      this.sheetButton,
      this.soundButton,
      this.soundStart,
      button('Save animation layer', 'Download the keys over the clip as a USD layer', () => this.save()),
    );
  }

  update() {
    const { session } = this;
    const { range } = session;
    const [first, last] = range;
    this.number.textContent = session.neutral && session.animation.clip?.times.length > 1 ? 'neutral' : `${this.frame}`;
    this.number.title = session.neutral ? 'The pose of the layout; the time line shows the animation' : 'Frame';
    Object.assign(this.slider, { min: first, max: last, value: this.frame });
    this.ends.forEach((input, i) => {
      input.hidden = !session.animation.isFree;
      if (document.activeElement !== input) input.value = String(range[i]);
    });
    this.slider.style.setProperty('--at', along(this.frame, range));
    this.playButton.textContent = this.playing ? '■' : '▶';
    const loose = session.unkeyed().length;
    this.unkeyed.textContent = loose ? `${loose} not keyed` : '';
    this.autoButton.update();
    this.showSound(first, last);
    const noted = new Set(session.notes.filter(({ neutral }) => !neutral).map(({ frame }) => frame));
    const tick = (name) => (frame) => make('i', { class: name, style: { left: along(frame, range) } });
    this.ticks.replaceChildren(...this.keyFrames().map(tick('')), ...[...noted].map(tick('noted')));
  }

  /** The frames of a page without a clip; keys and a sound reach beyond them. */
  setSpan(changed) {
    const before = this.session.range;
    const span = this.ends.map((input) => Math.round(Number(input.value)));
    const length = before[1] - before[0];
    if (span[0] >= span[1]) span[1 - changed] = span[changed] + (changed ? -length : length); // the other end goes along
    if (!this.session.respan(span[0], span[1])) this.say('A frame is a whole number');
    this.ends.forEach((input, i) => (input.value = String(this.session.range[i])));
  }

  // --- sound -----------------------------------------------------------------------------------------

  showSound(first, last) {
    const { sound, session } = this;
    const { name, start } = session.sound ?? {};
    const ready = sound.isReady;
    this.soundButton.textContent = !name ? 'Sound…' : ready ? shortened(name) : `Open ${shortened(name)} again`;
    this.soundButton.title = !name ? 'Open a sound of your disk; it is played in step with the frames and sent nowhere' : `${name}: open it again, or another`;
    this.soundStart.hidden = !name;
    if (name) this.soundStart.value = start;
    const wave = ready ? sound.wave(first, last) : null;
    if (this.waves.firstChild !== wave) this.waves.replaceChildren(...(wave ? [wave] : []));
  }

  openSound() {
    return takeFile('audio/*,.wav,.mp3,.ogg,.m4a,.flac', this.say, ({ file }) => this.sound.read(file));
  }

  openSheet(open) {
    this.sheet.toggle(open);
    this.sheetButton.update();
  }

  /** Between the keys before and after this frame: left is the one before, right the one after, and a little beyond. */
  tween() {
    const input = make('input', {
      type: 'range',
      class: 'tween',
      min: -25,
      max: 125,
      value: 50,
      title: 'Tween: between the keys before and after, and a little beyond',
      'aria-label': 'Tween between the keys before and after',
      oninput: () => this.session.tween(Number(input.value) / 100) || this.say('No control here has a key before and one after'),
      onchange: () => (input.value = '50'), // a tween is done when it is let go
    });
    return input;
  }

  keyFrames() {
    return ascending(this.sheet.everyKey.map(([, frame]) => frame));
  }

  // --- keys ------------------------------------------------------------------------------------------

  /** Key the selected controls and all that changed: what is seen is what is keyed, whatever moved it. */
  key() {
    if (this.session.looks) this.session.adopt();
    const controls = [...new Set([...this.chosen([]), ...this.session.changed()])];
    if (!controls.length) this.say('Nothing to key: select a control or change one');
    else this.session.key(controls);
  }

  unkey() {
    const keyed = this.chosen([...this.session.keys.keys()]);
    if (!this.session.unkey(keyed)) this.say(`No key at frame ${this.frame}`);
  }

  chosen(otherwise) {
    return this.session.selection.size ? this.session.chosenControls : otherwise;
  }

  // --- time ------------------------------------------------------------------------------------------

  step(direction) {
    const frames = this.keyFrames();
    const [first, last] = this.session.range;
    const next = direction > 0 ? frames.find((frame) => frame > this.frame) : frames.findLast((frame) => frame < this.frame);
    this.go(next ?? clamp(this.frame + direction, first, last));
  }

  /** Show a frame, and say what was lost by leaving the one before. */
  go(frame, neutral = false) {
    const left = this.frame;
    const lost = this.session.go(frame, neutral);
    if (lost.length) this.say(`${named(this.session, lost)} of frame ${left} not keyed and left behind · Ctrl+Z goes back`);
  }

  toggle() {
    if (this.playing) this.stop();
    else this.play();
  }

  stop() {
    if (!this.playing) return;
    this.playing = false;
    this.sound.stop();
    this.update();
  }

  /** First and last frame that play: of the picked keys in an open sheet, for what one does not see does not bind, or of all. */
  get played() {
    return (this.sheet.node.hidden ? null : this.sheet.span) ?? this.session.range;
  }

  /** Frames by the clock of what is heard, where there is a sound. */
  async play() {
    const [first, last] = this.played;
    const starts = this.frame < first || this.frame >= last;
    if (this.session.neutral || starts) this.go(starts ? first : this.frame);
    this.playing = true;
    this.update();
    const clock = await this.sound.play(this.frame);
    if (!this.playing) return this.sound.stop();
    const began = clock() - (this.frame - first) / this.rate;
    const length = last - first + 1;
    const tick = () => {
      if (!this.playing) return;
      const frame = first + (Math.floor(Math.max(0, clock() - began) * this.rate) % length);
      if (frame < this.frame) this.sound.from(frame);
      if (frame !== this.frame) this.go(frame);
      requestAnimationFrame(tick);
    };
    return requestAnimationFrame(tick);
  }

  // --- out -------------------------------------------------------------------------------------------

  save() {
    const { session } = this;
    const { text, unwritten } = animationLayer(session);
    if (!text) {
      this.say('Nothing is keyed and no pose is set: there is no animation to save');
      return;
    }
    const name = session.fileNamed('animation.usda');
    download(name, text);
    session.emit('saved');
    const lost = session.unkeyed();
    const notes = [
      `Saved ${name}, keys at ${counted(this.keyFrames().length, 'frame')}`,
      lost.length ? `Not keyed and not in it: ${named(session, lost)} of frame ${this.frame}` : '',
      unwritten.length ? `No animation drives ${unwritten.join(', ')}` : '',
      session.animation.clip?.thinned ? 'The clip was too long to show whole: the layer holds the frames kept' : '',
    ].filter(Boolean);
    this.say(notes.join(' · '));
  }
}

const shortened = (name) => (name.length > 18 ? `${name.slice(0, 8)}…${name.slice(-8)}` : name);

/** "jawOpen" or "3 changes". */
function named({ controls }, indices) {
  return indices.length === 1 ? controls[indices[0]].label : `${indices.length} changes`;
}
