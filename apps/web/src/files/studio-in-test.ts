// SPDX-License-Identifier: Apache-2.0
import { signal } from "@preact/signals";
import type { CoreMessage, Frame } from "../protocol/messages";
import type { EngineState } from "../protocol/state";
import { emptyState } from "../studio/empty-state";
import type { Notice, Studio } from "../studio/studio";

/** For tests: a studio that writes down what it is asked for, and whose core says what the test says. */
export class FakeStudio {
  readonly state = signal<EngineState>({ ...emptyState("en"), fileName: "drawing" });
  readonly calls: string[] = [];
  readonly told: Pick<Notice, "severity" | "text" | "remedy">[] = [];
  private readonly listeners = new Set<(frame: Frame) => void>();

  /** As far as files need one. */
  get studio(): Studio {
    const parts: Partial<Studio> = {
      state: this.state,
      word: (name, ...values) => [name, ...values].join(" "),
      label: (name) => name,
      act: (name) => this.calls.push(name),
      open: (file, use) => this.calls.push(`${use} ${file.name}`),
      notify: (severity, text, remedy = null) => this.told.push({ severity, text, remedy }),
      onFrame: (listener) => {
        this.listeners.add(listener);
        return () => this.listeners.delete(listener);
      },
    };
    return parts as Studio;
  }

  /** A frame of the core; the signals change after it. */
  frame(state: Partial<EngineState>, messages: readonly CoreMessage[] = []): void {
    const next = { ...this.state.peek(), ...state };
    const frame: Frame = {
      kind: "frame",
      sequence: 1,
      isAtRest: true,
      scene: null,
      state: next,
      messages,
      files: [],
      requests: [],
    };
    for (const listener of [...this.listeners]) listener(frame);
    this.state.value = next;
  }
}
