// Writes frames.csv in this folder: frames of the zstd program (1.5), and hashes of what they contain.
// Run with Node.js 20.
import {execFileSync} from 'node:child_process';
import crypto from 'node:crypto';
import fs from 'node:fs';

const rows = ['name,size,sha256,frame'];
let state = 1;

function random() {
  state = (state * 16807) % 2147483647;
  return state / 2147483647;
}

function add(name, content, ...options) {
  const frame = execFileSync('zstd', ['-q', '-c', ...options], {input: content});
  const sha256 = crypto.createHash('sha256').update(content).digest('hex');
  rows.push([name, content.length, sha256, frame.toString('base64')].join(','));
}

/** Returns bytes; low ones are more frequent. */
function skewed(count, values) {
  return Buffer.from(Array.from({length: count}, () => Math.floor(values * random() ** 3)));
}

/** Returns bytes that often repeat earlier ones. */
function repeating(count, values, longest) {
  const bytes = [...skewed(64, values)];
  while (bytes.length < count) {
    const from = Math.floor(random() * bytes.length);
    bytes.push(...bytes.slice(from, from + 3 + Math.floor(longest * random() ** 4)), ...skewed(2, values));
  }
  return Buffer.from(bytes.slice(0, count));
}

add('empty', Buffer.alloc(0));
add('one byte', Buffer.from('x'));
add('stored', Buffer.from(Array.from({length: 300}, () => 256 * random())));
add('zeros', Buffer.alloc(300000));
add('one stream', skewed(200, 9), '-1');
add('four streams', skewed(3000, 12), '-1');
add('many symbols', skewed(2500, 256), '-19');
add('sequences', repeating(4000, 100, 40), '-1');
add('long matches', Buffer.concat([repeating(2000, 50, 300), Buffer.alloc(200000, 'ab'), repeating(900, 50, 9)]), '-19');
add('sequences of one kind', Buffer.from('abcdefgh'.repeat(40) + 'x'.repeat(500) + 'abcdefgh'.repeat(9)), '-19');
add('shared codes', Buffer.concat(Array.from({length: 3}, () => Buffer.concat(
  [repeating(1200, 30, 60), Buffer.alloc(131072 - 1200, 7)]))), '-19', '--no-check');
add('fast', repeating(3000, 200, 30), '--fast=9');
add('ultra', repeating(6000, 7, 90), '--ultra', '-22', '--check');
fs.writeFileSync(new URL('frames.csv', import.meta.url), rows.join('\n') + '\n');
