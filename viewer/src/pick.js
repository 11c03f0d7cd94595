// What lies under the pointer: the triangle of the skin at a pixel, and whether the skin hides a point.
// Both work on the points projected to the screen, which is renewed only when pose or camera change.

const CELL = 3; // pixels per cell of the depth grid

export class ScreenSurface {
  constructor(points, triangles) {
    this.points = points;
    this.triangles = triangles;
    this.screen = new Float32Array(points.length); // x, y in pixels; depth in scene units
    this.invalidate();
  }

  /** Forget the projection: pose, camera or column have changed. */
  invalidate() {
    this.column = null;
    this.depths = null;
  }

  project(camera, column) {
    if (this.column === column) return;
    const { points, screen } = this;
    const eye = camera.position;
    const { right, above, towards, half } = camera;
    const focal = column.height / (2 * half);
    const cx = column.left + column.width / 2;
    const cy = column.top + column.height / 2;
    for (let i = 0; i < points.length; i += 3) {
      const x = points[i] - eye[0];
      const y = points[i + 1] - eye[1];
      const z = points[i + 2] - eye[2];
      const depth = -(x * towards[0] + y * towards[1] + z * towards[2]);
      const scale = depth > 1e-9 ? focal / depth : NaN;
      screen[i] = cx + (x * right[0] + y * right[1] + z * right[2]) * scale;
      screen[i + 1] = cy - (x * above[0] + y * above[1] + z * above[2]) * scale;
      screen[i + 2] = depth;
    }
    this.column = column;
    this.depths = null;
  }

  /** Nearest triangle at (x, y): {corners, shares, depth, nearest}, or null. */
  pick(camera, column, x, y) {
    this.project(camera, column);
    const { screen, triangles } = this;
    let best = null;
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t];
      const b = 3 * triangles[t + 1];
      const c = 3 * triangles[t + 2];
      const ax = screen[a] - x;
      const bx = screen[b] - x;
      const cx = screen[c] - x;
      if ((ax > 0 && bx > 0 && cx > 0) || (ax < 0 && bx < 0 && cx < 0)) continue;
      const ay = screen[a + 1] - y;
      const by = screen[b + 1] - y;
      const cy = screen[c + 1] - y;
      const wa = bx * cy - by * cx;
      const wb = cx * ay - cy * ax;
      const wc = ax * by - ay * bx;
      if (!((wa >= 0 && wb >= 0 && wc >= 0) || (wa <= 0 && wb <= 0 && wc <= 0))) continue;
      const area = wa + wb + wc;
      if (area === 0) continue;
      const depth = area / (wa / screen[a + 2] + wb / screen[b + 2] + wc / screen[c + 2]);
      if (best === null || depth < best.depth) best = { triangle: t, depth, on: [wa / area, wb / area, wc / area] };
    }
    return best && this.hit(best);
  }

  /** Corners and perspective-correct shares of a picked triangle. */
  hit({ triangle, depth, on }) {
    const corners = Array.from(this.triangles.subarray(triangle, triangle + 3));
    const shares = on.map((share, k) => (share * depth) / this.screen[3 * corners[k] + 2]);
    const nearest = corners[shares.indexOf(Math.max(...shares))];
    return { corners, shares, depth, nearest };
  }

  /** Depth of the skin over a coarse grid of the column: a plain rasteriser, one sample per cell. */
  depthGrid(camera, column) {
    this.project(camera, column);
    if (this.depths) return this.depths;
    const wide = Math.ceil(column.width / CELL) + 1;
    const high = Math.ceil(column.height / CELL) + 1;
    const grid = new Float32Array(wide * high).fill(Infinity);
    const { screen, triangles } = this;
    for (let t = 0; t < triangles.length; t += 3) {
      rasterise(grid, wide, high, screen, 3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2], column);
    }
    this.depths = { grid, wide, high };
    return this.depths;
  }

  /** True when the skin lies more than `bias` in front of a projected point [x, y, depth]. */
  hides(camera, column, [x, y, depth], bias) {
    const { grid, wide, high } = this.depthGrid(camera, column);
    const i = Math.round((x - column.left) / CELL);
    const j = Math.round((y - column.top) / CELL);
    if (i < 0 || j < 0 || i >= wide || j >= high) return false;
    return grid[j * wide + i] < depth - bias;
  }
}

function rasterise(grid, wide, high, screen, a, b, c, column) {
  const ax = (screen[a] - column.left) / CELL;
  const ay = (screen[a + 1] - column.top) / CELL;
  const bx = (screen[b] - column.left) / CELL;
  const by = (screen[b + 1] - column.top) / CELL;
  const cx = (screen[c] - column.left) / CELL;
  const cy = (screen[c + 1] - column.top) / CELL;
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (!(Math.abs(area) > 1e-9)) return;
  const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx)));
  const right = Math.min(wide - 1, Math.floor(Math.max(ax, bx, cx)));
  const top = Math.max(0, Math.ceil(Math.min(ay, by, cy)));
  const bottom = Math.min(high - 1, Math.floor(Math.max(ay, by, cy)));
  for (let j = top; j <= bottom; j++) {
    for (let i = left; i <= right; i++) {
      const wa = ((bx - i) * (cy - j) - (by - j) * (cx - i)) / area;
      const wb = ((cx - i) * (ay - j) - (cy - j) * (ax - i)) / area;
      const wc = 1 - wa - wb;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const depth = wa * screen[a + 2] + wb * screen[b + 2] + wc * screen[c + 2];
      const at = j * wide + i;
      if (depth < grid[at]) grid[at] = depth;
    }
  }
}
