// Changing the layout by hand: an element is dragged to another point of the skin, or off it to stand
// beside the face; the changes are written as the partial layout that `usdrigui process --config` reads.

import { minus } from './camera.js';

const LEAST_HEAT = 3; // of 255: what a control must move a point at which its element may stand

export class Rearranging {
  constructor(view) {
    this.view = view;
    this.session = view.session;
    this.moved = view.session.moved;
  }

  /** A gesture that moves `element`. */
  gesture(element) {
    const { view, session } = this;
    const { overlay } = view;
    const from = overlay.drawn.find((each) => each.element === element).handle;
    let place = null;
    return {
      begin: () => session.select([element]),
      drag: (_, __, to) => {
        place = to.column === view.controlsColumn ? view.pick(to) : null;
        const refused = place !== null && !this.holds(element, place.nearest);
        overlay.placing = { from, to: [to.x, to.y], free: !place, refused };
        view.changed('overlay');
      },
      drop: (to) => {
        overlay.placing = null;
        view.changed('overlay');
        if (place && !this.holds(element, place.nearest)) view.say?.(`${element.label} does not move this point: drop it on the coloured area`);
        else if (place) this.moveToSkin(element, place.nearest);
        else this.moveBeside(element, to);
      },
      undo: () => {
        overlay.placing = null;
        view.changed('overlay');
      },
    };
  }

  /** Whether every control of an element moves a point, so that the element can stand there. */
  holds(element, point) {
    return element.members.every(({ control }) => this.session.influence.ofControl(control)[point] >= LEAST_HEAT);
  }

  moveToSkin(element, point) {
    const mirror = this.session.options.symmetric ? this.mirrorOf(element) : null;
    const partner = mirror && this.partnerOf(point);
    this.change(`Move ${element.label}`, [element, mirror].filter(Boolean), () => {
      this.anchor(element, point);
      if (mirror) this.anchor(mirror, partner);
    });
  }

  anchor(element, point) {
    const [mesh, local] = this.session.meshOf(point);
    this.session.elements.reanchor(element, mesh, local, this.session.character.layout.leastTrack);
    const path = this.session.character.meshes[mesh].path;
    this.moved.set(element.index, { anchor: `${path}#${local}` });
  }

  moveBeside(element, to) {
    const { camera } = this.view;
    const column = to.column ?? this.view.controlsColumn;
    const start = camera.projector(column)(element.handle);
    const offset = minus(camera.unproject(column, to.x, to.y, start[2]), element.handle);
    this.change(`Move ${element.label} beside the face`, [element], () => {
      this.session.elements.putBeside(element, offset);
      this.moved.set(element.index, { place: 'board' });
    });
  }

  /** Do a change of placements as one undoable step. */
  change(label, elements, act) {
    const { session } = this;
    const state = () => elements.map((each) => [each, session.elements.placement(each), this.moved.get(each.index)]);
    const restore = (saved) => {
      for (const [element, placement, entry] of saved) {
        session.elements.restore(element, placement);
        if (entry) this.moved.set(element.index, entry);
        else this.moved.delete(element.index);
      }
      session.relayout();
    };
    const before = state();
    act();
    const after = state();
    session.history.push(label, () => restore(before), () => restore(after));
    session.relayout();
  }

  mirrorOf(element) {
    const found = this.session.elements.list.find((other) => other.name === element.mirror);
    return found && found !== element ? found : null;
  }

  /** The point nearest to the mirror image of a point, at rest, on the same mesh. */
  partnerOf(point) {
    const { character, deformer, values, rest } = this.session;
    const { planeOrigin, planeNormal } = character.layout;
    const points = Float32Array.from(deformer.pose(rest));
    deformer.pose(values);
    const at = Array.from(points.subarray(3 * point, 3 * point + 3));
    const away = at.reduce((sum, value, axis) => sum + (value - planeOrigin[axis]) * planeNormal[axis], 0);
    const image = at.map((value, axis) => value - 2 * away * planeNormal[axis]);
    const mesh = character.meshes[this.session.meshOf(point)[0]];
    let best = [Infinity, point];
    for (let other = mesh.start; other < mesh.start + mesh.count; other++) {
      const off = [0, 1, 2].reduce((sum, axis) => sum + (points[3 * other + axis] - image[axis]) ** 2, 0);
      if (off < best[0]) best = [off, other];
    }
    return best[1];
  }

  /** The partial layout as TOML: one table for each control of the moved elements. */
  toml() {
    const lines = [
      '# Partial layout. Add these tables to CHAR.rigui.toml beside the character; a table that is there',
      '# already gets the line. Without such a file: usdrigui process CHAR --config THIS_FILE',
      '',
    ];
    const tables = [];
    for (const [index, entry] of this.moved) {
      for (const { control } of this.session.elements.list[index].members) {
        const [key, value] = Object.entries(entry)[0];
        const name = this.session.controls[control].name;
        tables.push({ name, text: `[controls.${quoted(name)}]\n${key} = ${quoted(value)}\n` });
      }
    }
    tables.sort((a, b) => (a.name < b.name ? -1 : 1));
    return lines.concat(tables.map(({ text }) => text)).join('\n');
  }
}

/** A TOML basic string: JSON's escapes are a subset of TOML's. */
const quoted = (text) => JSON.stringify(text).replaceAll('\u007f', '\\u007F');
