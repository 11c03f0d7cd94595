// Onion skin: the faces at the keys before and after this frame as outlines over the picture, drawn when nothing moves.

import { make } from './dom.js';
import { Painter } from './painter.js';
import { sumNormals } from './surface.js';
import { alike, ascending } from './vectors.js';

/** @typedef {[number, number, number]} Colour */
/** @type {Colour} */
const BEFORE = [240, 169, 75]; // amber and blue, which all eyes tell apart
/** @type {Colour} */
const AFTER = [88, 166, 255];
const REST = 160; // milliseconds without a change before they are drawn
const SHADE = 26; // of 255: steps of light that are no outline
const DEPTH = 0.004; // of the distance: steps in depth that are none

export class Onion {
  constructor(view) {
    this.view = view;
    this.node = make('canvas', { class: 'onion', 'aria-hidden': 'true', hidden: true });
    this.drawn = [];
    this.painter = null;
  }

  /** Called after every picture: what is drawn for another frame, other keys or another camera goes at once. */
  follow() {
    const wanted = this.wanted();
    if (alike(wanted, this.drawn)) return;
    this.node.hidden = true;
    this.drawn = [];
    clearTimeout(this.timer);
    if (wanted.length) this.timer = setTimeout(() => this.draw(), REST);
  }

  /** All that the outlines depend on; nothing where there are none. */
  wanted() {
    const { session, camera, controlsColumn: column } = this.view;
    if (!session.options.onion || !column || session.neutral || !session.keys.size) return [];
    const { left, top, width, height } = column;
    return [session.frame, session.keys, session.constants, [...session.selection].join(), camera.azimuth, camera.elevation, camera.distance, ...camera.target, left, top, width, height];
  }

  draw() {
    const { view } = this;
    const { width, height } = view;
    this.drawn = this.wanted();
    if (!this.drawn.length) return;
    this.painter ??= new Painter(make('canvas'), view.stage);
    this.painter.resize(width, height, 1);
    const image = new ImageData(Math.max(1, Math.round(width)), Math.max(1, Math.round(height)));
    const { before, after } = keysAround(view.session);
    const here = this.outlineAt(view.session.frame);
    if (before !== null) tint(this.outlineAt(before), here, BEFORE, image);
    if (after !== null) tint(this.outlineAt(after), here, AFTER, image);
    Object.assign(this.node, { width: image.width, height: image.height, hidden: false });
    this.node.getContext('2d').putImageData(image, 0, 0);
  }

  /** How much of an outline each pixel has at a frame, 0 to 255. */
  outlineAt(frame) {
    const { view, painter } = this;
    const { deformer } = view.session;
    const points = view.stage.withPoints(view.session.atFrame(frame, (values) => deformer.posedAside(values)));
    deformer.updateMaps();
    const normals = new Float32Array(points.length);
    sumNormals(points, view.stage.triangles, view.stage.welded, normals);
    const skin = { ...view.stage.skin, points, normals, paint: new Uint8Array((4 * points.length) / 3) };
    painter.draw([view.controlsColumn], view.camera, () => skin);
    return outlined(painter);
  }
}

/** Frames of the keys before and after the present one, of the selected controls where some of them are keyed. */
export function keysAround({ keys, frame, selection, chosenControls }) {
  const chosen = new Set(selection.size ? chosenControls : []);
  const own = [...keys].filter(([control]) => chosen.has(control));
  const frames = ascending((own.length ? own : [...keys]).flatMap(([, track]) => track.map(([when]) => when)));
  return { before: frames.findLast((when) => when < frame) ?? null, after: frames.find((when) => when > frame) ?? null };
}

/** A picture's outlines: steps in depth or in its light. */
function outlined({ pixels, nearness, wide }) {
  const light = new Float32Array(pixels.length);
  for (let i = 0; i < light.length; i++) {
    const pixel = pixels[i];
    light[i] = 0.3 * (pixel & 255) + 0.59 * ((pixel >> 8) & 255) + 0.11 * ((pixel >> 16) & 255);
  }
  const out = new Uint8Array(pixels.length);
  for (let i = wide + 1; i < out.length - wide - 1; i++) {
    const shade = Math.abs(light[i + 1] - light[i - 1]) + Math.abs(light[i + wide] - light[i - wide]);
    const step = Math.max(Math.abs(nearness[i + 1] - nearness[i]), Math.abs(nearness[i + wide] - nearness[i]));
    const strength = Math.max(shade / SHADE, step / (DEPTH * Math.max(nearness[i], 1e-12))) - 1;
    if (strength > 0) out[i] = 210 * Math.min(1, strength);
  }
  return out;
}

/**
 * Draw an outline in a colour, but for what stands in the present frame's outline too: the still parts of a face.
 * @param {Uint8Array} outline @param {Uint8Array} here @param {Colour} colour @param {ImageData} image
 */
function tint(outline, here, [red, green, blue], { data, width }) {
  for (let i = width + 1; i < outline.length - width - 1; i++) {
    if (outline[i] <= data[4 * i + 3] || here[i] || here[i - 1] || here[i + 1] || here[i - width] || here[i + width]) continue;
    data[4 * i] = red;
    data[4 * i + 1] = green;
    data[4 * i + 2] = blue;
    data[4 * i + 3] = outline[i];
  }
}
