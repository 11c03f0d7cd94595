// The page as a reader of layouts, of a layer that usdrigui has packed: {scene, questions} on standard input, answers out.

import { text } from 'node:stream/consumers';

import { beginDrag, dragTo } from '../../viewer/src/drag.js';
import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';

const { scene, questions } = JSON.parse(await text(process.stdin));
const session = scene && new Session((await readScene(scene)).characters[0]);
const asked = { layout, pose, drag, findings: () => null };

function layout() {
  return Object.fromEntries(session.elements.list.map((each) => {
    const names = each.members.map(({ control }) => session.controls[control].name);
    const axes = each.axes.map((axis) => axis.map((member) => names[member]));
    const values = each.members.map((member) => member.values);
    return [each.name, { type: each.kind, axes, mirror: each.mirror, side: each.side, members: each.inner, onBoard: each.onBoard, values }];
  }));
}

function pose({ values }) {
  const at = Float64Array.from(session.controls, ({ name }, i) => values[name] ?? session.rest[i]);
  session.deformer.setBase(null, null);
  session.elements.follow(at);
  return Object.fromEntries(session.elements.list.map(({ name, handle, tracks }) => [name, { handle, tracks }]));
}

function drag({ tracks, values, axes, minimum, default: off, maximum, base, start, moves }) {
  const members = values.map((each, control) => ({ control, values: each }));
  const controls = members.map((_, i) => ({ minimum: minimum[i], default: off[i], maximum: maximum[i] }));
  const held = beginDrag({ members, tracks, axes }, controls, base, start, (point) => point);
  return moves.map((move) => {
    const changed = dragTo(held, ...move);
    return start.map((value, i) => changed.get(i) ?? value);
  });
}

process.stdout.write(JSON.stringify(questions.map((each) => asked[each.ask](each))));
