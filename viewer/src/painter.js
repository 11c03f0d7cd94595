// The skin drawn by the processor, into a plain canvas: where there is no WebGL, or only one that is
// software itself and takes several times as long (docs/decisions/074).  A depth buffer, colours at the
// points and straight lines between them; what WebGL draws looks the same (webgl.js has the same light).
// From the same view as before only the tiles are drawn anew in which something has moved or changed its light.

import { covering, placed } from './dom.js';
import { smooth } from './eye.js';
import { alike, clamp } from './vectors.js';

export const GROUND = '#1f2124'; // as in style.css
const BACKGROUND = 0xff24211f | 0; // the same as alpha, blue, green, red
const KEY = [-0.4, 0.52, 0.755];
const FILL = [0.7, -0.05, 0.71];
const TILE = 5; // a tile is 2 ** 5 pixels wide and high
const MUCH = 0.3; // of the points: where more have changed all is drawn anew at once
const STILL = 1 / 16; // pixels that a point moves unseen
const NEARLY = 1e-4; // of the nearness
const DARK = 0.5; // of 255: no colour runs below 0 between its corners
const LIGHT = 254;
const SAME = 0.5; // of 255 that a colour changes unseen
const EDGE = 1e-3; // pixels by which neighbours overlap, so that no gap opens between them

export class Painter {
  /** @type {Int32Array} */ pixels;
  /** @type {Float32Array} */ nearness;
  /** @type {Uint8Array} */ tiles;
  /** @type {number} */ across;
  /** @type {number} */ wide;
  /** @type {number} */ high;
  /** @type {number[] | null} */ box;
  /** @type {number[]} */ size;

  constructor(canvas, surface) {
    this.canvas = canvas;
    this.pen = canvas.getContext('2d', { alpha: false });
    this.surface = surface;
    this.left = 0; // of the canvas, in pixels of the picture
    this.top = 0;
    this.screen = null;
    this.before = null; // as `screen`, in the picture before
    this.colours = null;
    this.changed = null; // per point, whether it is drawn otherwise than before
    this.used = Uint32Array.from(new Set(surface.triangles));
    this.mapped = new Float64Array(7);
    this.view = [];
    this.resize(1, 1, 1);
  }

  resize(width, height, ratio) {
    this.ratio = ratio;
    this.size = [width, height];
    this.wide = Math.max(1, Math.round(width * ratio));
    this.high = Math.max(1, Math.round(height * ratio));
    this.image = this.pen.createImageData(this.wide, this.high);
    this.pixels = new Int32Array(this.image.data.buffer);
    this.nearness = new Float32Array(this.pixels.length);
    this.across = (this.wide >> TILE) + 1; // tiles
    this.tiles = new Uint8Array(this.across * ((this.high >> TILE) + 1));
    this.box = null; // of the canvas, in pixels of the page
    this.view = [];
  }

  draw(columns, orbit, skinOf) {
    const skins = columns.map(skinOf);
    let again = this.seesAgain(columns, orbit, skins);
    if (!again) this.wipe();
    let reach = [Infinity, Infinity, 0, 0];
    columns.forEach((column, k) => {
      if (!skins[k]) return;
      this.prepare(skins[k], column, orbit);
      if (again && this.isMuch()) {
        again = false;
        this.wipe();
      }
      if (again) this.wipeMoved();
      const frame = this.frameOf(column);
      reach = this.extended(reach, frame);
      this.fill(frame);
    });
    this.show(this.cover(reach) && again);
  }

  /** What the face reaches in a frame (as [left, top, right, bottom), in pixels), and what it does already. */
  extended(reach, frame) {
    const own = spanOf(this.screen, this.used);
    return [0, 1, 2, 3].map((k) => {
      const [least, most] = k < 2 ? [Math.max, Math.min] : [Math.min, Math.max];
      return most(reach[k], least(frame[k], own[k]));
    });
  }

  /** Let the canvas cover what the face reaches, for an empty ground takes time to show too; true where it does already. */
  cover(reach) {
    const { ratio, canvas, wide, high } = this;
    const box = covering(reach.map((value) => value / ratio), this.box, this.size);
    if (box === this.box) return true;
    this.box = box;
    [this.left, this.top] = [Math.round(box[0] * ratio), Math.round(box[1] * ratio)];
    canvas.width = Math.max(1, Math.min(wide, Math.round(box[2] * ratio)) - this.left);
    canvas.height = Math.max(1, Math.min(high, Math.round(box[3] * ratio)) - this.top);
    placed(canvas, box);
    return false;
  }

  /** Whether so much of the face is drawn otherwise than before that all of it is drawn anew. */
  isMuch() {
    const { changed } = this;
    return changed.reduce((sum, each) => sum + each, 0) > MUCH * changed.length;
  }

  /** Whether the same face is seen from the same place as in the picture before, alone. */
  seesAgain(columns, { position, right, above }, skins) {
    const own = skins[0] ? [skins[0].points, skins[0].colours] : [];
    const view = [columns.length, ...columns.flatMap(({ left, top, width, height }) => [left, top, width, height]), ...position, ...right, ...above, ...own];
    const again = columns.length === 1 && alike(view, this.view);
    this.view = view;
    return again;
  }

  /** Where all points are in the picture, their colours, and which of both have changed. */
  prepare(skin, column, orbit) {
    const { length } = skin.points;
    [this.screen, this.before] = [this.before ?? new Float32Array(length), this.screen ?? new Float32Array(length)];
    (this.changed ??= new Uint8Array(length / 3)).fill(0);
    this.paint = skin.paint;
    this.project(skin.points, column, orbit);
    this.light(skin, orbit);
  }

  wipe() {
    this.pixels.fill(BACKGROUND);
    this.nearness.fill(0);
    this.tiles.fill(1);
  }

  /** Empty the tiles in which a triangle that has changed is, or was. */
  wipeMoved() {
    const { changed, tiles, across, wide, high, pixels, nearness } = this;
    const { triangles } = this.surface;
    tiles.fill(0);
    for (let t = 0; t < triangles.length; t += 3) {
      if (!(changed[triangles[t]] | changed[triangles[t + 1]] | changed[triangles[t + 2]])) continue;
      this.markTiles(this.before, t);
      this.markTiles(this.screen, t);
    }
    for (let tile = 0; tile < tiles.length; tile++) {
      if (!tiles[tile]) continue;
      const left = (tile % across) << TILE;
      const top = Math.floor(tile / across) << TILE;
      const right = Math.min(wide, left + (1 << TILE));
      const bottom = Math.min(high, top + (1 << TILE));
      for (let row = top; row < bottom; row++) {
        pixels.fill(BACKGROUND, row * wide + left, row * wide + right);
        nearness.fill(0, row * wide + left, row * wide + right);
      }
    }
  }

  markTiles(screen, t) {
    const { tiles, across, wide, high } = this;
    const { triangles, facing } = this.surface;
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const ax = screen[a];
    const ay = screen[a + 1];
    const bx = screen[b];
    const by = screen[b + 1];
    const cx = screen[c];
    const cy = screen[c + 1];
    if (facing[t / 3] * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) > 0) return;
    const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx))) >> TILE;
    const right = Math.min(wide - 1, Math.floor(Math.max(ax, bx, cx))) >> TILE;
    const top = Math.max(0, Math.ceil(Math.min(ay, by, cy))) >> TILE;
    const bottom = Math.min(high - 1, Math.floor(Math.max(ay, by, cy))) >> TILE;
    for (let y = top; y <= bottom; y++) for (let x = left; x <= right; x++) tiles[y * across + x] = 1;
  }

  /** Whether one of the tiles over these pixels is to be drawn. */
  isOpen(x0, x1, y0, y1) {
    const { tiles, across } = this;
    for (let y = y0 >> TILE; y <= y1 >> TILE; y++) {
      for (let x = x0 >> TILE; x <= x1 >> TILE; x++) if (tiles[y * across + x]) return true;
    }
    return false;
  }

  /** Put the picture, or what has changed of it, on the canvas. */
  show(again) {
    const { canvas, left, top } = this;
    const [x0, y0, x1, y1] = again ? this.openTiles() : [left, top, left + canvas.width, top + canvas.height];
    if (x1 > x0) this.pen.putImageData(this.image, -left, -top, x0, y0, x1 - x0, y1 - y0);
  }

  /** Pixels of all tiles that are drawn anew: [left, top, right, bottom). */
  openTiles() {
    const { tiles, across } = this;
    let [left, top, right, bottom] = [Infinity, Infinity, 0, 0];
    tiles.forEach((open, tile) => {
      if (!open) return;
      const [x, y] = [tile % across, Math.floor(tile / across)];
      [left, top, right, bottom] = [Math.min(left, x), Math.min(top, y), Math.max(right, x + 1), Math.max(bottom, y + 1)];
    });
    return [left, top, right, bottom].map((value) => value << TILE);
  }

  /** Columns and rows of pixels that belong to a column of the picture: [left, top, right, bottom). */
  frameOf({ left, top, width, height }) {
    const { wide, high, ratio } = this;
    const within = (value, most) => clamp(Math.round(value * ratio), 0, most);
    return [
      within(left, wide), within(top, high),
      within(left + width, wide), within(top + height, high),
    ];
  }

  /** Pixel and nearness (1 / depth, 0 behind the viewer) of every point. */
  project(points, column, { position, right, above, towards, half }) {
    const { screen, before, changed } = this;
    const focal = (this.ratio * column.height) / (2 * half);
    const cx = this.ratio * (column.left + column.width / 2) - 0.5;
    const cy = this.ratio * (column.top + column.height / 2) - 0.5;
    const [ex, ey, ez] = position;
    const [rx, ry, rz] = right;
    const [ax, ay, az] = above;
    const [tx, ty, tz] = towards;
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i] - ex;
      const y = points[i + 1] - ey;
      const z = points[i + 2] - ez;
      const depth = -(x * tx + y * ty + z * tz);
      const near = depth > 1e-9 ? 1 / depth : 0;
      const along = cx + (x * rx + y * ry + z * rz) * near * focal;
      const row = cy - (x * ax + y * ay + z * az) * near * focal;
      if (Math.abs(along - before[i]) < STILL && Math.abs(row - before[i + 1]) < STILL && Math.abs(near - before[i + 2]) <= NEARLY * near) {
        screen[i] = before[i]; // as it was drawn, so that small steps add up until they are seen
        screen[i + 1] = before[i + 1];
        screen[i + 2] = before[i + 2];
        continue;
      }
      screen[i] = along;
      screen[i + 1] = row;
      screen[i + 2] = near;
      changed[i / 3] = 1;
    }
  }

  /** Colour of every point, 0 to 255: two lights that stay with the camera, and the heat map. */
  light({ points, normals, paint, colours: own }, { position, right, above, towards }) {
    const colours = (this.colours ??= new Float32Array(points.length));
    const { changed } = this;
    const [rx, ry, rz] = right;
    const [ax, ay, az] = above;
    const [tx, ty, tz] = towards;
    for (let i = 0, p = 0; i < points.length; i += 3, p += 4) {
      const length = Math.sqrt(normals[i] * normals[i] + normals[i + 1] * normals[i + 1] + normals[i + 2] * normals[i + 2]);
      const scale = length > 0 ? 1 / length : 0;
      let x = scale * (normals[i] * rx + normals[i + 1] * ry + normals[i + 2] * rz);
      let y = scale * (normals[i] * ax + normals[i + 1] * ay + normals[i + 2] * az);
      let z = scale * (normals[i] * tx + normals[i + 1] * ty + normals[i + 2] * tz);
      if (z < 0.1 && inside(normals, points, i, scale, position)) {
        x = -x;
        y = -y;
        z = -z;
      }
      const key = Math.max(0, x * KEY[0] + y * KEY[1] + z * KEY[2]);
      const fill = Math.max(0, x * FILL[0] + y * FILL[1] + z * FILL[2]);
      const sky = 0.5 + 0.5 * y;
      const edge = 1 - Math.abs(z);
      const rim = edge * edge * edge * 0.035;
      let red = own[i];
      let green = own[i + 1];
      let blue = own[i + 2];
      if (paint[p] > 2) [red, green, blue] = heated(paint[p] / 255, [red, green, blue]);
      red = DARK + LIGHT * Math.min(1, red * Math.sqrt(0.2 * sky + 0.8 * key + 0.2 * fill) + rim);
      green = DARK + LIGHT * Math.min(1, green * Math.sqrt(0.21 * sky + 0.77 * key + 0.22 * fill) + rim);
      blue = DARK + LIGHT * Math.min(1, blue * Math.sqrt(0.23 * sky + 0.73 * key + 0.26 * fill) + rim);
      if (Math.abs(colours[i] - red) < SAME && Math.abs(colours[i + 1] - green) < SAME && Math.abs(colours[i + 2] - blue) < SAME) continue;
      colours[i] = red;
      colours[i + 1] = green;
      colours[i + 2] = blue;
      changed[i / 3] = 1;
    }
  }

  /** All triangles of open tiles that face the viewer (or have two sides) into the pixels of `frame`. */
  fill(frame) {
    const { screen } = this;
    const { triangles, facing, eyes, texturing } = this.surface;
    const on = texturing?.on;
    const [left, top, right, bottom] = frame;
    for (let t = 0, k = 0; t < triangles.length; t += 3, k++) {
      const a = 3 * triangles[t];
      const b = 3 * triangles[t + 1];
      const c = 3 * triangles[t + 2];
      const ux = screen[b] - screen[a];
      const uy = screen[b + 1] - screen[a + 1];
      const vx = screen[c] - screen[a];
      const vy = screen[c + 1] - screen[a + 1];
      const area = ux * vy - uy * vx; // negative where the corners run counter-clockwise on the screen
      if (facing[k] * area > 0 || area === 0) continue;
      if (screen[a + 2] === 0 || screen[b + 2] === 0 || screen[c + 2] === 0) continue;
      const x0 = Math.max(left, Math.ceil(Math.min(screen[a], screen[b], screen[c])));
      const x1 = Math.min(right - 1, Math.floor(Math.max(screen[a], screen[b], screen[c])));
      if (x0 > x1) continue;
      const y0 = Math.max(top, Math.ceil(Math.min(screen[a + 1], screen[b + 1], screen[c + 1])));
      const y1 = Math.min(bottom - 1, Math.floor(Math.max(screen[a + 1], screen[b + 1], screen[c + 1])));
      if (y0 > y1 || !this.isOpen(x0, x1, y0, y1)) continue;
      if (eyes[k]) this.eye(a, b, c, 1 / area, x0, x1, y0, y1);
      else this.triangle(a, b, c, 1 / area, x0, x1, y0, y1, on?.[k] ? t : -1);
    }
  }

  /**
   * One triangle over the rows y0..y1 between the columns x0 and x1: from its left edge to its right one.  Nearness and
   * colours grow linearly along the row, in 1/256; blue and red share one number, sixteen bits apart.  `t` is the first
   * of its corners on the texture, -1 where it has none.
   */
  triangle(a, b, c, unit, x0, x1, y0, y1, t) {
    const { screen, colours, pixels, nearness, wide } = this;
    const ax = screen[a];
    const ay = screen[a + 1];
    // Weights of b and c grow by these to the right and down.
    const bx = (screen[c + 1] - ay) * unit;
    const by = (ax - screen[c]) * unit;
    const cx = (ay - screen[b + 1]) * unit;
    const cy = (screen[b] - ax) * unit;
    const near = screen[a + 2];
    const nearB = screen[b + 2] - near;
    const nearC = screen[c + 2] - near;
    const nearX = bx * nearB + cx * nearC;
    const nearY = by * nearB + cy * nearC;
    const red = 256 * colours[a];
    const redB = 256 * colours[b] - red;
    const redC = 256 * colours[c] - red;
    const redX = bx * redB + cx * redC;
    const redY = by * redB + cy * redC;
    const green = 256 * colours[a + 1];
    const greenB = 256 * colours[b + 1] - green;
    const greenC = 256 * colours[c + 1] - green;
    const greenX = bx * greenB + cx * greenC;
    const greenY = by * greenB + cy * greenC;
    const blue = 256 * colours[a + 2];
    const blueB = 256 * colours[b + 2] - blue;
    const blueC = 256 * colours[c + 2] - blue;
    const blueX = bx * blueB + cx * blueC;
    const blueY = by * blueB + cy * blueC;
    const stepG = greenX | 0;
    const stepBR = (((blueX | 0) << 16) + (redX | 0)) | 0;
    const { mapped } = this;
    if (t >= 0) this.mapping(a, b, c, t, bx, by, cx, cy);
    // corners from the highest to the lowest
    let p = a;
    let q = b;
    let r = c;
    let swap = 0;
    if (screen[q + 1] < screen[p + 1]) { swap = p; p = q; q = swap; }
    if (screen[r + 1] < screen[q + 1]) { swap = q; q = r; r = swap; }
    if (screen[q + 1] < screen[p + 1]) { swap = p; p = q; q = swap; }
    const px = screen[p];
    const py = screen[p + 1];
    const qx = screen[q];
    const qy = screen[q + 1];
    const rx = screen[r];
    const ry = screen[r + 1];
    const long = (rx - px) / (ry - py);
    const upper = (qx - px) / (qy - py);
    const lower = (rx - qx) / (ry - qy);
    const bend = px + (qy - py) * long < qx; // the corner in the middle is on the right
    for (let y = y0; y <= y1; y++) {
      const one = px + (y - py) * long;
      const two = y < qy ? px + (y - py) * upper : qx + (y - qy) * lower;
      const first = Math.max(x0, Math.ceil((bend ? one : two) - EDGE));
      const last = Math.min(x1, Math.floor((bend ? two : one) + EDGE));
      if (!(first <= last)) continue;
      const right = first - ax;
      const down = y - ay;
      let n = near + right * nearX + down * nearY;
      let g = (green + right * greenX + down * greenY) | 0;
      let l = (((blue + right * blueX + down * blueY) << 16) + ((red + right * redX + down * redY) | 0)) | 0;
      if (t >= 0) {
        const u = (mapped[0] + right * mapped[1] + down * mapped[2]) | 0;
        const v = (mapped[3] + right * mapped[4] + down * mapped[5]) | 0;
        this.texturedRow(y * wide + first, y * wide + last, n, nearX, g, stepG, l, stepBR, u, mapped[1] | 0, v, mapped[4] | 0, mapped[6]);
        continue;
      }
      for (let at = y * wide + first, stop = y * wide + last; at <= stop; at++) {
        if (n > nearness[at]) {
          nearness[at] = n;
          pixels[at] = -16777216 | ((l >>> 8) & 0xff00ff) | (g & 0xff00);
        }
        n += nearX;
        g = (g + stepG) | 0;
        l = (l + stepBR) | 0;
      }
    }
  }

  /** The texture between the corners at `t` of the surface, by its growth to the right and down, in 1/65536 texels. */
  mapping(a, b, c, t, bx, by, cx, cy) {
    const { mapped, paint } = this;
    const { corners, places, width, height } = this.surface.texturing;
    const first = 2 * corners[t];
    const second = 2 * corners[t + 1];
    const third = 2 * corners[t + 2];
    for (let axis = 0; axis < 2; axis++) {
      const size = 65536 * (axis ? height : width);
      const start = size * places[first + axis];
      const toB = size * places[second + axis] - start;
      const toC = size * places[third + axis] - start;
      mapped[3 * axis] = start;
      mapped[3 * axis + 1] = bx * toB + cx * toC;
      mapped[3 * axis + 2] = by * toB + cy * toC;
    }
    const heat = paint[(4 * a) / 3] + paint[(4 * b) / 3] + paint[(4 * c) / 3];
    mapped[6] = heat > 8 ? Math.round(255 * 0.85 * smooth(0.01, 0.2, heat / 765)) : 0;
  }

  /**
   * A row of a triangle as `triangle` has it, from pixel to pixel: its light times the texels, as far as the heat map, of
   * which `white` parts of 255, leaves them; what they cut out is not drawn.
   */
  texturedRow(at, stop, n, nearX, g, stepG, l, stepBR, u, stepU, v, stepV, white) {
    const { pixels, nearness } = this;
    const { texels, width } = this.surface.texturing;
    for (; at <= stop; at++) {
      if (n > nearness[at]) {
        let texel = texels[(v >> 16) * width + (u >> 16)];
        if (texel < 0) { // its highest bit: more than half opaque
          nearness[at] = n;
          if (white) texel = whitened(texel, white);
          const blue = (((texel >> 16) & 255) * (l >>> 16)) & 0xff0000;
          const green = ((((texel >> 8) & 255) * g) >> 8) & 0xff00;
          pixels[at] = -16777216 | blue | green | (((texel & 255) * (l & 0xffff)) >> 16);
        }
      }
      n += nearX;
      g = (g + stepG) | 0;
      l = (l + stepBR) | 0;
      u = (u + stepU) | 0;
      v = (v + stepV) | 0;
    }
  }

  /** One triangle of an eyeball, pixel by pixel: what is white at its corners has an iris and a pupil in between. */
  eye(a, b, c, unit, x0, x1, y0, y1) {
    const { screen, colours, pixels, nearness, surface } = this;
    const { gaze, tints } = surface;
    const { factors, perRadius, last } = tints;
    const [ga, gb, gc] = [(2 * a) / 3, (2 * b) / 3, (2 * c) / 3];
    const bx = (screen[c + 1] - screen[a + 1]) * unit;
    const by = (screen[a] - screen[c]) * unit;
    const cx = (screen[a + 1] - screen[b + 1]) * unit;
    const cy = (screen[b] - screen[a]) * unit;
    for (let y = y0; y <= y1; y++) {
      let wb = (x0 - screen[a]) * bx + (y - screen[a + 1]) * by;
      let wc = (x0 - screen[a]) * cx + (y - screen[a + 1]) * cy;
      for (let x = x0, at = y * this.wide + x0; x <= x1; x++, at++, wb += bx, wc += cx) {
        const wa = 1 - wb - wc;
        if (wa < -EDGE || wb < -EDGE || wc < -EDGE) continue;
        const near = wa * screen[a + 2] + wb * screen[b + 2] + wc * screen[c + 2];
        if (near <= nearness[at]) continue;
        nearness[at] = near;
        const right = wa * gaze[ga] + wb * gaze[gb] + wc * gaze[gc];
        const up = wa * gaze[ga + 1] + wb * gaze[gb + 1] + wc * gaze[gc + 1];
        const step = 3 * Math.min(last, Math.floor(Math.sqrt(right * right + up * up) * perRadius));
        const red = factors[step] * (wa * colours[a] + wb * colours[b] + wc * colours[c]);
        const green = factors[step + 1] * (wa * colours[a + 1] + wb * colours[b + 1] + wc * colours[c + 1]);
        const blue = factors[step + 2] * (wa * colours[a + 2] + wb * colours[b + 2] + wc * colours[c + 2]);
        pixels[at] = -16777216 | (blue << 16) | (green << 8) | red;
      }
    }
  }
}

/** A texel mixed with so many parts of 255 of white. */
function whitened(texel, white) {
  const mixed = (channel) => (((texel >> channel) & 255) * (255 - white) + 255 * white) / 255;
  return -16777216 | (mixed(16) << 16) | (mixed(8) << 8) | mixed(0);
}

/** The pixels between which some points are: [left, top, right, bottom). */
function spanOf(screen, points) {
  const span = new Float64Array([Infinity, Infinity, -Infinity, -Infinity]);
  for (let k = 0; k < points.length; k++) {
    const x = screen[3 * points[k]];
    const y = screen[3 * points[k] + 1];
    if (x < span[0]) span[0] = x;
    if (y < span[1]) span[1] = y;
    if (x >= span[2]) span[2] = x + 1;
    if (y >= span[3]) span[3] = y + 1;
  }
  return span;
}

/** True where the inside of an open part is seen: the normal points away from the viewer. */
function inside(normals, points, i, scale, eye) {
  const x = points[i] - eye[0];
  const y = points[i + 1] - eye[1];
  const z = points[i + 2] - eye[2];
  return scale * (normals[i] * x + normals[i + 1] * y + normals[i + 2] * z) > 0.3 * Math.sqrt(x * x + y * y + z * z);
}

const LOW = [0.2, 0.24, 0.62];
const MIDDLE = [0.78, 0.2, 0.44];
const HIGH = [1.0, 0.82, 0.3];

function heated(heat, colour) {
  const share = 0.85 * smooth(0.01, 0.2, heat);
  const low = smooth(0, 0.5, heat);
  const high = smooth(0.45, 1, heat);
  return colour.map((value, k) => {
    const ramp = LOW[k] + low * (MIDDLE[k] - LOW[k]);
    return value + share * (ramp + high * (HIGH[k] - ramp) - value);
  });
}
