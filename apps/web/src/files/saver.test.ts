// SPDX-License-Identifier: Apache-2.0
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { FakeStudio } from "./studio-in-test";
import { Saver } from "./saver";

const out = { name: "drawing.inkflate", bytes: new Uint8Array([1, 2, 3]) };
let fake: FakeStudio;
let saver: Saver;
/** Names of the files that were written, and how often was asked for one. */
let written: string[];
let asked: number;
let picker: () => Promise<FileSystemFileHandle>;

/** A file that takes everything, or fails as browsers do. */
function handleOf(name: string, fault?: string): FileSystemFileHandle {
  const stream = {
    write: () =>
      fault === undefined ? Promise.resolve() : Promise.reject(new DOMException("no", fault)),
    close: () => Promise.resolve(written.push(name)),
    abort: () => Promise.resolve(),
  };
  return { name, createWritable: () => Promise.resolve(stream) } as unknown as FileSystemFileHandle;
}

beforeEach(() => {
  fake = new FakeStudio();
  saver = new Saver(fake.studio);
  fake.studio.onFrame((frame) => {
    saver.see(frame);
  });
  written = [];
  asked = 0;
  picker = () => Promise.resolve(handleOf("mine.inkflate"));
  vi.stubGlobal("window", {
    showSaveFilePicker: () => {
      asked += 1;
      return picker();
    },
  });
});

afterEach(() => {
  vi.unstubAllGlobals();
});

describe("saving the project", () => {
  it("asks once where to, and goes there again", async () => {
    await saver.saveProject(out);
    fake.frame({ undo: "brush" });
    await saver.saveProject(out);
    expect([asked, written]).toEqual([1, ["mine.inkflate", "mine.inkflate"]]);
  });

  it.each([
    ["a new drawing", { undo: "new" as const }],
    ["another file", { undo: "open" as const, fileName: "other" }],
    ["the drawing before the opened one", { undo: "brush" as const, redo: "open" as const }],
  ])("asks again for %s", async (_name, state) => {
    await saver.saveProject(out);
    fake.frame(state);
    await saver.saveProject(out);
    expect(asked).toBe(2);
  });

  it("goes to the file that was opened, once the core shows what is in it", async () => {
    saver.opening(handleOf("crab.inkflate"));
    fake.frame({ undo: "brush" });
    fake.frame({ undo: "open", fileName: "crab" });
    await saver.saveProject(out);
    expect([asked, written]).toEqual([0, ["crab.inkflate"]]);
  });

  it("never goes over a file of another format", async () => {
    saver.opening(handleOf("crab.svg"));
    fake.frame({ undo: "open", fileName: "crab" });
    await saver.saveProject(out);
    expect(written).toEqual(["mine.inkflate"]);
  });

  it("says nothing when the person changes their mind", async () => {
    picker = () => Promise.reject(new DOMException("", "AbortError"));
    await saver.saveProject(out);
    expect([fake.told, written]).toEqual([[], []]);
  });

  it("waits for another press where the browser wants one", async () => {
    picker = () => Promise.reject(new DOMException("", "SecurityError"));
    await saver.saveProject(out);
    picker = () => Promise.resolve(handleOf("mine.inkflate"));
    fake.told[0]?.remedy?.run();
    await vi.waitFor(() => {
      expect(written).toEqual(["mine.inkflate"]);
    });
  });

  it.each([
    ["QuotaExceededError", "save_full"],
    ["NotAllowedError", "save_forbidden"],
    ["NotFoundError", "save_gone"],
    ["NoModificationAllowedError", "save_locked"],
    ["UnknownError", "save_unknown"],
  ])("tells why it failed, and offers a download: %s", async (fault, reason) => {
    picker = () => Promise.resolve(handleOf("mine.inkflate", fault));
    await saver.saveProject(out);
    expect(fake.told.map(({ severity, text }) => [severity, text])).toEqual([
      ["problem", `file_not_saved mine.inkflate ${reason}`],
    ]);
    expect(fake.told[0]?.remedy?.label).toBe("download_instead");
  });
});

describe("saving a copy", () => {
  it("leaves the project's file alone", async () => {
    await saver.saveProject(out);
    picker = () => Promise.resolve(handleOf("model.glb"));
    await saver.saveCopy({ ...out, name: "model.glb" });
    await saver.saveProject(out);
    expect(written).toEqual(["mine.inkflate", "model.glb", "mine.inkflate"]);
  });
});
