// SPDX-License-Identifier: Apache-2.0

/** Hands over at most one value for each picture that the screen shows, the newest; `flush` hands it over now. */
export interface EachFrame<T> {
  readonly put: (value: T) => void;
  readonly flush: () => void;
}

export function eachFrame<T>(
  take: (value: T) => void,
  ask: (run: () => void) => void = requestAnimationFrame,
): EachFrame<T> {
  let waiting: { readonly value: T } | null = null;
  const flush = () => {
    const last = waiting;
    waiting = null;
    if (last !== null) take(last.value);
  };
  return {
    put(value) {
      if (waiting === null) ask(flush);
      waiting = { value };
    },
    flush,
  };
}
