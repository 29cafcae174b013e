// SPDX-License-Identifier: Apache-2.0

/** A blob as the head of an answer names it: its first byte and how many they are. */
export type BlobPlace = readonly [start: number, bytes: number];

/** What comes out of the core (bindings/answer.h), copied out of its memory. All blobs lie in one buffer. */
export class Answer<Head> {
  constructor(
    readonly head: Head,
    private readonly blobs: ArrayBuffer,
  ) {}

  /** A view of the blobs that all share. */
  bytes([start, bytes]: BlobPlace): Uint8Array {
    return new Uint8Array(this.blobs, start, bytes);
  }

  floats([start, bytes]: BlobPlace): Float32Array {
    return new Float32Array(this.blobs, start, bytes / Float32Array.BYTES_PER_ELEMENT);
  }

  /** The bytes with a buffer of their own. */
  ownBytes([start, bytes]: BlobPlace): Uint8Array {
    return new Uint8Array(this.blobs.slice(start, start + bytes));
  }
}
