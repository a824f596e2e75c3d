// Writes variants of models with compressed meshes and textures, and with copies, into the folder in which it runs: beside the
// folders of the packages that have the models. Arguments: names of models; none means all. Files that exist stay.
import { readFile, writeFile } from 'node:fs/promises';
import { existsSync } from 'node:fs';
import { NodeIO, getBounds } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression } from '@gltf-transform/extensions';
import { draco, instance, meshopt, textureCompress, unpartition } from '@gltf-transform/functions';
import draco3d from 'draco3dgltf';
import * as gltfpack from 'gltfpack';
import { ktx2 } from 'ktx2-encoder/gltf-transform';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import sharp from 'sharp';

const OWN = '../../../scenes/models/';
const WEBXR = '../webxr-input-profiles/package/dist/profiles/';
const ASSIMP = '../assimp-testmodels/usr/share/assimp/models/glTF2/';
const GENESIS = '../genesis-world/genesis/assets/meshes/';
const MODELS = {
  lantern: OWN + 'lantern.glb',
  clockwork: OWN + 'clockwork.glb',
  valve: WEBXR + 'valve-index/right.glb',
  magicleap: WEBXR + 'magicleap-two/none.glb',
  galaxy: WEBXR + 'samsung-galaxyxr/left.glb',
  camera: GENESIS + 'camera/camera.glb',
  board: GENESIS + 'chopping-board/source/chopping_board.glb',
  engine: ASSIMP + '2CylinderEngine-glTF-Binary/2CylinderEngine.glb',
  coats: ASSIMP + 'ClearCoat-glTF/ClearCoatTest.gltf',
  transforms: ASSIMP + 'textureTransform/TextureTransformTest.gltf',
  skin: ASSIMP + 'simple_skin/simple_skin.gltf',
};
const TEXTURE_SIZE = 512;

/** Draws one picture of each kind, with the same values as all decoders of PNG. */
const imageDecoder = async (buffer) => {
  const { data, info } = await sharp(buffer).ensureAlpha().raw().toBuffer({ resolveWithObject: true });
  return { data: new Uint8Array(data), width: info.width, height: info.height };
};
const small = textureCompress({ encoder: sharp, targetFormat: 'png', resize: [TEXTURE_SIZE, TEXTURE_SIZE] });
const webp = (options) => textureCompress({ encoder: sharp, targetFormat: 'webp', ...options });
const basis = (options) => async (document) => {
  const all = { imageDecoder, generateMipmap: true, ...options };
  await document.transform(
    ktx2({ slots: /color|emissive/i, isPerceptual: true, isSetKTX2SRGBTransferFunc: true, ...all }),
    ktx2({ isPerceptual: false, isSetKTX2SRGBTransferFunc: false, ...all }));
};
const etc1s = basis({ isUASTC: false, qualityLevel: 255 });

/** Nine copies of the scene side by side, the middle one small, whose nodes share the meshes. */
const copies = (document) => {
  const scene = document.getRoot().getDefaultScene() ?? document.getRoot().listScenes()[0];
  const { min, max } = getBounds(scene);
  const nodes = scene.listChildren();
  for (let i = 0; i < 9; i++) {
    const x = (i % 3) * 1.2 * (max[0] - min[0]);
    const z = Math.floor(i / 3) * 1.2 * (max[2] - min[2]);
    const place = document.createNode('copy' + i).setTranslation([x, 0, z]).setScale(Array(3).fill(i === 4 ? 0.5 : 1));
    nodes.forEach((node) => place.addChild(copy(document, node)));
    scene.addChild(place);
  }
  const originals = [];
  nodes.forEach((node) => node.traverse((each) => originals.push(each)));
  originals.forEach((node) => node.dispose());
};
const copy = (document, node) => {
  const made = document.createNode(node.getName()).setMatrix(node.getMatrix()).setMesh(node.getMesh());
  node.listChildren().forEach((child) => made.addChild(copy(document, child)));
  return made;
};

/** The attributes and indices as they are: neither quantized, nor in another order. */
const plainMeshopt = (document) => {
  document.createExtension(EXTMeshoptCompression).setRequired(true)
    .setEncoderOptions({ method: EXTMeshoptCompression.EncoderMethod.QUANTIZE });
};

const MESHES = {
  'draco-edgebreaker': [draco({ method: 'edgebreaker' })],
  'draco-sequential': [draco({ method: 'sequential' })],
  'draco-fine': [draco({ quantizePosition: 16, quantizeNormal: 14, quantizeTexcoord: 16 })],
  'meshopt-plain': [plainMeshopt],
  'meshopt-medium': [meshopt({ encoder: MeshoptEncoder, level: 'medium' })],
  'meshopt-high': [meshopt({ encoder: MeshoptEncoder, level: 'high' })],
};
const COPIES = { copies: [copies], instances: [copies, instance({ min: 2 })] };
const TEXTURES = {
  webp: [webp({ quality: 90 })],
  'webp-lossless': [webp({ lossless: true })],
  etc1s: [etc1s],
  uastc: [basis({ isUASTC: true, needSupercompression: true })],
  'draco-webp': [draco(), webp({ quality: 90 })],
  'meshopt-etc1s': [meshopt({ encoder: MeshoptEncoder }), etc1s],
};
const PACKS = {
  'gltfpack-c': ['-c'],
  'gltfpack-cc': ['-cc'],
  'gltfpack-cz': ['-cz'],
  'gltfpack-floats': ['-cc', '-noq'],
};
const DECODED = ['draco-edgebreaker', 'draco-sequential', 'meshopt-plain', 'meshopt-high', 'gltfpack-cc', 'gltfpack-cz'];

await Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready]);
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
  'draco3d.encoder': await draco3d.createEncoderModule(),
  'draco3d.decoder': await draco3d.createDecoderModule(),
  'meshopt.encoder': MeshoptEncoder,
  'meshopt.decoder': MeshoptDecoder,
});

async function pack(bytes, options) {
  let packed;
  const files = { read: () => bytes, write: (name, data) => (packed = data.slice()) };
  await gltfpack.pack(['-i', 'in.glb', '-o', 'out.glb', ...options], files);
  return packed;
}

async function transformed(bytes, transforms) {
  const document = await io.readBinary(bytes);
  await document.transform(...transforms);
  return document;
}

/** The same data as the reference decoders leave it, uncompressed. Both extensions of meshopt have the same streams. */
async function decoded(bytes) {
  const text = bytes.toString('latin1').replaceAll('KHR_meshopt_compression', 'EXT_meshopt_compression');
  const document = await io.readBinary(Buffer.from(text, 'latin1'));
  const extensions = document.getRoot().listExtensionsUsed();
  extensions.filter((each) => /draco|meshopt/.test(each.extensionName)).forEach((each) => each.dispose());
  await document.transform(textureCompress({ encoder: sharp, targetFormat: 'png', formats: /webp/ }));
  return io.writeBinary(document);
}

const wanted = process.argv.slice(2);
const say = console.log;
console.log = () => {}; // the encoder of KTX 2 reports each level
for (const [name, path] of Object.entries(MODELS)) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  const document = await io.read(path);
  const textures = document.getRoot().listTextures().length;
  const skins = document.getRoot().listSkins().length;
  await document.transform(unpartition(), small);
  const bytes = await io.writeBinary(document);
  const write = async (kind, make) => {
    const file = `${name}-${kind}.glb`;
    if (existsSync(file)) return;
    const made = await make();
    await writeFile(file, made);
    say(`${file}: ${made.length} of ${bytes.length} bytes`);
  };
  await write('plain', () => bytes);
  const kinds = { ...MESHES, ...(skins > 0 ? {} : COPIES), ...(textures > 0 ? TEXTURES : {}) };
  for (const [kind, transforms] of Object.entries(kinds)) {
    await write(kind, async () => io.writeBinary(await transformed(bytes, transforms)));
  }
  for (const [kind, options] of Object.entries(PACKS)) {
    await write(kind, () => pack(bytes, options));
  }
  for (const kind of textures > 0 ? [...DECODED, 'webp'] : DECODED) {
    await write(kind + '-decoded', async () => decoded(await readFile(`${name}-${kind}.glb`)));
  }
  if (skins === 0) {
    const many = await io.writeBinary(await transformed(bytes, [copies]));
    await write('gltfpack-instances', () => pack(many, ['-mi', '-cc']));
  }
}
