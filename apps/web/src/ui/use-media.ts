// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";

export const narrowWindow = "(width < 900px)";
export const coarsePointer = "(pointer: coarse)";

/** Whether a media query holds now. */
export function useMedia(query: string): boolean {
  const [doesMatch, setDoesMatch] = useState(() => matchMedia(query).matches);
  useEffect(() => {
    const list = matchMedia(query);
    const onChange = () => {
      setDoesMatch(list.matches);
    };
    onChange();
    list.addEventListener("change", onChange);
    return () => {
      list.removeEventListener("change", onChange);
    };
  }, [query]);
  return doesMatch;
}
