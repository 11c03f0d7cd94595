// Motion trails: the ways of the selected handles on the face through the frames that play, and their keys there.

import { alike, ascending } from './vectors.js';

const MOST = 16; // elements that have a trail
const MOST_PLACES = 600; // of all trails: where there are more, every second frame, or third, has one

export class Trails {
  /** @type {any[]} */ ways = []; // {element, places: [{frame, isKey, handle, origin}]}, root space
  /** @type {any[]} */ made = []; // what they were made of

  /** `timeline` says which frames play. */
  constructor(session, view, timeline) {
    this.session = session;
    this.view = view;
    this.timeline = timeline;
    view.trails = this;
    for (const event of ['time', 'picked']) session.on(event, () => session.options.trails && view.changed('overlay'));
    session.on('layout', () => (this.made = []));
  }

  /** What is drawn: {colour, places: [{frame, isKey, at: [x, y, depth]}]} per trail; nothing in a trial. */
  shown() {
    const { session, view } = this;
    if (!session.options.trails || session.trial || !view.controlsColumn) return [];
    this.renew();
    const project = view.camera.projector(view.controlsColumn);
    return this.ways.map(({ element, places }) => ({
      colour: session.colours[element.side],
      places: places.map(({ handle, origin, ...place }) => ({ ...place, at: view.overlay.mapOf(element, project, origin)(handle) })),
    }));
  }

  /** Trails of other elements, keys or frames; what a drag changes comes when it is over. */
  renew() {
    const { session } = this;
    const elements = session.selectedElements.filter((element) => !element.onBoard && session.isShown(element)).slice(0, MOST);
    if (session.dragging && alike(elements, this.ways.map(({ element }) => element))) return;
    const [first, last] = this.timeline.played;
    const made = [...elements, session.keys, [...session.allConstants()].join(), first, last, session.options.follow];
    if (alike(made, this.made)) return;
    this.made = made;
    this.ways = this.placed(elements, first, last);
  }

  placed(elements, first, last) {
    const { session } = this;
    const keyed = elements.map(({ members }) => new Set(members.flatMap(({ control }) => (session.keys.get(control) ?? []).map(([frame]) => frame))));
    const step = Math.ceil(((last - first + 1) * elements.length) / MOST_PLACES) || 1;
    const whole = Array.from({ length: Math.floor((last - first) / step) + 1 }, (_, i) => first + i * step);
    const keys = keyed.flatMap((frames) => [...frames]).filter((frame) => frame >= first && frame <= last);
    const follow = (values) => session.elements.follow(values, !session.options.follow, elements);
    const rows = ascending([...whole, ...keys, last]).map((frame) => session.atFrame(frame, (values) => {
      follow(values);
      return elements.map(({ handle, origin }, k) => ({ frame, isKey: keyed[k].has(frame), handle, origin }));
    }));
    follow(session.values);
    return elements.map((element, k) => ({ element, places: rows.map((row) => row[k]) }));
  }
}
