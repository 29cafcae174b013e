// SPDX-License-Identifier: Apache-2.0
import { positions, type Scale } from "./slider";

function clamped(value: number, least: number, most: number): number {
  return Math.min(Math.max(value, least), most);
}

/** Two digits are all that a hand can tell. */
function rounded(value: number): number {
  if (value >= 10) return Math.round(value);
  return value >= 1 ? Math.round(value * 10) / 10 : Number(value.toPrecision(2));
}

/** Equal ways are equal differences. */
export function evenScale(least: number, most: number): Scale {
  return {
    toPosition: (value) => (positions * (clamped(value, least, most) - least)) / (most - least),
    toValue: (position) => least + ((most - least) * position) / positions,
  };
}

/** Equal ways are equal ratios: fine where values are small. */
export function ratioScale(least: number, most: number): Scale {
  const ratio = most / least;
  return {
    toPosition: (value) =>
      (positions * Math.log(clamped(value, least, most) / least)) / Math.log(ratio),
    toValue: (position) => clamped(rounded(least * ratio ** (position / positions)), least, most),
  };
}
