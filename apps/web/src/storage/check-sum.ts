// SPDX-License-Identifier: Apache-2.0

/** The polynomial of zip and PNG, bits reversed. */
const polynomial = 0xedb88320;

const table = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; ++bit) rest = rest & 1 ? (rest >>> 1) ^ polynomial : rest >>> 1;
  return rest;
});

function add(sum: number, bytes: Uint8Array): number {
  let rest = sum;
  for (const byte of bytes) rest = (rest >>> 8) ^ (table[(rest ^ byte) & 0xff] ?? 0);
  return rest;
}

/** CRC-32 of the texts' UTF-8 and the bytes: one flipped bit, or a burst of up to 32, always changes it. */
export function checkSum(name: string, bytes: Uint8Array): number {
  return (add(add(0xffffffff, new TextEncoder().encode(name)), bytes) ^ 0xffffffff) >>> 0;
}
