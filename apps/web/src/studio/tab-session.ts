// SPDX-License-Identifier: Apache-2.0

const key = "inkflate.session";

/** Which drawing this tab is at: it outlives a reload, and no other tab has it. */
export const tabSession = {
  kept(): string | null {
    try {
      return sessionStorage.getItem(key);
    } catch {
      return null;
    }
  },
  keep(session: string): void {
    try {
      sessionStorage.setItem(key, session);
    } catch {
      // Without it, a reload finds the drawing as any new tab does.
    }
  },
};
