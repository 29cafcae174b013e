// SPDX-License-Identifier: Apache-2.0
import type { StudioRequest } from "../protocol/messages";
import type { Studio } from "./studio";

/** Does what the core leaves to the studio: what needs a window around it. */
export function takeRequest(studio: Studio, request: StudioRequest): void {
  switch (request) {
    case "open":
      studio.onOpen("open");
      return;
    case "open_template":
      studio.onOpen("template");
      return;
    case "export":
    case "help":
    case "palette":
      studio.panel.value = request;
      return;
  }
}
