// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pipeline/bend_joints.h"
#include "pipeline/bend_part.h"
#include "pipeline/bend_rig.h"

namespace inkflate {

/// The parts of a document at rest, kept over the documents that come of it. A copy has the same parts.
class BendRests {
 public:
  /// Takes another document: its layers are versions of parts that are known, or new parts. Of those, the ones that lie at rest in a copy of
  /// these rests, which has met documents that these have not, keep the meshes that they have there.
  void meet(Document const& document) { meet(document, *this); }
  void meet(Document const& document, BendRests const& copy);

  /// What was dragged by a place that no pin holds would spring back as soon as anything else is held: where that happens next, its shape
  /// now is its rest. But what is taken by the same place again goes on from the rest that it had, so that it can be dragged back.
  ///
  /// held: the part that is taken now, a layer or the stroke; by: the place, none: by a pin. in: the document that was met last
  void set_loose_ends(Document const& document, BendSource const& held, std::optional<Vec2> by);

  /// Makes the mesh of one more part, so that a press finds it, whatever place it takes. in: the document that was met last; out: false when
  /// there is no more to do
  /// cost    that of Bender::make, or of BendJoints::meet
  bool prepare(Document const& document, BendOptions const& options);

  /// Whether a layer joins another one in a document, as it lies there. cost: that of BendJoints::find
  bool is_limb(Document const& document, LayerId layer) { return joints_.is_limb(document, layer); }

  /// A part to be held by hand, ready to be bent. in: the document that was met last
  /// errors  BadInput (no such layer or stroke; hidden or locked), NothingThere (a layer without outlines), those of Bender::make
  Result<BendRoot> root(Document const& document, LayerId layer, BendOptions const& options);
  Result<BendRoot> root(Document const& document, StrokeRef const& stroke,
                        BendOptions const& options);

  /// These parts and all that hang on them. What cannot be bent stays. They have to be of the document that was met last.
  BendRig rig(Document const& document, std::vector<BendRoot> const& roots,
              BendOptions const& options);

 private:
  /// Parts and what joins them.
  struct Joined {
    BendParts parts;
    BendJoints joints;
  };

  std::optional<Error> make_ready(BendPart& part, BendOptions options) const;
  bool prepare_one(Document const& document, BendParts const& parts,
                   BendOptions const& options) const;
  bool prepare_anew(Document const& document, BendOptions const& options);

  double least_edge_px_ = 0;  // of all parts
  BendParts parts_;
  std::vector<std::shared_ptr<BendPart>> strokes_;  // the newest last
  BendJoints joints_;
  std::optional<Joined> anew_;  // once all that is left loose begins anew; none: not looked for
};

}  // namespace inkflate
