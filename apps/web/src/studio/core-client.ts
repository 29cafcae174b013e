// SPDX-License-Identifier: Apache-2.0
import type { CoreEvent, ResizeInput } from "../protocol/events";
import type { FromWorker, StartWith, ToWorker } from "../protocol/messages";
import type { Language } from "../protocol/state";
import { Unanswered } from "./unanswered";

/** A worker as the client sees it; tests give their own. */
export interface CorePort {
  post(message: ToWorker, transfer?: Transferable[]): void;
  end(): void;
}

export interface CoreClientOptions {
  /** Starts a worker that calls back with its messages, or with a fault when it could not even load. */
  startWorker(listen: (message: FromWorker) => void): CorePort;
  /** Asked for at each start. */
  loadCore(): Promise<WebAssembly.Module>;
  language(): Language;
  /** Of the window as it is now. */
  view(): ResizeInput;
  onMessage(message: FromWorker): void;
  /** A worker has started. Events sent from here come before all others. */
  onStart(): void;
  /** The core stops again and again, whatever is opened. */
  onHopeless(why: string): void;
  nowMs(): number;
}

/** More faults than this within the time below: what is opened brings them on. */
const mostFaults = 2;
const faultsWithinMs = 20_000;

/** Keeps a worker with the core running: starts it, numbers what is sent, starts it anew after a fault from what was kept. */
export class CoreClient {
  private port: CorePort | null = null;
  /** Whether the worker has its first message; until then events wait. */
  private isTold = false;
  private sequence = 0;
  private waiting: CoreEvent[] = [];
  private readonly unanswered = new Unanswered();
  private session: string | null = null;
  private faults: number[] = [];

  constructor(private readonly options: CoreClientOptions) {}

  /** The last event that was sent. */
  get lastSequence(): number {
    return this.sequence;
  }

  async start(startWith: StartWith): Promise<void> {
    this.port?.end();
    this.unanswered.take();
    // The worker's script is fetched while the core is.
    const port = this.options.startWorker((message) => {
      if (this.port === port) this.listen(message);
    });
    this.port = port;
    this.isTold = false;
    let wasm: WebAssembly.Module;
    try {
      wasm = await this.options.loadCore();
    } catch (error) {
      if (this.port === port) this.stop(String(error));
      return;
    }
    if (this.port !== port) return;
    this.isTold = true;
    const language = this.options.language();
    port.post({ kind: "start", wasm, startWith, language, view: this.options.view() });
    const early = this.waiting;
    this.waiting = [];
    this.options.onStart();
    this.waiting.push(...early);
    this.flush();
  }

  /** Events of one turn of the page go together. Returns the event's number. */
  send(event: CoreEvent): number {
    this.waiting.push(event);
    if (this.waiting.length === 1) {
      queueMicrotask(() => {
        this.flush();
      });
    }
    return ++this.sequence;
  }

  ask(message: ToWorker): void {
    if (this.isTold) this.port?.post(message);
  }

  /** Gives up what the core is at; all that was done before and since is kept. */
  restart(): void {
    this.waiting.unshift(...this.unanswered.take());
    void this.start(
      this.session === null ? { kind: "new" } : { kind: "session", session: this.session },
    );
  }

  private flush(): void {
    if (this.port === null || !this.isTold || this.waiting.length === 0) return;
    const events = this.waiting;
    this.waiting = [];
    const transfer = events.flatMap((event) => (event.type === "file" ? [event.bytes.buffer] : []));
    this.port.post({ kind: "events", events, sequence: this.sequence }, transfer);
    this.unanswered.sent(events, this.sequence);
  }

  private listen(message: FromWorker): void {
    if (message.kind === "ready") this.session = message.session;
    this.unanswered.heard(message);
    this.options.onMessage(message);
    if (message.kind === "fault") this.recover(message.why);
  }

  private recover(why: string): void {
    const now = this.options.nowMs();
    this.faults = [...this.faults.filter((time) => now - time < faultsWithinMs), now];
    if (this.faults.length <= mostFaults) {
      this.restart();
    } else if (this.session !== null) {
      // It is the drawing: leave it as it is, and begin another.
      this.session = null;
      this.unanswered.take();
      this.options.onHopeless(why);
      this.restart();
    } else {
      this.stop(why);
    }
  }

  private stop(why: string): void {
    this.port?.end();
    this.port = null;
    this.options.onHopeless(why);
  }
}
