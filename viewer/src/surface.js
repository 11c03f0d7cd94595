// The drawn surface: triangles of all visible meshes over the character's points, and their normals.

import { cross } from './camera.js';
import { dot, known } from './vectors.js';

/** Triangles (3 indices each, into all points) of the visible meshes. */
export function visibleTriangles(character) {
  const shown = character.meshes.filter((mesh) => mesh.visible);
  const out = new Uint32Array(shown.reduce((sum, mesh) => sum + mesh.triangles.length, 0));
  let at = 0;
  for (const mesh of shown) {
    for (const corner of mesh.triangles) out[at++] = mesh.start + corner;
  }
  return out;
}

/**
 * Where the texture of a character lies on its visible triangles, null where it has none.  `corners` has a vertex for
 * each of their corners: the points, and after all of them the `doubles` of points at which the texture is cut.
 * `places` (2 per vertex, from the left and from above, 0 to 1) are negative off the texture; `on` tells so per triangle.
 */
export function texturing({ meshes, texture, pointCount }) {
  if (!texture || !meshes.some((mesh) => mesh.texture)) return null;
  const places = new Array(2 * pointCount).fill(NaN);
  /** @type {number[][]} */
  const [doubles, corners, on] = [[], [], []];
  const vertices = new Map();
  const vertexAt = (point, x, y) => {
    if (Number.isNaN(places[2 * point])) [places[2 * point], places[2 * point + 1]] = [x, y];
    if (places[2 * point] === x && places[2 * point + 1] === y) return point;
    const key = `${point} ${x} ${y}`;
    return known(vertices, key, () => {
      doubles.push(point);
      places.push(x, y);
      return pointCount + doubles.length - 1;
    });
  };
  for (const { start, triangles, visible, texture: own } of meshes) {
    if (!visible) continue;
    const count = triangles.length / 3;
    triangles.forEach((point, c) => {
      const t = Math.floor(c / 3);
      const image = own ? own.images[t] : -1;
      if (c % 3 === 0) on.push(image < 0 ? 0 : 1);
      if (image < 0) corners.push(vertexAt(start + point, -1, -1));
      else {
        const [left, top, wide, high] = texture.boxes[image];
        const [u, v] = [0, 3 * count].map((from) => own.uv[from + (c % 3) * count + t] / 65535);
        corners.push(vertexAt(start + point, (left + 0.5 + u * (wide - 1)) / texture.width, (top + 0.5 + (1 - v) * (high - 1)) / texture.height));
      }
    });
  }
  return { ...texture, corners: Uint32Array.from(corners), doubles, places: Float32Array.from(places), on: Uint8Array.from(on) };
}

/** An array of some numbers per point with those of its doubles after them. */
export function doubled(array, size, doubles, out = new array.constructor(array.length + size * doubles.length)) {
  if (out === array) return out;
  out.set(array);
  doubles.forEach((point, k) => {
    for (let i = 0; i < size; i++) out[array.length + size * k + i] = array[size * point + i];
  });
  return out;
}

/** Colours (3 per point, 0 to 1) of all points, and where they lie on eyeballs (2 per point; see eye.js). */
export function looks(character) {
  const colours = new Float32Array(3 * character.pointCount);
  const gaze = new Float32Array(2 * character.pointCount).fill(9);
  for (const mesh of character.meshes) {
    mesh.colours.forEach((value, i) => (colours[3 * mesh.start + i] = value / 255));
    if (mesh.gaze) gaze.set(mesh.gaze, 2 * mesh.start);
  }
  return { colours, gaze };
}

/**
 * Points that coincide at rest and lie on open edges, as a list of lists: a surface cut along a texture
 * seam, whose normals must be shared.  Points inside a surface are left alone, so that closed lips that
 * happen to touch keep their two normals.
 */
export function seams(character, triangles) {
  const open = openPoints(triangles, character.pointCount);
  const groups = new Map();
  for (const mesh of character.meshes) {
    for (let local = 0; local < mesh.count; local++) {
      if (!open[mesh.start + local]) continue;
      const key = `${mesh.path} ${mesh.points.subarray(3 * local, 3 * local + 3).join()}`;
      known(groups, key, () => []).push(mesh.start + local);
    }
  }
  return [...groups.values()].filter((group) => group.length > 1);
}

function openPoints(triangles, count) {
  const open = new Uint8Array(count);
  for (const key of openEdges(triangles, count)) open[Math.floor(key / count)] = open[key % count] = 1;
  return open;
}

/** Edges that one triangle alone has, by the key `lower index * count + higher index`. */
function openEdges(triangles, count) {
  const uses = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      add(uses, Math.min(a, b) * count + Math.max(a, b));
    }
  }
  return [...uses].filter(([, used]) => used === 1).map(([key]) => key);
}

const add = (sums, key, by = 1) => sums.set(key, (sums.get(key) ?? 0) + by);

/** Area-weighted normals, not of unit length (the shader normalises), into `normals`. */
export function sumNormals(points, triangles, welded, normals) {
  normals.fill(0);
  addCrossProducts(points, triangles, normals);
  share(welded, normals);
}

/** Apart from what follows, for engines optimise a long loop well where its function ends with it. */
function addCrossProducts(points, triangles, normals) {
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const ux = points[b] - points[a];
    const uy = points[b + 1] - points[a + 1];
    const uz = points[b + 2] - points[a + 2];
    const vx = points[c] - points[a];
    const vy = points[c + 1] - points[a + 1];
    const vz = points[c + 2] - points[a + 2];
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    normals[a] += nx;
    normals[a + 1] += ny;
    normals[a + 2] += nz;
    normals[b] += nx;
    normals[b + 1] += ny;
    normals[b + 2] += nz;
    normals[c] += nx;
    normals[c + 1] += ny;
    normals[c + 2] += nz;
  }
}

/** Give all points of a group their sum. */
function share(welded, normals) {
  for (const group of welded) {
    for (let axis = 0; axis < 3; axis++) {
      let sum = 0;
      for (const point of group) sum += normals[3 * point + axis];
      for (const point of group) normals[3 * point + axis] = sum;
    }
  }
}

/**
 * Per triangle, which side of it is the outside: 1 or -1 where its connected part of the surface is closed
 * but for a few holes (eyes, neck), 0 for open parts such as cards, which are seen from both sides.
 */
export function facings(points, triangles) {
  const part = parts(triangles, points.length / 3);
  const size = new Map();
  const volume = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    const key = part[triangles[t]];
    add(size, key);
    add(volume, key, signedVolume(points, triangles, t, 3 * key));
  }
  const rim = rimLengths(triangles, part, points.length / 3);
  const out = new Int8Array(triangles.length / 3);
  for (let t = 0; t < out.length; t++) {
    const key = part[triangles[3 * t]];
    const closed = (rim.get(key) ?? 0) < 0.08 * size.get(key);
    out[t] = closed ? Math.sign(volume.get(key)) : 0;
  }
  return out;
}

/** A representative point of the connected part that each point belongs to. */
function parts(triangles, count) {
  const parent = Uint32Array.from({ length: count }, (_, i) => i);
  const root = (i) => {
    while (parent[i] !== i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (let t = 0; t < triangles.length; t += 3) {
    parent[root(triangles[t + 1])] = root(triangles[t]);
    parent[root(triangles[t + 2])] = root(triangles[t]);
  }
  return parent.map((_, i) => root(i));
}

/** Six times the volume between a triangle and the point at `from`. */
function signedVolume(points, triangles, t, from) {
  const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => points[3 * triangles[t + k] + axis] - points[from + axis]));
  return dot(a, cross(b, c));
}

/** Number of open edges of each part. */
function rimLengths(triangles, part, count) {
  const rims = new Map();
  for (const key of openEdges(triangles, count)) add(rims, part[key % count]);
  return rims;
}

/**
 * Write into `seen` the triangles that face the camera (or have two sides) and are not wholly outside a
 * picture `wide` times as wide as high, by the vertices at their `corners`; returns how many indices were written.
 */
export function seenTriangles(points, triangles, facing, camera, wide, seen, corners = triangles) {
  const eye = camera.position;
  const outside = outsides(points, camera, eye, wide);
  let count = 0;
  for (let t = 0, k = 0; t < triangles.length; t += 3, k++) {
    const [i, j, l] = [triangles[t], triangles[t + 1], triangles[t + 2]];
    if (outside[i] & outside[j] & outside[l]) continue;
    if (facing[k] !== 0 && facing[k] * towardsEye(points, 3 * i, 3 * j, 3 * l, eye) <= 0) continue;
    seen[count++] = corners[t];
    seen[count++] = corners[t + 1];
    seen[count++] = corners[t + 2];
  }
  return count;
}

function towardsEye(points, a, b, c, eye) {
  const ax = points[a];
  const ay = points[a + 1];
  const az = points[a + 2];
  const ux = points[b] - ax;
  const uy = points[b + 1] - ay;
  const uz = points[b + 2] - az;
  const vx = points[c] - ax;
  const vy = points[c + 1] - ay;
  const vz = points[c + 2] - az;
  return (
    (uy * vz - uz * vy) * (eye[0] - ax) + (uz * vx - ux * vz) * (eye[1] - ay) + (ux * vy - uy * vx) * (eye[2] - az)
  );
}

/** Per point, bits for the sides of the picture beyond which it lies. */
function outsides(points, { right, above, towards, half }, eye, wide) {
  const out = new Uint8Array(points.length / 3);
  for (let k = 0, i = 0; k < out.length; k++, i += 3) {
    const x = points[i] - eye[0];
    const y = points[i + 1] - eye[1];
    const z = points[i + 2] - eye[2];
    const depth = -(x * towards[0] + y * towards[1] + z * towards[2]);
    const across = x * right[0] + y * right[1] + z * right[2];
    const upward = x * above[0] + y * above[1] + z * above[2];
    const [edge, top] = [depth * half * wide, depth * half];
    out[k] = (across > edge ? 1 : 0) | (across < -edge ? 2 : 0) | (upward > top ? 4 : 0) | (upward < -top ? 8 : 0) | (depth <= 0 ? 16 : 0);
  }
  return out;
}
