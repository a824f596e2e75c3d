// Writes the .drc files of this folder, and decoded.csv: what Google's decoder makes of them.
// Run with Node.js 20 after: npm install draco3dgltf@1.5.7
import crypto from 'node:crypto';
import fs from 'node:fs';
import draco from 'draco3dgltf';

const encoders = await draco.createEncoderModule();
const decoders = await draco.createDecoderModule();
const BYTES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 9: 4};
let state = 1;

function random() {
  state = (state * 16807) % 2147483647;
  return state / 2147483647;
}

// A torus of n x m quads, of which every fifth is missing if it has holes: its texture has seams.
function torus(hasHoles, {n = 16, m = 10, side = 1} = {}) {
  const mesh = {positions: [], normals: [], uvs: [], colors: [], joints: [], weights: [], ids: [],
    indices: []};
  for (let j = 0; j <= m; j++) {
    for (let i = 0; i <= n; i++) {
      const a = (2 * Math.PI * (i % n)) / n;
      const b = (2 * Math.PI * (j % m)) / m;
      const normal = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
      mesh.positions.push(2 * Math.cos(a) + normal[0], 2 * Math.sin(a) + normal[1], normal[2]);
      mesh.normals.push(...normal.map(x => side * x));
      mesh.uvs.push(i / n + random() / 100, j / m);
      mesh.colors.push(255 * random(), 255 * random(), (250 * j) / m, 255);
      mesh.joints.push(i % 7, 300 + (j % 5), 0, 0);
      mesh.weights.push(i / n, 1 - i / n, 0, 0);
      mesh.ids.push(1000 * random());
      if (i < n && j < m && !(hasHoles && (7 * i + 3 * j) % 5 === 0)) {
        const c = (n + 1) * j + i;
        mesh.indices.push(c, c + 1, c + n + 2, c, c + n + 2, c + n + 1);
      }
    }
  }
  return mesh;
}

// Open cylinders around each axis, whose normals lie on the border of octahedron coordinates.
function tubes() {
  const mesh = {positions: [], normals: [], uvs: [], indices: []};
  for (let axis = 0; axis < 3; axis++) {
    for (let i = 0; i <= 16; i++) {
      for (let j = 0; j < 3; j++) {
        const normal = [0, Math.cos((Math.PI * i) / 8), Math.sin((Math.PI * i) / 8)];
        const turn = v => [v[(3 - axis) % 3], v[(4 - axis) % 3], v[(5 - axis) % 3]];
        mesh.positions.push(...turn([j + 9, normal[1], normal[2]]));
        mesh.normals.push(...turn(normal));
        mesh.uvs.push(i / 16, j);
        if (i < 16 && j < 2) {
          const c = 51 * axis + 3 * i + j;
          mesh.indices.push(c, c + 3, c + 4, c, c + 4, c + 1);
        }
      }
    }
  }
  return mesh;
}

function encode(mesh, {isSequential, speed, isBare, isRaw, isLarge, hasMetadata}) {
  const encoder = new encoders.Encoder();
  const builder = new encoders.MeshBuilder();
  const target = new encoders.Mesh();
  const count = mesh.positions.length / 3;
  const floats = (type, numbers) => builder.AddFloatAttributeToMesh(
    target, type, count, numbers.length / count, new Float32Array(numbers));
  builder.AddFacesToMesh(target, mesh.indices.length / 3, new Uint32Array(mesh.indices));
  floats(encoders.POSITION, mesh.positions);
  if (!isBare) {
    floats(encoders.NORMAL, mesh.normals);
    floats(encoders.TEX_COORD, mesh.uvs);
  }
  if (isLarge) {
    builder.AddUInt8Attribute(target, encoders.COLOR, count, 4, new Uint8Array(mesh.colors));
    builder.AddUInt16Attribute(target, encoders.GENERIC, count, 4, new Uint16Array(mesh.joints));
    floats(encoders.GENERIC, mesh.weights);
    floats(encoders.GENERIC, mesh.ids);
  }
  if (hasMetadata) {
    const metadata = new encoders.Metadata();
    new encoders.MetadataBuilder().AddStringEntry(metadata, 'name', 'torus');
    builder.AddMetadata(target, metadata);
  }
  encoder.SetSpeedOptions(speed, speed);
  if (!isRaw) {
    encoder.SetAttributeQuantization(encoders.POSITION, 11);
    encoder.SetAttributeQuantization(encoders.NORMAL, 8);
    encoder.SetAttributeQuantization(encoders.TEX_COORD, 10);
    encoder.SetAttributeQuantization(encoders.GENERIC, 9);
  }
  encoder.SetEncodingMethod(
    isSequential ? encoders.MESH_SEQUENTIAL_ENCODING : encoders.MESH_EDGEBREAKER_ENCODING);
  const bytes = new encoders.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(target, bytes);
  return Uint8Array.from({length}, (_, i) => bytes.GetValue(i));
}

// The corners as 32-bit integers, then the values of each attribute for all points.
function decode(file) {
  const decoder = new decoders.Decoder();
  const buffer = new decoders.DecoderBuffer();
  buffer.Init(file, file.length);
  const mesh = new decoders.Mesh();
  const status = decoder.DecodeBufferToMesh(buffer, mesh);
  if (!status.ok()) {
    throw new Error(status.error_msg());
  }
  const hash = crypto.createHash('sha256');
  const add = (size, read) => {
    const at = decoders._malloc(size);
    read(at);
    hash.update(decoders.HEAPU8.slice(at, at + size));
    decoders._free(at);
  };
  const corners = 12 * mesh.num_faces();
  add(corners, at => decoder.GetTrianglesUInt32Array(mesh, corners, at));
  for (let i = 0; i < mesh.num_attributes(); i++) {
    const attribute = decoder.GetAttribute(mesh, i);
    const type = attribute.data_type();
    const size = BYTES[type] * attribute.num_components() * mesh.num_points();
    add(size, at => decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type, size, at));
  }
  return `${mesh.num_faces()},${mesh.num_points()},${hash.digest('hex')}`;
}

const rows = [];
function write(name, mesh, options) {
  const file = encode(mesh, options);
  fs.writeFileSync(`${name}.drc`, file);
  rows.push(`${name},${decode(file)}`);
}

for (let speed = 0; speed <= 10; speed++) {
  write(`edgebreaker-${speed}`, torus(false), {speed});
}
for (const speed of [0, 5, 10]) {
  write(`holes-${speed}`, torus(true), {speed, isLarge: true});
  write(`bare-${speed}`, torus(true), {speed, isBare: true});
  write(`sequential-${speed}`, torus(true), {speed, isLarge: true, isSequential: true});
}
write('raw-edgebreaker', torus(true), {speed: 5, isRaw: true, isLarge: true});
write('raw-sequential', torus(true), {speed: 5, isRaw: true, isLarge: true, isSequential: true});
write('inverted', torus(true, {side: -1}), {speed: 1});
write('tubes', tubes(), {speed: 1});
write('fine', torus(true, {n: 50, m: 30}), {speed: 1});
write('metadata', torus(false), {speed: 7, isBare: true, hasMetadata: true});
fs.writeFileSync('decoded.csv', `name,faces,points,sha256\n${rows.join('\n')}\n`);
