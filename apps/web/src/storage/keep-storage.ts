// SPDX-License-Identifier: Apache-2.0

/**
 * Asks the browser not to clear our data when the device runs low. For the page, once something is drawn: browsers that ask the
 * person do so then, and with reason. Whether they will be kept.
 */
export async function keepStorage(): Promise<boolean> {
  try {
    return (await navigator.storage.persisted()) || (await navigator.storage.persist());
  } catch {
    return false;
  }
}
