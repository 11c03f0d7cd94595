// Making page elements.

import { clamp } from './vectors.js';

export const FINGER = 44; // pixels that fingertips need

/** An element with properties, attributes (aria-*, data-*, role), event listeners (onX) and children. */
export function make(tag, properties = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (name === 'class') node.className = value;
    else if (name === 'style') Object.assign(node.style, value);
    else if (name.includes('-') || name === 'role' || name === 'for') node.setAttribute(name, value);
    else node[name] = value;
  }
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/** Words beside what they explain. */
export const hint = (...words) => make('p', { class: 'hint' }, ...words);

export const actions = (...buttons) => make('div', { class: 'actions' }, ...buttons);

/** A control with its name before it. */
export const field = (name, node, more = {}) => make('label', { class: 'field', ...more }, make('span', {}, name), node);

/** A slider whose bar is filled up to its value, which `input.update` renews; `oninput` hears of numbers. */
export function slider(properties, current, oninput) {
  const input = make('input', { type: 'range', ...properties, oninput: () => oninput(Number(input.value)) });
  input.update = () => {
    input.value = current();
    input.style.setProperty('--at', along(input.value, [input.min, input.max]));
  };
  return input;
}

/** A field for one of a session's values: what is no number gives way to the value again. */
export function valueField(session, index, properties, merge) {
  const { label } = session.controls[index];
  const input = make('input', {
    'aria-label': label,
    ...properties,
    onchange: () => {
      const value = parseFloat(input.value.replace(',', '.'));
      if (Number.isFinite(value)) session.edit(`Set ${label}`, () => session.set([[index, value]]), `${merge} ${index}`);
      input.value = session.worded(index);
    },
  });
  return input;
}

/** Where a frame or a value is between two, for a style. */
export const along = (value, [first, last]) => `${(100 * (value - first)) / (last - first)}%`;

export function setAll(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
}

/** Whether [left, top, width, height] of the screen has a place in it. */
export const contains = ({ left, top, width, height }, { x, y }) => x >= left && x < left + width && y >= top && y < top + height;

/** "1 key", "2 keys". */
export const counted = (number, what) => `${number} ${what}${number === 1 ? '' : 's'}`;

export const capitalised = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** The part of a name that tells it from its neighbours: its last word, mostly a side or a direction. */
export function lastWord(text) {
  const word = /[_.:\- ][^_.:\- ]{1,9}$/.exec(text) ?? /[A-Z][a-z]{1,8}$/.exec(text);
  return word ? word[0] : text.slice(-5);
}

/** A name that, where it is too long, loses its middle and keeps its last word. */
export function longName(text) {
  const end = lastWord(text);
  const start = text.slice(0, text.length - end.length);
  return make('span', { class: 'long-name' }, make('span', { class: 'start' }, start), make('span', {}, end));
}

/** A button with a text that does something, and more properties. */
export const button = (label, title, onclick, more = {}) => make('button', { type: 'button', title, onclick, ...more }, label);

/** A button that is pressed or not; `icon` is short text. */
export function toggle(label, title, isOn, press) {
  const node = button(label, title, press, { class: 'toggle' });
  node.update = () => setAll(node, { 'aria-pressed': isOn() });
  node.update();
  return node;
}

/** A group of buttons of which one is pressed: `choices` are [value, label, title]. */
export function segmented(name, choices, current, choose) {
  const buttons = choices.map(([value, label, title]) => button(label, title, () => choose(value)));
  const group = make('div', { class: 'segmented', role: 'group', 'aria-label': name }, ...buttons);
  group.update = () => {
    buttons.forEach((each, i) => setAll(each, { 'aria-pressed': choices[i][0] === current() }));
  };
  group.update();
  return group;
}

export function download(name, text, type = 'text/plain') {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = make('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

/** Ask for a file and `take` it, {name, file, text}, the text only of text; `say` hears what is wrong with it. */
export async function takeFile(accept, say, take) {
  const chosen = await askForFile(accept);
  try {
    if (chosen) await take(chosen);
  } catch (error) {
    say(/** @type {Error} */ (error).message);
  }
}

function askForFile(accept) {
  return new Promise((resolve) => {
    const input = make('input', { type: 'file', accept });
    input.addEventListener('change', async () => {
      const file = input.files[0];
      resolve(file ? { name: file.name, file, text: accept.startsWith('audio') ? '' : await file.text() } : null);
    });
    input.addEventListener('cancel', () => resolve(null));
    input.click();
  });
}

/** A value for people: two decimals, or more where the range is small. */
export function shownValue(value, range = 1) {
  const digits = clamp(2 - Math.floor(Math.log10(Math.max(range, 1e-6))), 2, 6);
  return value.toFixed(digits);
}

export const SNAP = 32; // pixels of the page: canvases begin and end at multiples
const ROOMY = 2; // times what is needed: a larger canvas shrinks

/**
 * A box [left, top, right, bottom] for a canvas that covers `reach` within a view of `size`: the present one, where it does well.
 * @param {number[]} reach @param {number[] | null} box @param {number[]} size
 */
export function covering(reach, box, size) {
  const low = (value) => SNAP * Math.floor(Math.max(0, value) / SNAP);
  const high = (value, most) => Math.min(most, SNAP * Math.ceil(value / SNAP));
  const need = [low(reach[0]), low(reach[1]), high(reach[2], size[0]), high(reach[3], size[1])];
  if (!(need[0] < need[2] && need[1] < need[3])) return box ?? [0, 0, 1, 1];
  const fits = box && need[0] >= box[0] && need[1] >= box[1] && need[2] <= box[2] && need[3] <= box[3];
  return fits && area(box) <= ROOMY * area(need) ? box : need;
}

/** @param {number[]} box */
const area = ([left, top, right, bottom]) => (right - left) * (bottom - top);

/**
 * Put a canvas where its box says.
 * @param {HTMLCanvasElement} canvas @param {number[]} box
 */
export function placed(canvas, [left, top, right, bottom]) {
  Object.assign(canvas.style, { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` });
}
