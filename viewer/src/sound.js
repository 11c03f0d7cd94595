// A sound of the animator's own disk, for lip-sync: read into the page, shown as a wave and played in step with the frames.
// It is sent nowhere; of the file only the name and the frame at which it begins are part of the work.

import { make } from './dom.js';
import { known } from './vectors.js';

const BLIP = 0.08; // seconds that are heard of a frame while time is dragged
const PATIENCE = 300; // milliseconds that a browser has to open its output
const WAVE = 1200; // columns of a wave

export class Sound {
  constructor(session) {
    this.session = session;
    this.context = null;
    this.buffer = null;
    this.source = null;
    this.waves = new Map();
  }

  get rate() {
    return this.session.animation.rate;
  }

  get start() {
    return this.session.sound.start;
  }

  /** Whether the sound that the work names is here. */
  get isReady() {
    return Boolean(this.buffer) && this.session.sound?.name === this.name;
  }

  /** Read a file; throws an Error for people where the browser cannot. */
  async read(file) {
    this.context ??= new AudioContext();
    try {
      this.buffer = await this.context.decodeAudioData(await file.arrayBuffer());
    } catch {
      throw new Error(`This browser cannot read ${file.name} as sound.`);
    }
    this.name = file.name;
    this.waves.clear();
    const { session } = this;
    const start = session.sound?.name === file.name ? session.sound.start : session.animation.first;
    session.put(`Open ${file.name}`, { sound: { name: file.name, start, seconds: this.buffer.duration } }, 'sound');
  }

  // --- heard -----------------------------------------------------------------------------------------

  /** Sound from a frame on; resolves, when it is heard, to a clock in seconds. */
  async play(frame) {
    const context = this.isReady && (await this.opened());
    if (!context) return () => performance.now() / 1000;
    this.from(frame);
    return () => context.currentTime - (context.outputLatency || 0);
  }

  /** The context once it runs; null where the browser does not let it in time. */
  async opened() {
    const { context } = this;
    if (context.state !== 'running') await Promise.race([context.resume(), new Promise((done) => setTimeout(done, PATIENCE))]);
    return context.state === 'running' ? context : null;
  }

  /** Begin again at a frame. */
  from(frame, seconds = Infinity) {
    this.stop();
    if (!this.isReady) return;
    const { context, buffer } = this;
    const { delay, offset } = entryAt(frame, this.start, this.rate);
    if (offset >= buffer.duration) return;
    this.source = new AudioBufferSourceNode(context, { buffer });
    this.source.connect(context.destination);
    this.source.start(context.currentTime + delay, offset, Math.min(seconds, buffer.duration - offset));
  }

  /** A frame's worth, while time is dragged. */
  blip(frame) {
    if (this.isReady && this.context.state === 'running' && frame >= this.start) this.from(frame, BLIP);
  }

  stop() {
    this.source?.stop();
    this.source = null;
  }

  // --- seen ------------------------------------------------------------------------------------------

  /** A canvas with the wave between two frames, to be stretched over them. */
  wave(first, last, height = 30) {
    const key = [first, last, height, this.start].join();
    return known(this.waves, key, () => this.drawn(first, last, height));
  }

  drawn(first, last, height) {
    const canvas = make('canvas', { class: 'wave', width: WAVE, height, 'aria-hidden': 'true' });
    const pen = canvas.getContext('2d');
    const { buffer, rate } = this;
    const second = (column) => (first + (column / WAVE) * (last - first) - this.start) / rate;
    const loud = loudness(buffer.getChannelData(0), buffer.sampleRate, Array.from({ length: WAVE + 1 }, (_, i) => second(i)));
    const most = Math.max(...loud, 1e-6);
    pen.fillStyle = '#6f8fb3';
    loud.forEach((value, i) => pen.fillRect(i, (height / 2) * (1 - value / most), 1, (height * value) / most));
    return canvas;
  }
}

/** When a sound that begins at a frame is heard from another one on: seconds to wait, and seconds into it. */
export function entryAt(frame, start, rate) {
  const into = (frame - start) / rate;
  return { delay: Math.max(0, -into), offset: Math.max(0, into) };
}

/** The largest amplitude between each two of `times` (seconds, ascending). */
export function loudness(samples, rate, times) {
  return times.slice(1).map((end, i) => {
    let most = 0;
    const [from, to] = [Math.max(0, Math.floor(times[i] * rate)), Math.min(samples.length, Math.ceil(end * rate))];
    for (let k = from; k < to; k++) most = Math.max(most, Math.abs(samples[k]));
    return most;
  });
}
