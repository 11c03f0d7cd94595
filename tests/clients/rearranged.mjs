// What the viewer's Save corrections writes, without a browser: JSON {scene, control, mesh, point} on standard input, an element to
// be moved to a point; out comes the layer.

import { text } from 'node:stream/consumers';

import { Rearranging } from '../../viewer/src/rearrange.js';
import { readScene } from '../../viewer/src/scene.js';
import { Session } from '../../viewer/src/session.js';

const { scene, control, mesh, point } = JSON.parse(await text(process.stdin));
const session = new Session((await readScene(scene)).characters[0]);
const rearranging = new Rearranging({ session });
const element = session.elements.list.find((each) => each.members.some((one) => session.controls[one.control].name === control));
rearranging.moveToSkin(element, session.character.meshes.find((each) => each.path === mesh).start + point);
process.stdout.write(rearranging.corrections());
