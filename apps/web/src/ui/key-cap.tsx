// SPDX-License-Identifier: Apache-2.0
import type { ActionName } from "../protocol/actions.generated";
import "../styles/controls.css";
import { useStudio } from "./studio-context";

/** The key of an action, as printed on a key; nothing when it has none. */
export function KeyCap({ action }: { readonly action: ActionName }) {
  const chord = useStudio().chord(action);
  return chord === "" ? null : <kbd class="key-cap">{chord}</kbd>;
}
