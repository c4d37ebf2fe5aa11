// SPDX-License-Identifier: BSL-1.0

/** The bytes of a text in base64. */
export function bytes_of(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** The bytes that come out of a stream. Throws an Error if there are more than `most`. */
async function through(stream, bytes, most = Infinity) {
  const parts = [];
  let size = 0;
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value);
    size += part.value.length;
    if (size > most) {
      await reader.cancel();
      throw new Error(`more than ${most} bytes`);
    }
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

export const packed = (bytes) => through(new CompressionStream('gzip'), bytes);
export const unpacked = (bytes, most) => through(new DecompressionStream('gzip'), bytes, most);
