// The drawn surface: triangles of all visible meshes over the character's points, and their normals.

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
      if (groups.has(key)) groups.get(key).push(mesh.start + local);
      else groups.set(key, [mesh.start + local]);
    }
  }
  return [...groups.values()].filter((group) => group.length > 1);
}

function openPoints(triangles, count) {
  const uses = new Map();
  const open = new Uint8Array(count);
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [triangles[t + k], triangles[t + ((k + 1) % 3)]];
      const key = Math.min(a, b) * count + Math.max(a, b);
      uses.set(key, (uses.get(key) ?? 0) + 1);
    }
  }
  for (const [key, used] of uses) {
    if (used === 1) open[Math.floor(key / count)] = open[key % count] = 1;
  }
  return open;
}

/** Area-weighted normals, not of unit length (the shader normalises), into `normals`. */
export function sumNormals(points, triangles, welded, normals) {
  normals.fill(0);
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
  for (const group of welded) {
    for (let axis = 0; axis < 3; axis++) {
      let sum = 0;
      for (const point of group) sum += normals[3 * point + axis];
      for (const point of group) normals[3 * point + axis] = sum;
    }
  }
}
