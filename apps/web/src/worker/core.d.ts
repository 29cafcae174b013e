// SPDX-License-Identifier: Apache-2.0

/** The core as emscripten wraps it; its functions are those of bindings/core.cpp. */
declare module "#core" {
  /** Address in the core's memory; 0: null. */
  export type Address = number;

  export interface CoreExports {
    /** Views of the core's memory. They are others after a call in which it has grown. */
    readonly HEAPU8: Uint8Array;
    readonly HEAPU32: Uint32Array;
    _malloc(bytes: number): Address;
    _free(address: Address): void;

    _engine_new(): Address;
    _engine_delete(engine: Address): void;

    _engine_pointer(
      engine: Address,
      action: number,
      kind: number,
      id: number,
      button: number,
      x: number,
      y: number,
      pressure: number,
      timeS: number,
      modifiers: number,
    ): void;
    _engine_key(
      engine: Address,
      key: Address,
      keyBytes: number,
      isPress: number,
      isRepeat: number,
      timeS: number,
      modifiers: number,
    ): void;
    _engine_wheel(
      engine: Address,
      x: number,
      y: number,
      deltaX: number,
      deltaY: number,
      modifiers: number,
    ): void;
    _engine_gesture(
      engine: Address,
      x: number,
      y: number,
      scale: number,
      movedX: number,
      movedY: number,
    ): void;
    _engine_action(
      engine: Address,
      name: Address,
      nameBytes: number,
      argument: Address,
      argumentBytes: number,
    ): void;
    _engine_file(
      engine: Address,
      bytes: Address,
      byteCount: number,
      name: Address,
      nameBytes: number,
      use: number,
    ): void;
    _engine_resize(
      engine: Address,
      width: number,
      height: number,
      left: number,
      top: number,
      right: number,
      bottom: number,
    ): void;

    _engine_has_work(engine: Address): number;
    _engine_work(engine: Address): void;
    _engine_recover(
      engine: Address,
      journal: Address,
      bytes: number,
      name: Address,
      nameBytes: number,
    ): void;

    /** Each gives the address of an answer, of four numbers: head, its bytes, blobs, their bytes; 0: nothing to answer. */
    _engine_take_changes(engine: Address): Address;
    _engine_scene(engine: Address): Address;
    _engine_state(engine: Address): Address;
    _engine_actions(engine: Address): Address;
    _engine_thumbnail(engine: Address, layer: number, sizePx: number): Address;
    _engine_picture(engine: Address, sizePx: number): Address;
  }

  export interface CoreOptions {
    /** Called once instead of loading core.wasm: makes an instance and gives it to `receive`. Returns an empty object. */
    readonly instantiateWasm: (
      imports: WebAssembly.Imports,
      receive: (instance: WebAssembly.Instance) => void,
    ) => object;
    readonly onProgress: (stage: string, share: number) => void;
    /** Lines that the core writes before it stops. */
    readonly printErr: (line: string) => void;
  }

  const createCore: (options: CoreOptions) => Promise<CoreExports>;
  export { createCore as default };
}
