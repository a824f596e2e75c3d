// Writes pictures.csv in this folder: KTX 2 files, and hashes of what the Basis Universal transcoder makes of them.
// Run with Node.js 20 after: npm install three@0.187.0 ktx2-encoder@0.6.0 ktx-parse@2.0.0
import crypto from 'node:crypto';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import zlib from 'node:zlib';
import {read, write} from 'ktx-parse';

const require = createRequire(import.meta.url);
const modules = require.resolve('ktx-parse').split('ktx-parse')[0];
const {nodeEncoder} = await import(`${modules}ktx2-encoder/dist/node/NodeBasisEncoder.js`);
const basis = `${modules}three/examples/jsm/libs/basis/basis_transcoder`;
const factory = {exports: {}};
new Function('module', 'exports', 'require', '__dirname', fs.readFileSync(`${basis}.js`, 'utf8'))(
  factory, factory.exports, require, modules);
const transcoder = await factory.exports({wasmBinary: fs.readFileSync(`${basis}.wasm`)});
transcoder.initializeBasis();

const RGBA32 = 13;
const rows = ['name,width,height,alpha,sha256,file'];
let state = 1;

function random() {
  state = (state * 16807) % 2147483647;
  return state / 2147483647;
}

function add(name, file, reference = file) {
  const texture = new transcoder.KTX2File(new Uint8Array(reference));
  texture.startTranscoding();
  const rgba = new Uint8Array(texture.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32));
  if (!texture.transcodeImage(rgba, 0, 0, 0, RGBA32, 0, -1, -1)) {
    throw new Error(name);
  }
  const sha256 = crypto.createHash('sha256').update(rgba).digest('hex');
  const size = [texture.getWidth(), texture.getHeight(), texture.getHasAlpha() ? 1 : 0];
  rows.push([name, ...size, sha256, Buffer.from(file).toString('base64')].join(','));
}

/** Returns a gradient with noise, and with alpha if there are 4 channels; gray if there is 1. */
function picture(width, height, channels, noise) {
  const values = new Uint8Array(4 * width * height).fill(255);
  for (let i = 0; i < width * height; i++) {
    const x = i % width / width;
    const y = Math.floor(i / width) / height;
    const texel = [200 * x + 30, 200 * y, 150 * (1 - x) + 40 * (y > x), 255 * ((x + y) % 1)];
    for (let c = 0; c < Math.max(3, channels); c++) {
      values[4 * i + c] = texel[channels === 1 ? 0 : c] + noise * random();
    }
  }
  return {width, height, data: values};
}

async function encoded(image, options) {
  return nodeEncoder.encode(new Uint8Array(4), {
    isUASTC: false, isKTX2File: true, qualityLevel: 128, compressionLevel: 2,
    generateMipmap: false, needSupercompression: false, imageDecoder: async () => image, ...options});
}

function deflated(file) {
  const parts = read(file);
  parts.supercompressionScheme = 3;
  for (const level of parts.levels) {
    level.uncompressedByteLength = level.levelData.length;
    level.levelData = new Uint8Array(zlib.deflateSync(level.levelData));
  }
  return write(parts);
}

// Bits of each mode's code, their number, that of hints; and the number and bits of patterns.
const MODES = [
  [0x01, 4, 15], [0x35, 6, 15], [0x1d, 5, 15, 30, 5], [0x03, 5, 15, 11, 4], [0x13, 5, 15, 30, 5],
  [0x0b, 5, 15], [0x1b, 5, 15], [0x07, 5, 15, 19, 5], [0x17, 5, 0], [0x0f, 5, 23, 30, 5],
  [0x02, 3, 17], [0x00, 2, 17], [0x06, 3, 17], [0x1f, 5, 23], [0x0d, 5, 23], [0x05, 7, 23],
  [0x15, 6, 23, 30, 5], [0x25, 6, 23], [0x09, 4, 15]];

/** Returns blocks of random bits, of each mode, and with each pattern. */
function randomBlocks(template) {
  const blocks = [];
  for (const [code, codeBits, hintBits, patterns = 1, patternBits = 0] of MODES) {
    for (let pattern = 0; pattern < Math.max(2, patterns); pattern++) {
      const block = Array.from({length: 16}, () => Math.floor(256 * random()));
      const put = (value, at, bits) => {
        for (let i = 0; i < bits; i++) {
          const place = at + i;
          block[place >> 3] = block[place >> 3] & ~(1 << place % 8) | (value >> i & 1) << place % 8;
        }
      };
      put(code, 0, codeBits);
      put(pattern % patterns, codeBits + hintBits, patternBits);
      blocks.push(...block);
    }
  }
  const parts = read(template);
  parts.pixelWidth = blocks.length / 4;
  parts.pixelHeight = 4;
  parts.levels = [{levelData: new Uint8Array(blocks), uncompressedByteLength: blocks.length}];
  return write(parts);
}

const small = await encoded(picture(8, 8, 4, 9), {isUASTC: true});
add('UASTC of each mode', randomBlocks(small));
add('UASTC', await encoded(picture(13, 9, 3, 20), {isUASTC: true}));
add('UASTC with alpha and levels', await encoded(picture(30, 17, 4, 9), {isUASTC: true, generateMipmap: true}));
add('UASTC with Zstandard', await encoded(picture(61, 37, 3, 3), {isUASTC: true, needSupercompression: true}));
add('UASTC with alpha and Zstandard', await encoded(picture(40, 40, 4, 0),
  {isUASTC: true, needSupercompression: true, generateMipmap: true}));
const plain = await encoded(picture(24, 20, 4, 5), {isUASTC: true});
add('UASTC with zlib', deflated(plain), plain); // The transcoder has no zlib.
add('UASTC of one texel', await encoded(picture(1, 1, 3, 9), {isUASTC: true}));
add('ETC1S', await encoded(picture(50, 35, 3, 30), {}));
add('ETC1S with alpha', await encoded(picture(64, 40, 4, 20), {}));
add('ETC1S with alpha and levels', await encoded(picture(33, 47, 4, 5), {generateMipmap: true}));
add('ETC1S of gray', await encoded(picture(40, 40, 1, 60), {}));
add('ETC1S of good quality', await encoded(picture(80, 60, 3, 90), {qualityLevel: 255}));
add('ETC1S of poor quality', await encoded(picture(48, 40, 3, 0), {qualityLevel: 1}));
add('ETC1S of one color', await encoded(
  {width: 1000, height: 600, data: new Uint8Array(4 * 600000).fill(77)}, {generateMipmap: true}));
add('ETC1S of one texel', await encoded(picture(1, 1, 4, 9), {}));
fs.writeFileSync(new URL('pictures.csv', import.meta.url), rows.join('\n') + '\n');
