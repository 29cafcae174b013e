// SPDX-License-Identifier: Apache-2.0

/** The part of Trusted Types that is used; not every browser has it. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL: (url: string) => string },
  ): { createScriptURL(url: string): string };
}

/** Passes on an address of this very site; throws on any other. */
export function ownUrl(url: string, page: string): string {
  const whole = new URL(url, page);
  const own = new URL(page);
  if (whole.protocol !== own.protocol || whole.origin !== own.origin) {
    throw new Error(`not ours: ${whole.origin}`);
  }
  return whole.href;
}

function createPolicy(): { createScriptURL(url: string): string } {
  const rules = { createScriptURL: (url: string): string => ownUrl(url, location.href) };
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };
  return trustedTypes?.createPolicy("inkflate", rules) ?? rules;
}

let policy: { createScriptURL(url: string): string } | null = null;

/**
 * An address that scripts may be loaded from, as new Worker() and navigator.serviceWorker.register() want it where the page demands
 * Trusted Types. The one policy of that name; throws for another site's address.
 */
export function trustedScriptUrl(url: string): string {
  policy ??= createPolicy();
  return policy.createScriptURL(url);
}
