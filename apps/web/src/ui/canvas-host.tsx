// SPDX-License-Identifier: Apache-2.0
import { useEffect, useRef } from "preact/hooks";
import "../styles/canvas-host.css";

/** Puts the canvases into their place. Returns how to take them away. */
export type MountCanvas = (host: HTMLElement) => () => void;

/** The window's whole ground. What it shows is not Preact's. */
export function CanvasHost({ mount }: { readonly mount: MountCanvas }) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => (host.current === null ? undefined : mount(host.current)), [mount]);
  return <div class="canvas-host" ref={host} />;
}
