// SPDX-License-Identifier: Apache-2.0
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";

/**
 * Tells css how far an element at the window's edge reaches in, as --head or --foot: bars take one row or two, and what floats next
 * to them goes by that.
 */
export function useEdgeHeight<T extends HTMLElement>(edge: "head" | "foot"): RefObject<T> {
  const bar = useRef<T>(null);
  useEffect(() => {
    const element = bar.current;
    if (element === null) return undefined;
    const tell = () => {
      const box = element.getBoundingClientRect();
      const height = edge === "head" ? box.bottom : window.innerHeight - box.top;
      document.documentElement.style.setProperty(`--${edge}`, `${height}px`);
    };
    const observer = new ResizeObserver(tell);
    observer.observe(element);
    window.addEventListener("resize", tell);
    return () => {
      observer.disconnect();
      window.removeEventListener("resize", tell);
    };
  }, [edge]);
  return bar;
}
