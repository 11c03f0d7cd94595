// Time: plays the rig's animation, and keys of one's own on top of it.
//
// At a frame a control has the value of its own keys (linear between them), else what the animation says,
// else its present value.  Joints follow the animation where it moves them.

import { download, make } from './dom.js';
import { poseToUsda } from './pose_io.js';

const DEFAULT_RANGE = [1, 48];
const DEFAULT_RATE = 24;

export class Timeline {
  constructor(session) {
    this.session = session;
    this.clip = session.character.clip;
    const times = this.clip?.times ?? DEFAULT_RANGE;
    this.first = Math.floor(times[0]);
    this.last = Math.max(this.first + 1, Math.ceil(times.at(-1)));
    this.rate = this.clip?.framesPerSecond || DEFAULT_RATE;
    this.frame = this.first;
    this.keys = new Map(); // control index -> Map of frame -> value
    this.playing = false;
    this.engaged = false;
    this.node = this.build();
    session.on('edited', () => session.options.autoKey && this.key(session.lastChanged));
    session.on('options', () => this.update());
    this.update();
  }

  build() {
    const button = (label, title, onclick) => make('button', { type: 'button', title, onclick }, label);
    this.playButton = button('▶', 'Play or stop (Space)', () => this.toggle());
    this.playButton.classList.add('play');
    this.autoButton = button('Auto-key', 'Every drag sets keys at this frame', () =>
      this.session.setOption('autoKey', !this.session.options.autoKey),
    );
    this.slider = make('input', {
      type: 'range',
      min: this.first,
      max: this.last,
      step: 1,
      'aria-label': 'Frame',
      oninput: () => this.go(Number(this.slider.value)),
    });
    this.ticks = make('div', { class: 'ticks', 'aria-hidden': 'true' });
    this.number = make('output', { class: 'frame' });
    return make(
      'footer',
      { class: 'timeline', 'aria-label': 'Time' },
      this.playButton,
      button('‹', 'Previous key', () => this.step(-1)),
      button('›', 'Next key', () => this.step(1)),
      this.number,
      make('div', { class: 'scrub' }, this.ticks, this.slider),
      button('Key', 'Key the selected controls (or all that moved) at this frame (K)', () => this.key(this.chosen())),
      button('Delete key', 'Take away the keys at this frame', () => this.unkey()),
      this.autoButton,
      button('Save animation layer', 'Download the keyed frames as a USD layer', () => this.save()),
    );
  }

  update() {
    this.number.textContent = `${this.frame}`;
    this.slider.value = this.frame;
    this.slider.style.setProperty('--at', `${(100 * (this.frame - this.first)) / (this.last - this.first)}%`);
    this.playButton.textContent = this.playing ? '■' : '▶';
    this.autoButton.setAttribute('aria-pressed', String(this.session.options.autoKey));
    const frames = this.keyFrames();
    this.ticks.replaceChildren(
      ...frames.map((frame) =>
        make('i', { style: { left: `${(100 * (frame - this.first)) / (this.last - this.first)}%` } }),
      ),
    );
  }

  keyFrames() {
    return [...new Set([...this.keys.values()].flatMap((track) => [...track.keys()]))].sort((a, b) => a - b);
  }

  // --- keys ------------------------------------------------------------------------------------------

  chosen() {
    const { session } = this;
    const moved = [...session.controls.keys()].filter((index) => session.values[index] !== session.rest[index]);
    return session.selection.size ? session.chosenControls : moved;
  }

  key(controls) {
    const { session, frame } = this;
    this.remember(`Key frame ${frame}`, () => {
      for (const control of controls) {
        if (!this.keys.has(control)) this.keys.set(control, new Map());
        this.keys.get(control).set(frame, session.values[control]);
      }
    });
  }

  unkey() {
    this.remember(`Delete keys at frame ${this.frame}`, () => {
      for (const [control, track] of this.keys) {
        track.delete(this.frame);
        if (!track.size) this.keys.delete(control);
      }
    });
  }

  remember(label, change) {
    const copy = () => new Map([...this.keys].map(([control, track]) => [control, new Map(track)]));
    const take = (keys) => {
      this.keys = new Map([...keys].map(([control, track]) => [control, new Map(track)]));
      this.update();
    };
    const before = copy();
    change();
    const after = copy();
    this.session.history.push(label, () => take(before), () => take(after));
    this.update();
  }

  /** Take over frames [{time, values}] as keys of the controls that change or are away from rest. */
  load(frames) {
    const { session } = this;
    const used = [...session.controls.keys()].filter((index) => frames.some(({ values }) => values[index] !== session.rest[index]));
    this.remember('Load keys', () => {
      this.keys = new Map(used.map((index) => [index, new Map(frames.map(({ time, values }) => [time, values[index]]))]));
    });
    this.first = Math.min(this.first, Math.floor(frames[0].time));
    this.last = Math.max(this.last, Math.ceil(frames.at(-1).time));
    [this.slider.min, this.slider.max] = [this.first, this.last];
    this.go(frames[0].time);
  }

  // --- time ------------------------------------------------------------------------------------------

  step(direction) {
    const frames = this.keyFrames();
    const next = direction > 0 ? frames.find((frame) => frame > this.frame) : frames.findLast((frame) => frame < this.frame);
    this.go(next ?? Math.min(this.last, Math.max(this.first, this.frame + direction)));
  }

  go(frame) {
    this.engaged = true;
    this.frame = frame;
    const { values, weights, locals } = this.at(frame);
    this.session.show(values, weights, locals);
    this.update();
  }

  /** Values, base weights and base joint transforms at a frame. */
  at(frame) {
    const values = Float64Array.from(this.session.values);
    const base = this.clip ? this.clipAt(frame, values) : { weights: null, locals: null };
    for (const [control, track] of this.keys) values[control] = keyedValue(track, frame);
    return { values, ...base };
  }

  /** The animation at a frame: blend-shape controls take its weights, all else becomes the base pose. */
  clipAt(frame, values) {
    const { character, controls, rest } = this.session;
    const { times } = this.clip;
    let i = 0;
    while (i < times.length - 2 && frame >= times[i + 1]) i++;
    const next = Math.min(i + 1, times.length - 1);
    const share = next > i ? Math.min(1, Math.max(0, (frame - times[i]) / (times[next] - times[i]))) : 0;
    const row = (array, width, k) => array.subarray(k * width, (k + 1) * width);
    const count = character.channels.length;
    const [before, after] = [i, next].map((k) => row(this.clip.weights, count, k));
    const weights = Float64Array.from(before, (value, k) => value + share * (after[k] - value));
    controls.forEach((control, index) => {
      const channel = soleChannel(control);
      values[index] = channel === null ? rest[index] : valueFor(control, weights[channel] - character.baseWeights[channel]);
      if (channel !== null) weights[channel] = character.baseWeights[channel];
    });
    const wide = 16 * character.joints.length;
    const locals = this.clip.locals.length ? row(this.clip.locals, wide, share < 1 ? i : next) : null;
    return { weights, locals: locals && Float64Array.from(locals) };
  }

  toggle() {
    this.playing = !this.playing;
    this.update();
    if (!this.playing) return;
    if (this.frame >= this.last) this.frame = this.first;
    const began = performance.now() - (1000 * (this.frame - this.first)) / this.rate;
    const tick = (now) => {
      if (!this.playing) return;
      const length = this.last - this.first + 1;
      const frame = this.first + (Math.floor((Math.max(0, now - began) * this.rate) / 1000) % length);
      if (frame !== this.frame || !this.engaged) this.go(frame);
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  // --- out -------------------------------------------------------------------------------------------

  /** Frames to write: the keyed ones, or the present pose at the present frame. */
  frames() {
    const frames = this.keyFrames();
    if (!frames.length) return [{ time: this.frame, values: Float64Array.from(this.session.values) }];
    return frames.map((time) => ({ time, values: this.at(time).values }));
  }

  save() {
    download('animation.usda', poseToUsda(this.session, this.frames(), this.rate), 'text/plain');
  }
}

function keyedValue(track, frame) {
  const frames = [...track.keys()].sort((a, b) => a - b);
  const after = frames.findIndex((each) => each >= frame);
  if (after === -1) return track.get(frames.at(-1));
  if (after === 0) return track.get(frames[0]);
  const [low, high] = [frames[after - 1], frames[after]];
  return track.get(low) + ((frame - low) / (high - low)) * (track.get(high) - track.get(low));
}

/** The one channel of a plain blend-shape control, or null. */
function soleChannel({ kind, drive }) {
  return kind === 'blendShape' && drive.channels.length === 1 && !drive.joints.length ? drive.channels[0] : null;
}

/** The control value at which its drive adds `weight`; the first piece that reaches it. */
function valueFor({ drive, minimum, maximum }, weight) {
  const { values, weights } = drive;
  for (let i = 0; i + 1 < values.length; i++) {
    const [low, high] = [weights[i][0], weights[i + 1][0]];
    const share = (weight - low) / (high - low);
    const open = (i === 0 && share < 0) || (i === values.length - 2 && share > 1);
    if (Number.isFinite(share) && (open || (share >= 0 && share <= 1))) {
      return Math.min(maximum, Math.max(minimum, values[i] + share * (values[i + 1] - values[i])));
    }
  }
  return Math.min(maximum, Math.max(minimum, 0));
}
