// SPDX-License-Identifier: Apache-2.0
import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Studio } from "../studio/studio";

export const StudioContext = createContext<Studio | null>(null);

/** The studio that this component is part of. */
export function useStudio(): Studio {
  const studio = useContext(StudioContext);
  if (studio === null) throw new Error("no studio above this component");
  return studio;
}
