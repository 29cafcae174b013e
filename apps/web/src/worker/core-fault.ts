// SPDX-License-Identifier: Apache-2.0

/** The core has found a fault of its own and stopped. Nothing can be asked of it any more. */
export class CoreFault extends Error {
  override readonly name = "CoreFault";
}
