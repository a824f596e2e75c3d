// Writes streams.csv in this folder: streams, and hashes of what meshoptimizer's decoder makes of them.
// Run with Node.js 20 after: npm install meshoptimizer@1.3.0
import crypto from 'node:crypto';
import fs from 'node:fs';
import {MeshoptDecoder, MeshoptEncoder} from 'meshoptimizer';

await MeshoptEncoder.ready;
await MeshoptDecoder.ready;
const rows = ['name,mode,filter,count,stride,sha256,stream'];
let state = 1;

function random() {
  state = (state * 16807) % 2147483647;
  return state / 2147483647;
}

function add(name, mode, filter, count, stride, stream) {
  const target = new Uint8Array(count * stride);
  MeshoptDecoder.decodeGltfBuffer(target, count, stride, stream, mode, filter);
  const sha256 = crypto.createHash('sha256').update(target).digest('hex');
  const text = Buffer.from(stream).toString('base64');
  rows.push([name, mode, filter, count, stride, sha256, text].join(','));
}

const bytes = array => new Uint8Array(array.buffer);

function attributes(name, source, count, stride, filter = 'NONE') {
  add(`${name}-v0`, 'ATTRIBUTES', filter, count, stride,
    MeshoptEncoder.encodeVertexBufferLevel(source, count, stride, 2, 0));
  for (const level of filter === 'NONE' ? [0, 3] : [3]) {
    add(`${name}-v1-${level}`, 'ATTRIBUTES', filter, count, stride,
      MeshoptEncoder.encodeVertexBufferLevel(source, count, stride, level, 1));
  }
}

// Differences of all widths: constant, slow, fast and random bytes.
function mixed(count, stride) {
  return Uint8Array.from({length: count * stride}, (_, i) => {
    const row = Math.floor(i / stride);
    const column = i % stride;
    const spread = [0, 0, 1, 2, 6, 12, 200, 256][(column + (row >> 5)) % 8];
    return column < 12 ? row + spread * random() : column;
  });
}

for (const [count, stride] of [[0, 4], [1, 4], [16, 8], [100, 8], [270, 4], [33, 256], [21, 64]]) {
  attributes(`bytes-${count}-${stride}`, mixed(count, stride), count, stride);
}
const waves = Array.from({length: 300}, (_, i) => Math.sin(i / 50) * (1 + (i % 3)));
attributes('floats', bytes(new Float32Array(waves)), 100, 12);
attributes('shorts', bytes(new Uint16Array(waves.map(x => 9000 * (x + 3)))), 150, 4);
attributes('noise', Uint8Array.from({length: 160}, () => 256 * random()), 20, 8);

const vectors = n => new Float32Array(Array.from({length: n}).flatMap(() => {
  const v = [random() - .5, random() - .5, random() - .5, random() - .5];
  const length = Math.hypot(v[0], v[1], v[2]);
  return [v[0] / length, v[1] / length, v[2] / length, Math.sign(v[3])];
}));
const quaternions = n => new Float32Array(Array.from({length: n}).flatMap(() => {
  const q = [random() - .5, random() - .5, random() - .5, random() - .5];
  return q.map(x => x / Math.hypot(...q));
}));
const colors = n => new Float32Array(Array.from({length: 4 * n}, random));
for (const [stride, bits] of [[4, 8], [4, 5], [8, 12], [8, 16]]) {
  attributes(`octahedral-${bits}`, MeshoptEncoder.encodeFilterOct(vectors(20), 20, stride, bits), 20,
    stride, 'OCTAHEDRAL');
  attributes(`color-${bits}`, MeshoptEncoder.encodeFilterColor(colors(20), 20, stride, bits), 20,
    stride, 'COLOR');
}
for (const bits of [8, 12, 16]) {
  attributes(`quaternion-${bits}`, MeshoptEncoder.encodeFilterQuat(quaternions(20), 20, 8, bits), 20, 8,
    'QUATERNION');
}
for (const bits of [4, 15, 23]) {
  const numbers = new Float32Array(waves.slice(0, 60));
  attributes(`exponential-${bits}`, MeshoptEncoder.encodeFilterExp(numbers, 20, 12, bits), 20, 12,
    'EXPONENTIAL');
}

function grid(n) {
  const indices = [];
  for (let i = 0; i < n * n; i++) {
    const c = i + Math.floor(i / n);
    indices.push(c, c + 1, c + n + 1, c + 1, c + n + 2, c + n + 1);
  }
  return indices;
}
const ordered = new Uint32Array(grid(9));
MeshoptEncoder.reorderMesh(ordered, true, true);
const soup = Array.from({length: 60}, () => 60000 * random());
const lists = {
  grid: ordered,
  rows: grid(7),
  soup,
  twice: [...grid(3), ...grid(3)],
  empty: [],
};
for (const [name, list] of Object.entries(lists)) {
  for (const [stride, type] of [[2, Uint16Array], [4, Uint32Array]]) {
    for (const mode of ['TRIANGLES', 'INDICES']) {
      const source = bytes(type.from(list));
      add(`${name}-${mode.toLowerCase()}-${stride}`, mode, 'NONE', list.length, stride,
        MeshoptEncoder.encodeGltfBuffer(source, list.length, stride, mode));
    }
  }
}
const far = bytes(Uint32Array.from([0, 4000000000, 5, 2147483648, 1073741824, 7]));
add('far-triangles', 'TRIANGLES', 'NONE', 6, 4, MeshoptEncoder.encodeGltfBuffer(far, 6, 4, 'TRIANGLES'));

// Random bits across the bounds of bytes, which the encoder rotates, and stores as exclusive disjunctions.
for (const shift of [1, 2, 3, 4, 5, 6, 7]) {
  const numbers = Array.from({length: 40}, () => ((256 * random()) << shift) | ((256 * random()) << (16 + shift)));
  attributes(`rotated-${shift}`, bytes(new Uint32Array(numbers)), 40, 4);
}

fs.writeFileSync('streams.csv', `${rows.join('\n')}\n`);
