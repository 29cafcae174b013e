// SPDX-License-Identifier: Apache-2.0
import type { GpuModel } from "./gpu-model";
import { standing } from "./pose";
import type { PartPose, Pose } from "./pose";
import type { Program } from "./program";

function setPart(program: Program, part: PartPose): void {
  program.set("u_inflation", part.inflation);
  program.set("u_lift_px", part.liftPx);
  program.set("u_sheet_px", part.sheetPx);
}

/** Draws a model in its pose with a program of model.vert.glsl. */
export function drawPosed(
  gl: WebGL2RenderingContext,
  program: Program,
  model: GpuModel,
  pose: Pose,
): void {
  program.use({ u_to_clip: pose.toClip, u_turn: pose.turn });
  gl.frontFace(pose.isMirrored ? gl.CW : gl.CCW);
  const { parts } = pose;
  if (parts) {
    model.drawParts((part) => {
      setPart(program, parts(part));
    });
  } else {
    setPart(program, standing);
    model.draw();
  }
}
