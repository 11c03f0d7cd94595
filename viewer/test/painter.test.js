import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrbitCamera } from '../src/camera.js';
import { covering } from '../src/dom.js';
import { Painter } from '../src/painter.js';
import { sumNormals } from '../src/surface.js';

const WIDE = 30; // points
const FRAME = { left: 0, top: 0, width: 300, height: 260 };
const CANVAS = () => ({ width: 0, height: 0, style: {}, getContext: () => ({ createImageData: (w, h) => ({ data: new Uint8ClampedArray(4 * w * h) }), putImageData() {} }) });

/** Two sheets, one before the other, of which the first has a bump at (x, y). */
function sheets(x, y, height) {
  const points = new Float32Array(6 * WIDE * WIDE);
  for (let k = 0; k < 2 * WIDE * WIDE; k++) {
    const at = [(k % WIDE) / WIDE, (Math.floor(k / WIDE) % WIDE) / WIDE];
    const away = Math.hypot(at[0] - x, at[1] - y);
    const bump = k < WIDE * WIDE ? height * Math.max(0, 1 - (away / 0.12) ** 2) : -0.3 * at[0];
    points.set([at[0], at[1], bump], 3 * k);
  }
  return points;
}

function surface() {
  const triangles = [];
  for (let k = 0; k < 2 * WIDE * WIDE; k++) {
    if (k % WIDE < WIDE - 1 && Math.floor(k / WIDE) % WIDE < WIDE - 1) triangles.push(k, k + 1, k + WIDE, k + 1, k + WIDE + 1, k + WIDE);
  }
  return { triangles: Uint32Array.from(triangles), facing: new Int8Array(triangles.length / 3), eyes: new Uint8Array(triangles.length / 3) };
}

function painted(painter, look, points) {
  const { normals } = look;
  sumNormals(points, painter.surface.triangles, [], normals);
  look.points.set(points);
  painter.draw([FRAME], look.camera, () => look);
  return Int32Array.from(painter.pixels);
}

function scene() {
  const count = 2 * WIDE * WIDE;
  const camera = new OrbitCamera([0, 1, 0], [0, 0, 1]);
  camera.frame([[0, 0, 0], [1, 1, 0]], FRAME.width, FRAME.height);
  return { camera, points: new Float32Array(3 * count), normals: new Float32Array(3 * count), paint: new Uint8Array(4 * count), colours: new Float32Array(3 * count).fill(0.6) };
}

test('what is drawn over the picture before is what is drawn from nothing', () => {
  const [kept, look] = [new Painter(CANVAS(), surface()), scene()];
  kept.resize(FRAME.width, FRAME.height, 1);
  let partly = 0;
  for (let step = 0; step < 12; step++) {
    const points = sheets(0.3 + 0.03 * step, 0.5, step % 5 ? 0.1 : -0.5); // through the sheet behind, too
    const over = painted(kept, look, points);
    partly += kept.tiles.some((open) => !open) ? 1 : 0;
    const fresh = new Painter(CANVAS(), surface());
    fresh.resize(FRAME.width, FRAME.height, 1);
    const whole = painted(fresh, scene(), points);
    const off = over.filter((pixel, i) => [0, 8, 16].some((shift) => Math.abs(((pixel >> shift) & 255) - ((whole[i] >> shift) & 255)) > 2));
    assert.ok(off.length < 0.001 * whole.length, `${off.length} pixels at step ${step}`);
  }
  assert.ok(partly > 8);
});

test('small steps add up to what is drawn', () => {
  const [kept, look] = [new Painter(CANVAS(), surface()), scene()];
  kept.resize(FRAME.width, FRAME.height, 1);
  const first = painted(kept, look, sheets(0.4, 0.5, 0.1));
  let last = first;
  for (let step = 1; step <= 100; step++) last = painted(kept, look, sheets(0.4 + 0.0005 * step, 0.5, 0.1));
  assert.ok(last.filter((pixel, i) => pixel !== first[i]).length > 500);
});

test('the canvas covers the face and little else', () => {
  const [painter, look] = [new Painter(CANVAS(), surface()), scene()];
  painter.resize(FRAME.width, FRAME.height, 1);
  look.camera.zoom(1.6);
  const pixels = painted(painter, look, sheets(0.4, 0.5, 0.1));
  const { left, top, canvas, wide } = painter;
  const ground = pixels[0];
  const outside = (i) => i % wide < left || i % wide >= left + canvas.width || Math.floor(i / wide) < top || Math.floor(i / wide) >= top + canvas.height;
  assert.ok(pixels.every((pixel, i) => pixel === ground || !outside(i)));
  assert.ok(canvas.width * canvas.height < 0.7 * FRAME.width * FRAME.height);
});

test('a canvas stays while what it covers moves a little, and shrinks when it is far too large', () => {
  const size = [1000, 800];
  const first = covering([300, 200, 610, 590], null, size);
  assert.deepEqual(first, [288, 192, 640, 608]);
  assert.equal(covering([310, 210, 600, 580], first, size), first);
  assert.deepEqual(covering([-50, 700, 900, 900], first, size), [0, 672, 928, 800]);
  assert.deepEqual(covering([400, 300, 410, 310], first, size), [384, 288, 416, 320]);
  assert.deepEqual(covering([2000, 300, 2100, 310], null, size), [0, 0, 1, 1]);
});
