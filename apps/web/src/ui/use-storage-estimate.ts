// SPDX-License-Identifier: Apache-2.0
import { useEffect, useState } from "preact/hooks";

export interface StorageFacts {
  readonly usedBytes: number;
  /** The browser has promised not to clear it by itself. */
  readonly isPersistent: boolean;
}

async function ask(): Promise<StorageFacts | null> {
  try {
    const [{ usage }, isPersistent] = await Promise.all([
      navigator.storage.estimate(),
      navigator.storage.persisted(),
    ]);
    return { usedBytes: usage ?? 0, isPersistent };
  } catch {
    return null;
  }
}

/** What this browser keeps for the studio; null: it does not say. */
export function useStorageEstimate(): StorageFacts | null {
  const [facts, setFacts] = useState<StorageFacts | null>(null);
  useEffect(() => {
    let isWanted = true;
    void ask().then((answer) => {
      if (isWanted) setFacts(answer);
    });
    return () => {
      isWanted = false;
    };
  }, []);
  return facts;
}
