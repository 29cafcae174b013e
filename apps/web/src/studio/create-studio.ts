// SPDX-License-Identifier: Apache-2.0
import { effect } from "@preact/signals";
import { keepStorage } from "../storage/keep-storage";
import { LiveStudio, type StudioOptions } from "./live-studio";
import type { Studio } from "./studio";

/** The core speaks the language and knows the keys that the person has chosen; a core that starts is told by itself. */
function tellPreferences(studio: Studio): void {
  const { language, singleKeys } = studio.preferences;
  let isFirst = true;
  effect(() => {
    const wanted = language.value;
    const keys = singleKeys.value;
    if (!isFirst) {
      studio.act("language", wanted);
      studio.act("single_keys", keys);
    }
    isFirst = false;
  });
}

/** Browsers that ask the person whether a page may keep its data should do so when there is something to keep. */
function keepWhatIsDrawn(studio: Studio): void {
  let isAsked = false;
  effect(() => {
    if (isAsked || studio.state.value.isBlank) return;
    isAsked = true;
    void keepStorage();
  });
}

/** Puts the studio together and starts its core. */
export function createStudio(options: StudioOptions): Studio {
  const studio = new LiveStudio(options);
  tellPreferences(studio);
  keepWhatIsDrawn(studio);
  studio.start();
  return studio;
}
