// SPDX-License-Identifier: Apache-2.0
import { existsSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { actionNames } from "../protocol/actions.generated";
import { readDrawList, type DrawItem } from "../protocol/draw-list";
import type { SceneUpdate } from "../protocol/scene";
import { Artist, coreFolder } from "./artist";
import { CoreFault } from "./core-fault";

const isBuilt = existsSync(new URL("core.wasm", coreFolder));

function items(scene: SceneUpdate): DrawItem[] {
  return scene.chunks.flatMap(({ list }) => (list === null ? [] : readDrawList(list)));
}

function text(bytes: Uint8Array, count: number): string {
  return new TextDecoder("latin1").decode(bytes.subarray(0, count));
}

describe.skipIf(!isBuilt)("the engine over WebAssembly", () => {
  test("a sheet without anything is blank", async () => {
    const { engine } = await Artist.start();
    const state = engine.state();
    expect(state).toMatchObject({ mode: "draw", tool: "brush", isBlank: true, undo: null });
    expect(engine.picture(100)).toBeNull();
    expect(engine.thumbnail(1, 64)).toBeNull();
    expect(engine.actions().map((row) => row.name)).toEqual(actionNames);
  });

  test("strokes become a filled part", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 200);
    expect(artist.engine.state().hasRoughStrokes).toBe(true);
    artist.act("simplify");
    const changes = artist.changes();
    expect(changes.messages.map((message) => message.severity)).toEqual(["status"]);
    expect(changes.journal.length).toBeGreaterThan(100);
    const [layer] = artist.engine.state().layers;
    expect(layer).toMatchObject({ isHidden: false, fill: null });
    const skin = items(artist.engine.scene()).filter((item) => item.kind === "fill");
    expect(skin).toHaveLength(1);
    expect(skin[0]?.contours[0]?.length).toBeGreaterThan(50);
    expect(artist.stages).toContain("fit");
    expect(artist.shares.every((share) => share >= 0 && share <= 1)).toBe(true);
  });

  test("chunks that the page has are not sent again", async () => {
    const { engine } = await Artist.start();
    const first = engine.scene().chunks;
    const second = engine.scene().chunks;
    expect(first.every((chunk) => chunk.list !== null)).toBe(true);
    expect(second.map((chunk) => chunk.id)).toEqual(first.map((chunk) => chunk.id));
    expect(second.every((chunk) => chunk.list === null)).toBe(true);
  });

  test("a part is inflated, and its mesh sent once", async () => {
    const artist = await Artist.start();
    artist.circle(400, 500, 200);
    artist.act("simplify");
    artist.act("mode_inflate");
    artist.work();
    const model = artist.engine.scene().model;
    const mesh = model?.mesh;
    if (!model || !mesh) throw new Error("no model");
    expect(mesh.positions.length % 9).toBe(0);
    expect(mesh.positions.length).toBeGreaterThan(9 * 100);
    expect(mesh.normals).toHaveLength(mesh.positions.length);
    expect(mesh.places).toHaveLength((mesh.positions.length / 3) * 2);
    expect(mesh.texture).toHaveLength(4 * mesh.textureWidth * mesh.textureHeight);
    const numbers = [...mesh.positions, ...mesh.normals, ...mesh.places, ...model.toView];
    expect(numbers.every(Number.isFinite)).toBe(true);
    // Drawn around (400, 500), it stands in the middle; on the paper it lies where it was drawn.
    const [, , , x = 0, , , , y = 0] = model.onPaper;
    expect([x, y]).toEqual([500, 500]);
    expect(model.shadow).toMatchObject({ x: expect.closeTo(500, 0) as number });
    expect(artist.engine.scene().model).toMatchObject({ id: model.id, mesh: null });
  });

  test("a model is exported", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 200);
    artist.act("simplify");
    artist.act("export_as", "glb");
    const [file] = artist.changes().files;
    if (!file) throw new Error("no file");
    expect(file.name).toBe("drawing.glb");
    expect(text(file.bytes, 4)).toBe("glTF");
  });

  test("a journal gives the drawing back", async () => {
    const before = await Artist.start();
    before.circle(500, 500, 200);
    before.act("simplify");
    before.circle(500, 200, 60);
    const { journal } = before.changes();
    const after = await Artist.start();
    after.engine.recover(journal, "cat");
    const changes = after.changes();
    expect(changes.isRecoveredWhole).toBe(true);
    expect(changes.isJournalNew).toBe(true);
    expect(changes.journal).toEqual(journal);
    const saved = (artist: Artist) => {
      artist.act("save");
      return artist.changes().files;
    };
    const bytesOf = (artist: Artist) => saved(artist).map(({ bytes }) => bytes);
    expect(bytesOf(after)).toEqual(bytesOf(before));
    expect(after.engine.state()).toMatchObject({ undo: "brush", fileName: "cat" });
  });

  test("a torn journal gives back what is whole", async () => {
    const before = await Artist.start();
    before.circle(500, 500, 200);
    const { journal } = before.changes();
    const after = await Artist.start();
    after.engine.recover(journal.subarray(0, journal.length - 5), "");
    expect(after.changes().isRecoveredWhole).toBe(false);
    expect(after.engine.state().hasRoughStrokes).toBe(true);
  });

  test("files come in, whatever their names are", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 200);
    artist.act("export_as", "svg");
    const [file] = artist.changes().files;
    if (!file) throw new Error("no file");
    artist.act("new");
    artist.engine.handle({ type: "file", bytes: file.bytes, name: "žába.svg", use: "open" });
    expect(artist.engine.state()).toMatchObject({ fileName: "žába", isBlank: false });
    artist.engine.handle({ type: "file", bytes: new Uint8Array(), name: "", use: "open" });
    expect(artist.changes().messages.at(-1)?.severity).toBe("problem");
  });

  test("parts and the drawing have pictures", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 200);
    artist.act("simplify");
    const [layer] = artist.engine.state().layers;
    const picture = artist.engine.thumbnail(layer?.id ?? 0, 48);
    expect(picture).toMatchObject({ width: 48, height: 48 });
    const alpha = (x: number, y: number) => picture?.pixels[4 * (48 * y + x) + 3];
    expect([alpha(0, 0), alpha(24, 24)]).toEqual([0, 255]);
    expect(text(artist.engine.picture(100) ?? new Uint8Array(), 4)).toBe("\u0089PNG");
  });

  test("answers stay right when the memory grows within a call", async () => {
    const artist = await Artist.start();
    artist.circle(500, 500, 200);
    artist.act("simplify");
    const before = artist.engine.state();
    // Larger than all of the memory that the core begins with.
    const bytes = new Uint8Array(40_000_000);
    artist.engine.handle({ type: "file", bytes, name: "zeros", use: "open" });
    expect(artist.changes().messages.at(-1)?.severity).toBe("problem");
    expect(artist.engine.state()).toEqual(before);
  });

  test("after a trap every call is a fault", async () => {
    const { engine } = await Artist.start();
    // More than the core's memory may ever hold.
    const bytes = { length: 2 ** 32 - 1 } as Uint8Array;
    const open = () => {
      engine.handle({ type: "file", bytes, name: "large", use: "open" });
    };
    expect(open).toThrow(CoreFault);
    expect(() => engine.state()).toThrow(CoreFault);
  });

  test("no code is made from text, which the content policy forbids", () => {
    const glue = readFileSync(new URL("core.js", coreFolder), "utf8");
    expect(glue).not.toMatch(/new Function|\beval\b|import\.meta/);
  });
});
