// The picture of the skin: three.js draws one geometry per pose into the columns of the canvas.

import * as THREE from 'three';
import { facings, seams, seenTriangles, sumNormals, visibleTriangles } from './surface.js';

// Colours here are what the screen shows; three.js is not to convert them.
THREE.ColorManagement.enabled = false;

const BACKGROUND = 0x1f2124;

// Lambert with two lights that stay with the camera, so that any character reads well however it is
// oriented.  Lit at the points, not at the pixels: on skins of this density it looks the same, and in
// software it takes half the time.  "paint" carries the heat map.
const VERTEX = `
  attribute vec2 paint;
  uniform vec3 skin;
  varying vec3 colour;
  vec3 ramp(float heat) {
    vec3 low = mix(vec3(0.20, 0.24, 0.62), vec3(0.78, 0.20, 0.44), smoothstep(0.0, 0.5, heat));
    return mix(low, vec3(1.0, 0.82, 0.30), smoothstep(0.45, 1.0, heat));
  }
  void main() {
    vec4 at = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * at;
    vec3 n = normalize(normalMatrix * normal);
    n = dot(n, normalize(at.xyz)) > 0.3 ? -n : n; // the inside of an open part
    float key = max(dot(n, vec3(-0.40, 0.52, 0.755)), 0.0);
    float fill = max(dot(n, vec3(0.70, -0.05, 0.71)), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    vec3 base = mix(skin, ramp(paint.x), 0.85 * smoothstep(0.01, 0.2, paint.x));
    vec3 light = vec3(0.20, 0.21, 0.23) * sky + vec3(0.80, 0.77, 0.73) * key + vec3(0.20, 0.22, 0.26) * fill;
    colour = base * sqrt(light) + pow(1.0 - abs(n.z), 3.0) * 0.035;
  }`;

const FRAGMENT = `
  varying vec3 colour;
  void main() {
    gl_FragColor = vec4(colour, 1.0);
  }`;

export class Stage {
  constructor(canvas, character, points) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: false, powerPreference: 'high-performance' });
    this.renderer.setClearColor(BACKGROUND);
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.camera = new THREE.PerspectiveCamera();
    this.triangles = visibleTriangles(character);
    this.welded = seams(character, this.triangles);
    this.facing = facings(points, this.triangles);
    this.size = { width: 1, height: 1 };
    this.skin = this.makeSkin(points, new THREE.Color(0.66, 0.61, 0.57));
    this.target = null;
  }

  makeSkin(points, colour) {
    const geometry = new THREE.BufferGeometry();
    const dynamic = (array, size, normalised = false) =>
      new THREE.BufferAttribute(array, size, normalised).setUsage(THREE.DynamicDrawUsage);
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(this.triangles.length), 1).setUsage(THREE.DynamicDrawUsage));
    geometry.setAttribute('position', dynamic(points, 3));
    geometry.setAttribute('normal', dynamic(new Float32Array(points.length), 3));
    geometry.setAttribute('paint', dynamic(new Uint8Array((4 * points.length) / 3), 4, true));
    const material = new THREE.ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: THREE.DoubleSide,
      uniforms: { skin: { value: colour } },
    });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    const scene = new THREE.Scene();
    scene.matrixWorldAutoUpdate = false;
    scene.add(mesh);
    return { scene, geometry, material };
  }

  /** The points have moved: renew normals and send both to the graphics card. */
  refresh(skin = this.skin) {
    const { position, normal } = skin.geometry.attributes;
    sumNormals(position.array, this.triangles, this.welded, normal.array);
    position.needsUpdate = true;
    normal.needsUpdate = true;
  }

  /** Paint heat and tint (0 to 1 per point, or null) on the skin. */
  paint(heat, tint) {
    const { paint } = this.skin.geometry.attributes;
    for (let point = 0, at = 0; at < paint.array.length; point++, at += 4) {
      paint.array[at] = heat ? heat[point] : 0;
      paint.array[at + 1] = tint ? tint[point] : 0;
    }
    paint.needsUpdate = true;
  }

  /** Show a second, unmoving face with these points; null takes it away. */
  setTarget(points) {
    this.target?.geometry.dispose();
    this.target?.material.dispose();
    this.target = points && this.makeSkin(points, new THREE.Color(0.52, 0.6, 0.66));
    if (this.target) this.refresh(this.target);
  }

  resize(width, height, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.size = { width, height };
  }

  /** Leave to the graphics card only the triangles that can be seen from here. */
  cull(columns, orbit) {
    const wide = Math.max(...columns.map(({ width, height }) => width / height));
    for (const skin of [this.skin, this.target]) {
      if (!skin || !columns.some(({ kind }) => (kind === 'target') === (skin === this.target))) continue;
      const { index, attributes } = skin.geometry;
      const count = seenTriangles(attributes.position.array, this.triangles, this.facing, orbit, wide, index.array);
      index.clearUpdateRanges();
      index.addUpdateRange(0, count);
      index.needsUpdate = true;
      skin.geometry.setDrawRange(0, count);
    }
  }

  draw(columns, orbit) {
    const { renderer, camera, size } = this;
    renderer.setScissorTest(true);
    camera.fov = orbit.fieldDegrees;
    camera.near = Math.max(orbit.distance - 6 * orbit.size, 0.01 * orbit.distance);
    camera.far = orbit.distance + 60 * orbit.size;
    camera.position.set(...orbit.position);
    camera.up.set(...orbit.up);
    camera.lookAt(...orbit.target);
    camera.updateMatrixWorld();
    this.cull(columns, orbit);
    for (const column of columns) {
      const skin = column.kind === 'target' ? this.target : this.skin;
      const bottom = size.height - column.top - column.height;
      renderer.setViewport(column.left, bottom, column.width, column.height);
      renderer.setScissor(column.left, bottom, column.width, column.height);
      camera.aspect = column.width / column.height;
      camera.updateProjectionMatrix();
      renderer.clear();
      if (skin) renderer.render(skin.scene, camera);
    }
  }
}
