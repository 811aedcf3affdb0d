// SPDX-License-Identifier: MIT
// Reads the PNG files that the program writes: 8 bits for each channel, without interlacing.
import { inflateSync } from "node:zlib";

/** @param {Buffer} file @returns {{width: number, height: number, pixels: Uint8Array}} red, green, blue, alpha */
export function decoded(file) {
  const [width, height] = [file.readUInt32BE(16), file.readUInt32BE(20)], [depth, colour, , , interlace] = file.subarray(24, 29);
  const channels = { 2: 3, 6: 4 }[colour];
  if (depth !== 8 || !channels || interlace !== 0) throw new Error("another kind of PNG");
  const parts = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at))
    if (file.toString("latin1", at + 4, at + 8) === "IDAT") parts.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  const raw = inflateSync(Buffer.concat(parts)), stride = width * channels, rows = new Uint8Array(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const to = y * stride + x, left = x < channels ? 0 : rows[to - channels], above = y === 0 ? 0 : rows[to - stride];
      const corner = x < channels || y === 0 ? 0 : rows[to - stride - channels], guess = left + above - corner;
      const [a, b, c] = [left, above, corner].map((value) => Math.abs(guess - value));
      const nearest = a <= b && a <= c ? left : b <= c ? above : corner;
      rows[to] = raw[y * (stride + 1) + 1 + x] + [0, left, above, (left + above) >> 1, nearest][filter];
    }
  }
  const pixels = new Uint8Array(4 * width * height).fill(255);
  for (let i = 0; i < width * height; ++i) pixels.set(rows.subarray(i * channels, (i + 1) * channels), 4 * i);
  return { width, height, pixels };
}

/** As barycage_hash(), of opaque pixels. @param {Uint8Array} pixels */
export function hashOf(pixels) {
  let hash = 14695981039346656037n;
  for (let i = 0; i < pixels.length; i += 4)
    for (const byte of [pixels[i + 2], pixels[i + 1], pixels[i], pixels[i + 3]])
      hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 1099511628211n);
  return hash.toString(16).padStart(16, "0");
}
