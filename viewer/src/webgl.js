// The skin drawn by the graphics card: three.js draws one geometry per pose into the columns of a canvas.

import * as THREE from 'three';
import { doubled, seenTriangles } from './surface.js';

// Colours here are what the screen shows; three.js is not to convert them.
THREE.ColorManagement.enabled = false;

const BACKGROUND = 0x1f2124;

// Lambert with two lights that stay with the camera, so that any character reads well however it is
// oriented.  Lit at the points, not at the pixels: on skins of this density it looks the same.  "paint"
// carries the heat map.  painter.js has the same light.
const VERTEX = `
  attribute vec2 paint;
  attribute vec3 own;
  attribute vec2 gaze;
  attribute vec2 place;
  varying vec3 colour;
  varying vec2 ball;
  varying vec3 on;
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
    float heat = 0.85 * smoothstep(0.01, 0.2, paint.x);
    vec3 base = mix(own, ramp(paint.x), heat);
    vec3 light = vec3(0.20, 0.21, 0.23) * sky + vec3(0.80, 0.77, 0.73) * key + vec3(0.20, 0.22, 0.26) * fill;
    colour = base * sqrt(light) + pow(1.0 - abs(n.z), 3.0) * 0.035;
    ball = gaze;
    on = vec3(place, heat);
  }`;

const FRAGMENT = `
  uniform sampler2D tints;
  uniform float perRadius;
  varying vec3 colour;
  varying vec2 ball;
  varying vec3 on;
  #ifdef TEXTURED
  uniform sampler2D skin;
  #endif
  void main() {
    vec3 tint = max(abs(ball.x), abs(ball.y)) < 3.0 ? texture2D(tints, vec2(length(ball) * perRadius, 0.5)).rgb : vec3(1.0);
    #ifdef TEXTURED
    if (on.x >= 0.0) {
      vec4 texel = texture2D(skin, on.xy);
      if (texel.a < 0.5) discard;
      tint = mix(texel.rgb, vec3(1.0), on.z);
    }
    #endif
    gl_FragColor = vec4(colour * tint, 1.0);
  }`;

const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** A WebGL context of a canvas, or null: where there is none, or one in software unless `anyKind`. */
export function webglOf(canvas, anyKind) {
  const wanted = { antialias: false, powerPreference: 'high-performance', failIfMajorPerformanceCaveat: !anyKind };
  const context = canvas.getContext('webgl2', wanted);
  if (!context || anyKind || !SOFTWARE.test(cardOf(context))) return context;
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return null;
}

/** What draws; some browsers name it only by an extension. */
function cardOf(context) {
  const name = context.getParameter(context.RENDERER);
  const more = name === 'WebKit WebGL' && context.getExtension('WEBGL_debug_renderer_info');
  return more ? context.getParameter(more.UNMASKED_RENDERER_WEBGL) : name;
}

export class Webgl {
  constructor(canvas, surface, context) {
    this.canvas = canvas;
    this.surface = surface;
    this.renderer = new THREE.WebGLRenderer({ canvas, context });
    this.renderer.setClearColor(BACKGROUND);
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.camera = new THREE.PerspectiveCamera();
    this.size = { width: 1, height: 1 };
    this.tints = textureOf(surface.tints);
    this.skinTexture = surface.texturing && smoothTexture(surface.texturing);
    this.known = new Map(); // skin -> {scene, geometry, material, seen: its counts of changes}
  }

  resize(width, height, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.size = { width, height };
  }

  draw(columns, orbit, skinOf) {
    const { renderer, camera, size } = this;
    renderer.setScissorTest(true);
    camera.fov = orbit.fieldDegrees;
    camera.near = Math.max(orbit.distance - 6 * orbit.size, 0.01 * orbit.distance);
    camera.far = orbit.distance + 60 * orbit.size;
    camera.position.fromArray(orbit.position);
    camera.up.fromArray(orbit.above);
    camera.lookAt(new THREE.Vector3().fromArray(orbit.target));
    camera.updateMatrixWorld();
    const wide = Math.max(...columns.map(({ width, height }) => width / height));
    const shown = new Map([...new Set(columns.map(skinOf))].filter(Boolean).map((skin) => [skin, this.sent(skin, orbit, wide)]));
    this.forget(shown);
    for (const column of columns) {
      const drawn = shown.get(skinOf(column));
      const bottom = size.height - column.top - column.height;
      renderer.setViewport(column.left, bottom, column.width, column.height);
      renderer.setScissor(column.left, bottom, column.width, column.height);
      camera.aspect = column.width / column.height;
      camera.updateProjectionMatrix();
      renderer.clear();
      if (drawn) renderer.render(drawn.scene, camera);
    }
  }

  /** What draws a skin, with its points, colours and the triangles to be seen from here on the card. */
  sent(skin, orbit, wide) {
    if (!this.known.has(skin)) this.known.set(skin, made(skin, this.surface, this.tints, this.skinTexture));
    const drawn = this.known.get(skin);
    const { attributes, index } = drawn.geometry;
    const { triangles, facing, texturing } = this.surface;
    const renew = (attribute, array) => {
      doubled(array, attribute.itemSize, texturing?.doubles ?? [], attribute.array);
      attribute.needsUpdate = true;
    };
    if (drawn.seen.shape !== skin.changes.shape) {
      renew(attributes.position, skin.points);
      renew(attributes.normal, skin.normals);
    }
    if (drawn.seen.paint !== skin.changes.paint) renew(attributes.paint, skin.paint);
    drawn.seen = { ...skin.changes };
    const count = seenTriangles(skin.points, triangles, facing, orbit, wide, index.array, texturing?.corners);
    index.clearUpdateRanges();
    index.addUpdateRange(0, count);
    index.needsUpdate = true;
    drawn.geometry.setDrawRange(0, count);
    return drawn;
  }

  /** Free what belongs to skins that are shown no more. */
  forget(shown) {
    for (const [skin, { geometry, material }] of this.known) {
      if (shown.has(skin)) continue;
      geometry.dispose();
      material.dispose();
      this.known.delete(skin);
    }
  }
}

/** The factors of eye.js as a texture of one row, and its share per radius of the eyeball. */
function textureOf({ factors, perRadius, last }) {
  const texels = Uint8Array.from({ length: 4 * (last + 1) }, (_, i) => Math.round(255 * Math.min(1, factors[3 * (i >> 2) + (i & 3)] ?? 1)));
  const texture = new THREE.DataTexture(texels, last + 1, 1);
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return { texture, perRadius: perRadius / (last + 1) };
}

/** The texture of a skin, its first row above. */
function smoothTexture({ texels, width, height }) {
  const texture = new THREE.DataTexture(new Uint8Array(texels.buffer), width, height);
  Object.assign(texture, { magFilter: THREE.LinearFilter, minFilter: THREE.LinearMipmapLinearFilter, generateMipmaps: true, needsUpdate: true });
  return texture;
}

function made(skin, { triangles, gaze, texturing }, tints, texture) {
  const all = (array, size) => (texturing?.doubles.length ? doubled(array, size, texturing.doubles) : array);
  const geometry = new THREE.BufferGeometry();
  const dynamic = (array, size, normalised = false) =>
    new THREE.BufferAttribute(array, size, normalised).setUsage(THREE.DynamicDrawUsage);
  geometry.setIndex(dynamic(new Uint32Array(triangles.length), 1));
  const attributes = {
    position: dynamic(all(skin.points, 3), 3),
    normal: dynamic(all(skin.normals, 3), 3),
    paint: dynamic(all(skin.paint, 4), 4, true),
    own: new THREE.BufferAttribute(all(skin.colours, 3), 3),
    gaze: new THREE.BufferAttribute(all(gaze, 2), 2),
    ...(texturing && { place: new THREE.BufferAttribute(texturing.places, 2) }),
  };
  for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
  const material = new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: THREE.DoubleSide,
    defines: texturing ? { TEXTURED: 1 } : {},
    uniforms: { tints: { value: tints.texture }, perRadius: { value: tints.perRadius }, skin: { value: texture } },
  });
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  const scene = new THREE.Scene();
  scene.matrixWorldAutoUpdate = false;
  scene.add(mesh);
  return { scene, geometry, material, seen: { ...skin.changes } };
}
