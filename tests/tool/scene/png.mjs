// SPDX-License-Identifier: BSL-1.0
import { deflateSync, inflateSync } from "node:zlib";

const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);

/** Decodes a picture with 8 bits per colour to { width, height, pixels }: red, green and blue in turn. */
export function decode(file) {
  if (!file.subarray(0, 8).equals(signature)) {
    throw new Error("not a PNG");
  }
  const data = [];
  let header;
  for (let at = 8; at < file.length;) {
    const length = file.readUInt32BE(at);
    const type = file.toString("latin1", at + 4, at + 8);
    const content = file.subarray(at + 8, at + 8 + length);
    if (type === "IHDR") {
      header = content;
    } else if (type === "IDAT") {
      data.push(content);
    }
    at += length + 12;
  }
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const channels = { 2: 3, 6: 4 }[header[9]];
  if (header[8] !== 8 || channels === undefined || header[12] !== 0) {
    throw new Error("only PNGs of 8 bits a colour, not interlaced");
  }
  return { width, height, pixels: unfiltered(inflateSync(Buffer.concat(data)), width, height, channels) };
}

function unfiltered(raw, width, height, channels) {
  const stride = width * channels;
  const bytes = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const left = x >= channels ? bytes[y * stride + x - channels] : 0;
      const above = y > 0 ? bytes[(y - 1) * stride + x] : 0;
      const corner = x >= channels && y > 0 ? bytes[(y - 1) * stride + x - channels] : 0;
      bytes[y * stride + x] = raw[y * (stride + 1) + 1 + x] + predicted(filter, left, above, corner);
    }
  }
  const pixels = Buffer.alloc(width * height * 3);
  for (let i = 0; i < width * height; ++i) {
    bytes.copy(pixels, i * 3, i * channels, i * channels + 3);
  }
  return pixels;
}

function predicted(filter, left, above, corner) {
  if (filter === 4) {
    const [a, b, c] = [left, above, corner].map((x) => Math.abs(left + above - corner - x));
    return a <= b && a <= c ? left : b <= c ? above : corner;
  }
  return [0, left, above, (left + above) >> 1][filter];
}

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) {
      crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
    }
  }
  return (crc ^ 0xffffffff) >>> 0;
}

function chunk(type, content) {
  const bytes = Buffer.concat([Buffer.alloc(4), Buffer.from(type, "latin1"), content, Buffer.alloc(4)]);
  bytes.writeUInt32BE(content.length, 0);
  bytes.writeUInt32BE(crc32(bytes.subarray(4, bytes.length - 4)), bytes.length - 4);
  return bytes;
}

export function encode({ width, height, pixels }) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 2, 0, 0, 0], 8);
  const stride = width * 3;
  const raw = Buffer.alloc((stride + 1) * height);
  for (let y = 0; y < height; ++y) {
    // Filter 1, each pixel minus the pixel before it, halves the size of the file.
    raw[y * (stride + 1)] = 1;
    for (let x = 0; x < stride; ++x) {
      raw[y * (stride + 1) + 1 + x] = pixels[y * stride + x] - (x >= 3 ? pixels[y * stride + x - 3] : 0);
    }
  }
  return Buffer.concat([signature, chunk("IHDR", header), chunk("IDAT", deflateSync(raw, { level: 9 })),
    chunk("IEND", Buffer.alloc(0))]);
}

/** The picture with the mean of each square of `factor` × `factor` pixels as one pixel. */
export function shrunk({ width, height, pixels }, factor) {
  const [w, h] = [Math.floor(width / factor), Math.floor(height / factor)];
  const result = Buffer.alloc(w * h * 3);
  for (let y = 0; y < h; ++y) {
    for (let x = 0; x < w * 3; ++x) {
      let sum = 0;
      for (let n = 0; n < factor * factor; ++n) {
        const [row, column] = [y * factor + Math.floor(n / factor), Math.floor(x / 3) * factor + n % factor];
        sum += pixels[(row * width + column) * 3 + x % 3];
      }
      result[y * w * 3 + x] = Math.round(sum / factor ** 2);
    }
  }
  return { width: w, height: h, pixels: result };
}
