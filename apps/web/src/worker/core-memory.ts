// SPDX-License-Identifier: Apache-2.0
import type { Address, CoreExports } from "#core";
import { Answer } from "./answer";

const answerWords = 4;

/** Bytes that lie in the core's memory during one call. */
export interface Placed {
  readonly address: Address;
  readonly bytes: number;
}

/**
 * What goes into and out of the memory of the core. It may grow in any call, so its views are looked up again each time, and nothing
 * outside holds one.
 */
export class CoreMemory {
  private readonly encoder = new TextEncoder();
  private readonly decoder = new TextDecoder();

  constructor(private readonly core: CoreExports) {}

  /** Lays bytes or texts into the memory, calls with where they are, and takes them away again. */
  with(contents: readonly (Uint8Array | string)[], call: (...placed: Placed[]) => void): void {
    const placed = contents.map((content) => this.place(content));
    call(...placed);
    for (const { address } of placed) this.core._free(address);
  }

  /** The answer at an address; null at 0. */
  answer<Head>(address: Address): Answer<Head> | null {
    if (address === 0) return null;
    const first = address / Uint32Array.BYTES_PER_ELEMENT;
    const words = this.core.HEAPU32.slice(first, first + answerWords);
    const [head = 0, headBytes = 0, blobs = 0, blobBytes = 0] = words;
    const bytes = this.core.HEAPU8;
    const text = this.decoder.decode(bytes.subarray(head, head + headBytes));
    return new Answer(JSON.parse(text) as Head, bytes.slice(blobs, blobs + blobBytes).buffer);
  }

  private place(content: Uint8Array | string): Placed {
    const bytes = typeof content === "string" ? this.encoder.encode(content) : content;
    // At least one byte: of none, malloc may give the address 0.
    const address = this.core._malloc(Math.max(bytes.length, 1));
    if (address === 0) throw new Error(`no memory for ${bytes.length} bytes`);
    this.core.HEAPU8.set(bytes, address);
    return { address, bytes: bytes.length };
  }
}
