// Decodes the packed scene that usdrigui/view/web/packing.py writes: inflate, read the JSON header, and turn
// its array entries into typed arrays.

const GAZE_STEP = 3 / 8192;
const KINDS = {
  u1: Uint8Array,
  u2: Uint16Array,
  i2: Int16Array,
  u4: Uint32Array,
  i4: Int32Array,
  f4: Float32Array,
  f8: Float64Array,
};

/** Scene ({title, characters}) from the page's base64 text. */
export async function readScene(base64) {
  const packed = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const body = bytes.subarray(4 + length);
  header.characters.forEach((character) => decodeCharacter(character, body));
  const texture = await pictured((header.images ?? []).map((entry) => decodeArray(entry, body)));
  for (const character of header.characters) character.texture = texture;
  return header;
}

/**
 * Image files as one picture of squares in rows: its texels, one number each (alpha, blue, green, red), and the `boxes` of
 * the images in it.  Null where there are none, or nothing decodes them.
 */
async function pictured(files) {
  if (!files.length || typeof createImageBitmap === 'undefined') return null;
  const images = await Promise.all(files.map((file) => createImageBitmap(new Blob([file]), { colorSpaceConversion: 'none' })));
  const side = Math.max(...images.flatMap(({ width, height }) => [width, height]));
  const across = Math.ceil(Math.sqrt(images.length));
  const [width, height] = [across * side, Math.ceil(images.length / across) * side];
  const pen = /** @type {CanvasRenderingContext2D} */ (Object.assign(document.createElement('canvas'), { width, height }).getContext('2d'));
  const boxes = images.map((image, k) => [(k % across) * side, Math.floor(k / across) * side, image.width, image.height]);
  images.forEach((image, k) => pen.drawImage(image, boxes[k][0], boxes[k][1]));
  return { width, height, boxes, texels: new Int32Array(pen.getImageData(0, 0, width, height).data.buffer) };
}

function decodeCharacter(character, body) {
  character.bind = decodeArray(character.bind, body);
  character.base = decodeArray(character.base, body);
  let start = 0;
  for (const mesh of character.meshes) {
    mesh.points = dequantised(decodeArray(mesh.points, body), mesh.low, mesh.step);
    mesh.count = mesh.points.length / 3;
    mesh.start = start;
    start += mesh.count;
    mesh.triangles = decodeArray(mesh.triangles, body);
    if (mesh.texture) for (const name of ['uv', 'images']) mesh.texture[name] = decodeArray(mesh.texture[name], body);
    mesh.colours = decodeArray(mesh.colours, body);
    mesh.gaze = mesh.gaze && Float32Array.from(decodeArray(mesh.gaze, body), (steps) => steps * GAZE_STEP);
    for (const shape of mesh.shapes) {
      shape.points = decodeArray(shape.points, body);
      shape.offsets = decodeArray(shape.offsets, body);
    }
    if (mesh.skin) decodeSkin(mesh.skin, body);
  }
  character.pointCount = start;
  character.shotCamera = character.shotCamera?.map((row) => [0, 3, 6, 9, 12].map((at) => row.slice(at, at + 3)));
  if (character.clip) {
    character.clip.weights = decodeArray(character.clip.weights, body);
    character.clip.locals = decodeArray(character.clip.locals, body);
  }
}

/** Influences as Float64 weights of rows that sum to one where they did before rounding. */
function decodeSkin(skin, body) {
  const [rows, width] = skin.joints.shape;
  skin.rows = rows;
  skin.width = width;
  skin.joints = decodeArray(skin.joints, body);
  const steps = decodeArray(skin.weights, body);
  skin.weights = new Float64Array(steps.length);
  for (let row = 0; row < rows; row++) {
    const total = steps.subarray(row * width, (row + 1) * width).reduce((sum, each) => sum + each, 0);
    const unit = Math.abs(total - 65535) <= width ? total : 65535;
    for (let i = row * width; i < (row + 1) * width; i++) skin.weights[i] = steps[i] / unit;
  }
}

function decodeArray(entry, body) {
  const Type = KINDS[entry.kind];
  const width = Type.BYTES_PER_ELEMENT;
  const count = entry.shape.reduce((product, size) => product * size, 1);
  const bytes = new Uint8Array(count * width);
  for (let plane = 0; plane < width; plane++) {
    const from = entry.at + plane * count;
    for (let i = 0; i < count; i++) bytes[i * width + plane] = body[from + i];
  }
  const values = new Type(bytes.buffer);
  if (entry.sum) for (let i = 1; i < count; i++) values[i] += values[i - 1];
  return values;
}

const dequantised = (grid, low, step) => Float32Array.from(grid, (steps, i) => low[i % 3] + steps * step[i % 3]);
