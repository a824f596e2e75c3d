'use strict';
// The tone curves of io.github.lumbre.image.ToneCurve: the same formulas, rounded to the same bytes.
const Tone = (() => {
  const decode = v => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4;

  // A table from the upper bits of a float to a byte; a comparison with exact limits corrects it.
  const float = new Float32Array(1), bits = new Uint32Array(float.buffer);
  const encoder = inverse => {
    const limits = new Float64Array(258);
    for (let b = 1; b < 256; b++) limits[b] = inverse((b - .5) / 255);
    limits[0] = -Infinity;
    limits[256] = limits[257] = Infinity;
    const table = new Uint8Array(1 << 16);
    let b = 0;
    for (let i = 0; i < 0x3f81; i++) {
      for (let j = 0; j < 2; j++) {
        bits[0] = i << 16 | j << 15;
        while (float[0] >= limits[b + 1]) b++;
        table[i << 1 | j] = b;
      }
    }
    table.fill(255, 0x3f80 << 1);
    return v => {
      if (!(v > 0)) return 0;
      if (v >= 1) return 255;
      float[0] = v;
      let found = table[bits[0] >>> 15];
      while (v >= limits[found + 1]) found++;
      while (v < limits[found]) found--;
      return found;
    };
  };
  const encode = v => v <= .0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - .055;

  // The share of the background in the next pixel, and its light before the last step of a curve.
  let share = 0, behind = [0, 0, 0];
  const clamp = v => Math.max(0, Math.min(1, v)), over = (v, c) => share ? (1 - share) * clamp(v) + share * behind[c] : v;
  const ending = encoded => (r, g, b, out, i) => {
    out[i] = encoded(over(r, 0)); out[i + 1] = encoded(over(g, 1)); out[i + 2] = encoded(over(b, 2));
  };

  const positive = v => v > 0 ? Math.min(v, 1e100) : 0;
  const luminance = (r, g, b) => .2126 * r + .7152 * g + .0722 * b;
  const filmic = v => {
    const x = Math.max(0, Math.min(v, 100));
    return x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14);
  };
  const sigmoid = v => {
    const stops = Math.log2(Math.max(v, 1e-10));
    const x = (Math.max(-12.47393, Math.min(4.026069, stops)) + 12.47393) / (12.47393 + 4.026069);
    const x2 = x * x, x4 = x2 * x2;
    return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + .4298 * x2 + .1191 * x - .00232;
  };
  const outset = v => Math.max(0, Math.min(1, v)) ** 2.2;

  // Each curve writes three bytes.
  const curves = {
    srgb: ending(encoder(decode)),
    gamma22: ending(encoder(v => v ** 2.2)),
    reinhard(r, g, b, out, i) {
      r = positive(r); g = positive(g); b = positive(b);
      const s = 1 / (1 + luminance(r, g, b));
      curves.srgb(r * s, g * s, b * s, out, i);
    },
    aces(r, g, b, out, i) { curves.srgb(filmic(r), filmic(g), filmic(b), out, i); },
    neutral(r, g, b, out, i) {
      r = positive(r); g = positive(g); b = positive(b);
      const least = Math.min(r, g, b), offset = least < .08 ? least - 6.25 * least * least : .04;
      r -= offset; g -= offset; b -= offset;
      const peak = Math.max(r, g, b), start = .76;
      if (peak >= start) {
        const newPeak = 1 - .24 * .24 / (peak + .24 - start);
        const share = 1 - 1 / (.15 * (peak - newPeak) + 1);
        const s = newPeak / peak * (1 - share), t = newPeak * share;
        r = r * s + t; g = g * s + t; b = b * s + t;
      }
      curves.srgb(r, g, b, out, i);
    },
    agx(r, g, b, out, i) {
      r = positive(r); g = positive(g); b = positive(b);
      const x = sigmoid(.842479062253094 * r + .0784335999999992 * g + .0792237451477643 * b);
      const y = sigmoid(.0423282422610123 * r + .878468636469772 * g + .0791661274605434 * b);
      const z = sigmoid(.0423756549057051 * r + .0784336 * g + .879142973793104 * b);
      curves.srgb(
        outset(1.19687900512017 * x - .0980208811401368 * y - .0990297440797205 * z),
        outset(-.0528968517574562 * x + 1.15190312990417 * y - .0989611768448433 * z),
        outset(-.0529716355144438 * x - .0980434501171241 * y + 1.15107367264116 * z), out, i);
    },
  };

  // The values of all half floats.
  let halves;
  const fromHalf = shorts => {
    if (!halves) {
      halves = new Float32Array(65536);
      for (let h = 0; h < 65536; h++) {
        const sign = h & 0x8000 ? -1 : 1, exponent = h >> 10 & 31, mantissa = h & 1023;
        halves[h] = sign * (exponent === 0 ? mantissa * 2 ** -24
          : exponent === 31 ? (mantissa ? NaN : Infinity) : (1 + mantissa / 1024) * 2 ** (exponent - 15));
      }
    }
    const values = new Float32Array(shorts.length);
    for (let i = 0; i < shorts.length; i++) values[i] = halves[shorts[i]];
    return values;
  };

  // A picture as the server sends it: see PictureBytes.
  const read = buffer => {
    const [width, height, channels, size, version] = new Uint32Array(buffer, 0, 5);
    const values = size === 4 ? new Float32Array(buffer, 20) : fromHalf(new Uint16Array(buffer, 20));
    return {width, height, channels, values, version, isExact: size === 4};
  };

  // Fills the pixels of a canvas with light. A background is a linear color of the screen behind what has alpha.
  const develop = (p, factor, curve, out, background) => {
    const write = curves[curve], n = p.channels, v = p.values;
    if (background) behind = curve === 'gamma22' ? background.map(c => encode(c) ** 2.2) : background;
    for (let i = 0, o = 0; i < v.length; i += n, o += 4) {
      const alpha = n === 4 ? clamp(v[i + 3]) : 1;
      share = background ? 1 - alpha : 0;
      write(v[i] * factor, v[i + 1] * factor, v[i + 2] * factor, out, o);
      out[o + 3] = background ? 255 : Math.round(255 * alpha);
    }
    share = 0;
  };

  // A picture in linear light over its background.
  const asLight = (p, background) => {
    if (p.channels !== 4 || !background) return p;
    const values = new Float32Array(3 * p.width * p.height);
    for (let i = 0; i < values.length / 3; i++) {
      const alpha = p.values[4 * i + 3];
      for (let c = 0; c < 3; c++) values[3 * i + c] = alpha * p.values[4 * i + c] + (1 - alpha) * background[c];
    }
    return {...p, channels: 3, values};
  };

  // Fills the pixels of a canvas with numbers between two limits for each channel.
  const scale = (p, low, high, out) => {
    const n = p.channels, v = p.values;
    for (let i = 0, o = 0; i < v.length; i += n, o += 4) {
      for (let c = 0; c < 3; c++) {
        const from = n === 1 ? 0 : c;
        const x = from < n ? (v[i + from] - low[from]) / (high[from] - low[from]) : 0;
        out[o + c] = x > 0 ? Math.round(255 * Math.min(1, x)) : 0;
      }
      out[o + 3] = 255;
    }
  };

  // The bits of values, which are ids in mattes.
  const ids = p => new Uint32Array(p.values.buffer, p.values.byteOffset, p.values.length);

  // Fills the pixels of a canvas with a color for each item of a matte, by the shares of two items.
  const matte = (p, out) => {
    const id = ids(p), v = p.values;
    const tints = new Map();
    const tint = key => {
      if (!tints.has(key)) {
        // Hues of any ids are far apart: multiples of the golden ratio of a whole turn.
        const hue = Math.imul(key, 0x9e3779b1) >>> 0, h = hue / 2 ** 32 * 6, l = .45 + .3 * ((hue >>> 3 & 255) / 255);
        tints.set(key, [0, 4, 2].map(k => 255 * (l + .5 * Math.min(l, 1 - l) * Math.max(-1, Math.min(1, Math.abs((h + k) % 6 - 3) - 1)))));
      }
      return tints.get(key);
    };
    for (let i = 0; i < v.length; i += 4) {
      let r = 0, g = 0, b = 0;
      for (let k = 0; k < 4; k += 2) {
        const share = v[i + k + 1];
        if (share > 0) { const t = tint(id[i + k]); r += share * t[0]; g += share * t[1]; b += share * t[2]; }
      }
      out[i] = r; out[i + 1] = g; out[i + 2] = b; out[i + 3] = 255;
    }
  };

  // The items of a pixel of a matte, as pairs of an id in hexadecimal and a share.
  const items = (p, pixel) => [0, 2].map(k => 4 * pixel + k).filter(i => p.values[i + 1] > 0)
    .map(i => [ids(p)[i].toString(16).padStart(8, '0'), p.values[i + 1]]);

  return {read, matte, items, develop, asLight, scale, decode, luminance, curves};
})();
