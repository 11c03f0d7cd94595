// A small picture of the face from the front, without anything on it, drawn by the processor.

import { OrbitCamera } from './camera.js';
import { make } from './dom.js';
import { GROUND, Painter } from './painter.js';

const SIZE = 112; // pixels
const FINER = 2;

/** The present pose as a data URL. */
export function portrait(session, stage) {
  const { character, section, elements } = session;
  const camera = new OrbitCamera(character.up, section.view);
  const onFace = elements.list.filter((element) => session.isShown(element) && !element.onBoard);
  const around = onFace.map(({ restPoint }) => restPoint);
  camera.frame(around.length ? around : [...threes(stage.skin.points)], SIZE, SIZE, 1.35);
  const painter = new Painter(make('canvas'), stage);
  painter.resize(SIZE, SIZE, FINER);
  stage.refresh();
  const bare = { ...stage.skin, paint: new Uint8Array(stage.skin.paint.length) };
  painter.draw([{ left: 0, top: 0, width: SIZE, height: SIZE }], camera, () => bare);
  const small = make('canvas', { width: SIZE, height: SIZE });
  const pen = small.getContext('2d');
  const [left, top, right, bottom] = /** @type {number[]} */ (painter.box);
  pen.fillStyle = GROUND;
  pen.fillRect(0, 0, SIZE, SIZE);
  pen.drawImage(painter.canvas, left, top, right - left, bottom - top);
  return small.toDataURL('image/jpeg', 0.85);
}

function* threes(points) {
  for (let i = 0; i < points.length; i += 3) yield points.subarray(i, i + 3);
}
