// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/rest_model.h"
#include "web/bindings/answer.h"

namespace inkflate::web {

/// ModelMesh of src/protocol/scene.ts: triangles with their own corners. texture: null: none.
Json mesh_json(RestModel const& model, Texture const* texture, BlobWriter& blobs);

}  // namespace inkflate::web
