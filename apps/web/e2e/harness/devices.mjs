// SPDX-License-Identifier: Apache-2.0
// What the studio is tried on.

export const devices = {
  wide: { viewport: { width: 1440, height: 900 } },
  laptop: { viewport: { width: 1024, height: 768 } },
  tablet: { viewport: { width: 1180, height: 820 }, hasTouch: true },
  phone: { viewport: { width: 390, height: 844 }, hasTouch: true },
  "lying phone": { viewport: { width: 844, height: 390 }, hasTouch: true },
  /** 1280 px at 400 %: the least that has to work (WCAG 1.4.10). */
  "small phone": { viewport: { width: 320, height: 568 }, hasTouch: true },
};
