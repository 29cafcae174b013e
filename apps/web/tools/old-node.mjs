// SPDX-License-Identifier: Apache-2.0
// For the tests: what browsers have and Debian 12's nodejs (18) has not as a global.
import { File } from "node:buffer";
import { webcrypto } from "node:crypto";

globalThis.File ??= File;
globalThis.crypto ??= webcrypto;
