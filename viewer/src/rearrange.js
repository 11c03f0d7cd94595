// Changing the layout by hand: an element is dragged to another point of the skin, or off it to stand
// beside the face; the changes are written as the layer of corrections that `usdrigui process --corrections` reads.

import { minus, scaled } from './camera.js';
import { layerText, number, quoted, tuple } from './usda.js';
import { dot } from './vectors.js';

const HOLDER = '/RigUICorrections/';
const PRIM = { type: 'def Scope', metadata: 'prepend apiSchemas = ["RigUICorrectionAPI"]' };
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
    const clear = () => {
      overlay.placing = null;
      view.changed('overlay');
    };
    return {
      begin: () => session.select([element]),
      drag: (_, __, to) => {
        place = to.column === view.controlsColumn ? view.pick(to) : null;
        const refused = place !== null && !this.holds(element, place.nearest);
        overlay.placing = { from, to: [to.x, to.y], free: !place, refused };
        view.changed('overlay');
      },
      drop: () => {
        clear();
        if (place && !this.holds(element, place.nearest)) view.say(`${element.label} does not move this point: drop it on the coloured area`);
        else if (place) this.moveToSkin(element, place.nearest);
        else this.moveBeside(element);
      },
      undo: clear,
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
    const { meshes, metresPerUnit, up } = this.session.character;
    const at = this.pointsAt(this.session.controls.map((control) => control.default));
    this.moved.set(element.index, [
      'uniform token rigUI:correction:place = "point"',
      said('uniform point3f rigUI:correction:position', tuple(at(point))),
      said('uniform vector3f rigUI:correction:up', tuple(up)),
      said('uniform double rigUI:correction:metersPerUnit', number(metresPerUnit)),
      said('rel rigUI:correction:prim', `<${meshes[mesh].path}>`),
      said('uniform int rigUI:correction:pointIndex', local),
    ]);
  }

  moveBeside(element) {
    this.change(`Move ${element.label} beside the face`, [element], () => {
      this.session.elements.putBeside(element);
      this.moved.set(element.index, ['uniform token rigUI:correction:place = "board"']);
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
    const { character, rest } = this.session;
    const { planeOrigin, planeNormal } = character.layout;
    const at = this.pointsAt(rest);
    const image = minus(at(point), scaled(planeNormal, 2 * dot(minus(at(point), planeOrigin), planeNormal)));
    const { start, count } = character.meshes[this.session.meshOf(point)[0]];
    let best = [Infinity, point];
    for (let other = start; other < start + count; other++) {
      const off = minus(at(other), image);
      if (dot(off, off) < best[0]) best = [dot(off, off), other];
    }
    return best[1];
  }

  /** Every point's position at some values of the controls. */
  pointsAt(rest) {
    const points = this.session.deformer.posedAside(rest);
    return (point) => points.subarray(3 * point, 3 * point + 3);
  }

  /** What was moved as a layer of corrections: a prim for each control of the moved elements. */
  corrections() {
    const { character, controls, elements } = this.session;
    const prims = new Map();
    prims.set(character.root + HOLDER, { type: 'def Scope' });
    for (const [index, lines] of this.moved) {
      for (const { control } of elements.list[index].members) {
        const { name } = controls[control];
        let path = character.root + HOLDER + name.replace(/\W|^(?=\d)/g, '_');
        while (prims.has(path)) path += '_';
        prims.set(path, { ...PRIM, lines: [said('uniform string rigUI:correction:control', quoted(name)), ...lines] });
      }
    }
    return layerText(prims);
  }
}

const said = (property, value) => `${property} = ${value}`;
