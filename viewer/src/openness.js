// How open every point is to the light of the sky: soft shade in folds, dark inside the mouth.  Worked out once, at
// rest: parallel views from all around, each with a depth buffer, and per point the share of them that see it.

const VIEWS = 40;
const CELLS = 192; // across each view
const BIAS = 2.5; // cells of depth within which a point counts as seen
const LEAST = 0.16; // of the light reaches what nothing sees

/** 0 to 1 per point, of those the `triangles` use. */
export function openness(points, normals, triangles) {
  const count = points.length / 3;
  const [seen, all] = [new Float32Array(count), new Float32Array(count)];
  const { middle, radius } = bounds(points, triangles);
  const used = new Uint8Array(count);
  for (const point of triangles) used[point] = 1;
  const flat = new Float32Array(points.length);
  for (let view = 0; view < VIEWS; view++) {
    const axes = frameOf(direction(view));
    flatten(points, middle, axes, CELLS / (2 * radius), flat);
    const depths = new Float32Array(CELLS * CELLS).fill(-Infinity);
    for (let t = 0; t < triangles.length; t += 3) fill(depths, flat, 3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]);
    look({ depths, flat, normals, used, towards: axes[2] }, seen, all);
  }
  return spread(seen.map((value, i) => LEAST + (1 - LEAST) * (all[i] > 0 ? value / all[i] : 1)), triangles);
}

/**
 * Evenly spread directions: points of a Fibonacci lattice on the sphere.
 * @returns {[number, number, number]}
 */
function direction(k) {
  const y = 1 - (2 * k + 1) / VIEWS;
  const [across, angle] = [Math.sqrt(1 - y * y), k * Math.PI * (3 - Math.sqrt(5))];
  return [across * Math.cos(angle), y, across * Math.sin(angle)];
}

/** Unit vectors to the right, up and to the viewer. */
function frameOf([x, y, z]) {
  const length = Math.hypot(z, x) || 1;
  const right = Math.abs(y) > 0.999 ? [1, 0, 0] : [z / length, 0, -x / length];
  const up = [y * right[2] - z * right[1], z * right[0] - x * right[2], x * right[1] - y * right[0]];
  return [right, up, [x, y, z]];
}

function bounds(points, triangles) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const point of triangles) {
    for (let axis = 0; axis < 3; axis++) {
      const value = points[3 * point + axis];
      if (value < low[axis]) low[axis] = value;
      if (value > high[axis]) high[axis] = value;
    }
  }
  const middle = low.map((value, axis) => 0.5 * (value + high[axis]));
  return { middle, radius: 0.505 * Math.hypot(...high.map((value, axis) => value - low[axis])) || 1 };
}

/** Column, row and depth toward the viewer of every point, in cells. */
function flatten(points, middle, axes, scale, out) {
  const [mx, my, mz] = middle;
  const [r, u, d] = axes;
  const [rx, ry, rz] = r;
  const [ux, uy, uz] = u;
  const [dx, dy, dz] = d;
  for (let i = 0; i < points.length; i += 3) {
    const x = points[i] - mx;
    const y = points[i + 1] - my;
    const z = points[i + 2] - mz;
    out[i] = CELLS / 2 + scale * (x * rx + y * ry + z * rz);
    out[i + 1] = CELLS / 2 + scale * (x * ux + y * uy + z * uz);
    out[i + 2] = scale * (x * dx + y * dy + z * dz);
  }
}

function fill(depths, flat, a, b, c) {
  const ax = flat[a];
  const ay = flat[a + 1];
  const ux = flat[b] - ax;
  const uy = flat[b + 1] - ay;
  const vx = flat[c] - ax;
  const vy = flat[c + 1] - ay;
  const area = ux * vy - uy * vx;
  if (Math.abs(area) < 1e-9) return;
  const left = Math.ceil(ax + Math.min(0, ux, vx) - 0.5);
  const right = Math.floor(ax + Math.max(0, ux, vx) - 0.5);
  const low = Math.ceil(ay + Math.min(0, uy, vy) - 0.5);
  const high = Math.floor(ay + Math.max(0, uy, vy) - 0.5);
  const near = flat[a + 2];
  const nearB = flat[b + 2] - near;
  const nearC = flat[c + 2] - near;
  for (let j = low; j <= high; j++) {
    const y = j + 0.5 - ay;
    for (let i = left; i <= right; i++) {
      const x = i + 0.5 - ax;
      const wb = (x * vy - y * vx) / area;
      const wc = (ux * y - uy * x) / area;
      if (wb < 0 || wc < 0 || wb + wc > 1) continue;
      const depth = near + wb * nearB + wc * nearC;
      if (depth > depths[j * CELLS + i]) depths[j * CELLS + i] = depth;
    }
  }
}

/** Add to `all` how much of a view's light falls on each point, and to `seen` what nothing keeps off. */
function look({ depths, flat, normals, used, towards }, seen, all) {
  const [tx, ty, tz] = towards;
  for (let point = 0, i = 0; point < used.length; point++, i += 3) {
    if (!used[point]) continue;
    const length = Math.sqrt(normals[i] * normals[i] + normals[i + 1] * normals[i + 1] + normals[i + 2] * normals[i + 2]);
    const share = length > 0 ? (normals[i] * tx + normals[i + 1] * ty + normals[i + 2] * tz) / length : 0;
    if (share <= 0.05) continue;
    all[point] += share;
    const cell = Math.floor(flat[i + 1]) * CELLS + Math.floor(flat[i]);
    if (!(depths[cell] > flat[i + 2] + BIAS)) seen[point] += share;
  }
}

/** Each point's value mixed with the mean of its neighbours', which takes away the grain of the cells. */
function spread(values, triangles) {
  for (let round = 0; round < 2; round++) {
    const [sum, count] = [new Float32Array(values.length), new Float32Array(values.length)];
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]];
      const total = values[a] + values[b] + values[c];
      for (const point of [a, b, c]) {
        sum[point] += total - values[point];
        count[point] += 2;
      }
    }
    for (let i = 0; i < values.length; i++) if (count[i]) values[i] = 0.5 * (values[i] + sum[i] / count[i]);
  }
  return values;
}
