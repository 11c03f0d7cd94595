// The picture of the skin: its points, normals and colours, drawn by the graphics card or by the processor.

import { make } from './dom.js';
import { Painter } from './painter.js';
import { onEyes, tints } from './eye.js';
import { facings, looks, seams, sumNormals, texturing, visibleTriangles } from './surface.js';
import { Webgl, webglOf } from './webgl.js';

const TARGET = [0.8, 0.95, 1.08]; // a cooler face, so that it is not taken for one's own

export class Stage {
  /** `how`: 'webgl' or 'canvas' to insist on one, null to take what is faster. */
  /** @type {any} */ drawer;

  /** @param {string | null} [how] */
  constructor(character, points, how = null) {
    this.node = make('div', { class: 'skin' });
    this.onlost = null;
    this.triangles = visibleTriangles(character);
    this.welded = seams(character, this.triangles);
    this.facing = facings(points, this.triangles);
    const { colours, gaze } = looks(character);
    this.gaze = gaze;
    this.eyes = onEyes(this.triangles, gaze);
    this.tints = tints(character.eye);
    this.texturing = texturing(character);
    this.skin = makeSkin(points, colours);
    this.target = null;
    this.size = [1, 1, 1];
    this.open(how);
  }

  /** Open a canvas; without WebGL, or where its context is lost for good, the processor draws. */
  open(how) {
    const canvas = make('canvas');
    const context = how === 'canvas' ? null : webglOf(canvas, how === 'webgl');
    this.drawer = context ? new Webgl(canvas, this, context) : new Painter(make('canvas'), this);
    this.drawnBy = context ? 'graphics card' : 'processor';
    if (context) canvas.addEventListener('webglcontextlost', () => this.loseCard());
    this.node.replaceChildren(this.drawer.canvas);
  }

  loseCard() {
    this.open('canvas');
    this.resize(...this.size);
    this.onlost?.();
  }

  /** The points have moved: renew normals. */
  refresh(skin = this.skin) {
    sumNormals(skin.points, this.triangles, this.welded, skin.normals);
    skin.changes.shape++;
  }

  /** Paint heat (0 to 255 per point, or null for none) on the skin. */
  paint(heat) {
    const { paint, changes } = this.skin;
    if (!heat && !this.heated) return;
    this.heated = heat !== null;
    for (let point = 0, at = 0; at < paint.length; point++, at += 4) paint[at] = heat ? heat[point] : 0;
    changes.paint++;
  }

  /** All points shown, the first of them elsewhere. */
  withPoints(first) {
    const points = this.skin.points.slice();
    points.set(first);
    return points;
  }

  /** Show a second, unmoving face with these points; null takes it away. */
  setTarget(points) {
    this.target = points && makeSkin(this.withPoints(points), this.skin.colours.map((value, i) => Math.min(1, value * TARGET[i % 3])));
    if (this.target) this.refresh(this.target);
  }

  /** `ratio`: pixels of the canvas per pixel of the page. */
  resize(width, height, ratio) {
    this.size = [width, height, ratio];
    this.drawer.resize(width, height, ratio);
  }

  draw(columns, orbit) {
    this.drawer.draw(columns, orbit, ({ kind }) => (kind === 'target' ? this.target : this.skin));
  }
}

/** A face as it is drawn; `changes` counts what drawers must take up anew. */
function makeSkin(points, colours) {
  return {
    points,
    normals: new Float32Array(points.length),
    paint: new Uint8Array((4 * points.length) / 3),
    colours,
    changes: { shape: 0, paint: 0 },
  };
}
