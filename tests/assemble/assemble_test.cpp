// SPDX-License-Identifier: Apache-2.0
#include "assemble/assemble.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "geometry/crossings.h"
#include "support/characters.h"
#include "support/surfaces.h"

namespace inkflate {
namespace {

FlatModel assembled(Drawing const& drawing, AssembleOptions const& options = {}) {
  auto model = assemble(drawing, options);
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return model ? std::move(*model) : FlatModel{};
}

int joint_count(FlatModel const& model, Joint::Kind kind) {
  return static_cast<int>(std::count_if(model.joints.begin(), model.joints.end(),
                                        [&](Joint const& joint) { return joint.kind == kind; }));
}

Layer body() { return drawn_layer("body", ellipse_contour({500, 450}, 200, 250)); }

TEST(Assemble, AClosedShapeBecomesASphere) {
  auto const model = assembled(drawing_of({body()}));
  auto const found = sound_surface(model);
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.euler, 2);
  EXPECT_TRUE(model.joints.empty());
}

TEST(Assemble, AHoleMakesARing) {
  auto const found =
      sound_surface(assembled(drawing_of({ring_layer("ring", {500, 500}, 120, 300)})));
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.genus, 1);
}

TEST(Assemble, BothSheetsHaveTheSameTrianglesAndShareTheDrawnRim) {
  auto const model = assembled(drawing_of({body()}));
  auto const& layer = model.layers[0];
  ASSERT_EQ(layer.sheets[0].size(), layer.mesh.triangles.size());
  for (std::size_t t = 0; t < layer.mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      bool const is_shared = layer.sheets[0][t][k] == layer.sheets[1][t][k];
      EXPECT_EQ(is_shared, layer.kinds[layer.mesh.triangles[t][k]] == VertexKind::Drawn);
    }
  }
}

TEST(Assemble, ALimbOverTheBodyJoinsItsFront) {
  auto const model = assembled(drawing_of({body(), limb_layer("arm", {600, 450}, {850, 500}, 40)}));
  ASSERT_EQ(model.joints.size(), 1U);
  auto const& joint = model.joints[0];
  EXPECT_EQ(joint.limb, 1);
  EXPECT_EQ(joint.host, 0);
  EXPECT_EQ(joint.side, Side::Front);
  auto const found = sound_surface(model);
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.genus, 0);
}

TEST(Assemble, ALimbBehindTheBodyJoinsItsBack) {
  auto const model = assembled(drawing_of({limb_layer("arm", {600, 450}, {850, 500}, 40), body()}));
  ASSERT_EQ(model.joints.size(), 1U);
  EXPECT_EQ(model.joints[0].side, Side::Back);
  EXPECT_EQ(sound_surface(model).shells, 1);
}

TEST(Assemble, ADuplicateBehindUsesTheSameSeam) {
  auto const limb = limb_layer("arm", {600, 450}, {850, 500}, 40);
  auto const model = assembled(drawing_of({limb, body(), limb}));
  ASSERT_EQ(model.joints.size(), 2U);
  EXPECT_EQ(model.joints[0].host_vertices, model.joints[1].host_vertices);
  EXPECT_EQ(sound_surface(model).shells, 1);
}

TEST(Assemble, CharactersAreOneSphere) {
  for (int const layers : {1, 3, 5, 21}) {
    auto const model = assembled(character(layers));
    auto const found = sound_surface(model);
    EXPECT_EQ(std::ssize(model.joints), layers - 1);
    EXPECT_EQ(found.shells, 1) << layers;
    EXPECT_EQ(found.genus, 0) << layers;
  }
}

TEST(Assemble, TheSeamLiesWhereTheLimbsMouthLies) {
  auto const model = assembled(character(5));
  for (auto const& joint : model.joints) {
    ASSERT_EQ(joint.limb_vertices.size(), joint.host_vertices.size());
    ASSERT_GE(joint.limb_vertices.size(), 3U);
    for (std::size_t k = 0; k < joint.limb_vertices.size(); ++k) {
      EXPECT_EQ(model.layers[joint.limb].mesh.points[joint.limb_vertices[k]],
                model.layers[joint.host].mesh.points[joint.host_vertices[k]]);
    }
  }
}

TEST(Assemble, ALimbThatEndsShortOfTheBodyIsPushedIntoIt) {
  // The body ends at x = 700; the mouth is at 712.
  auto const model = assembled(drawing_of({body(), limb_layer("arm", {712, 450}, {900, 450}, 40)}));
  ASSERT_EQ(model.joints.size(), 1U);
  for (int const v : model.joints[0].host_vertices) {
    EXPECT_LT(model.layers[0].mesh.points[v].x, 700);
  }
  EXPECT_EQ(sound_surface(model).shells, 1);
}

TEST(Assemble, ALimbFarFromTheBodyStaysAlone) {
  auto const model = assembled(drawing_of({body(), limb_layer("arm", {760, 450}, {900, 450}, 40)}));
  EXPECT_TRUE(model.joints.empty());
  EXPECT_TRUE(model.caps.empty());  // a closing that joins nothing is drawn
  EXPECT_EQ(sound_surface(model).shells, 2);
}

TEST(Assemble, AHelpLineThatJoinsNothingIsCapped) {
  auto const limb = limb_layer("arm", {300, 450}, {700, 450}, 40, RunKind::HelpLine);
  auto const model = assembled(drawing_of({limb}));
  EXPECT_FALSE(model.caps.empty());
  EXPECT_EQ(sound_surface(model).euler, 2);
}

TEST(Assemble, AHelpLineThatJoinsNothingMayStayAHole) {
  auto const limb = limb_layer("arm", {300, 450}, {700, 450}, 40, RunKind::HelpLine);
  auto const model = assembled(drawing_of({limb}), {.open = OpenRuns::Holes});
  EXPECT_TRUE(model.caps.empty());
  auto const found = check_mesh(surface_of(model));
  EXPECT_GT(found.boundary_edges, 0);
  EXPECT_EQ(found.non_manifold_edges, 0);
  EXPECT_EQ(found.euler, 1);
}

TEST(Assemble, CappedLimbsAreShellsOfTheirOwn) {
  auto const model = assembled(character(5), {.open = OpenRuns::Capped});
  EXPECT_TRUE(model.joints.empty());
  EXPECT_EQ(sound_surface(model).shells, 5);
}

TEST(Assemble, TwoHalfRingsBecomeATorus) {
  auto const model = assembled(drawing_of({half_ring_layer("above", {500, 500}, 120, 250, true),
                                           half_ring_layer("below", {500, 506}, 120, 250, false)}));
  EXPECT_EQ(joint_count(model, Joint::Kind::Mouth), 2);
  auto const found = sound_surface(model);
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.genus, 1);
}

TEST(Assemble, AHalfRingOnABodyIsAHandle) {
  auto const model =
      assembled(drawing_of({drawn_layer("cup", ellipse_contour({500, 700}, 350, 260)),
                            half_ring_layer("handle", {500, 600}, 120, 200, true)}));
  EXPECT_EQ(joint_count(model, Joint::Kind::Slit), 2);
  auto const found = sound_surface(model);
  EXPECT_EQ(found.shells, 1);
  EXPECT_EQ(found.genus, 1);
}

TEST(Assemble, AGapInAnOutlineIsNoMouth) {
  // An eye on the body whose outline the pen left open for a moment.
  auto eye = drawn_layer("eye", ellipse_contour({500, 400}, 40, 40));
  eye.outlines[0].pieces[3].kind = RunKind::Closing;
  eye.outlines[0].pieces[4].kind = RunKind::Closing;
  auto const model = assembled(drawing_of({body(), eye}));
  EXPECT_TRUE(model.joints.empty());
  EXPECT_EQ(sound_surface(model).shells, 2);
}

TEST(Assemble, CrossingMouthsOnOneHostKeepApart) {
  auto const model = assembled(drawing_of({body(), limb_layer("a", {520, 420}, {800, 300}, 50),
                                           limb_layer("b", {530, 450}, {820, 560}, 50)}));
  EXPECT_EQ(model.joints.size(), 2U);
  EXPECT_EQ(sound_surface(model).shells, 1);
}

TEST(Assemble, SmallAndLargeCanvasesGetTheSameMesh) {
  auto const scaled = [](double factor) {
    auto drawing = character(3);
    for (auto& layer : drawing.layers) {
      for (auto& piece : layer.outlines[0].pieces) {
        for (auto& p : piece.curve.control) p *= factor;
      }
    }
    return assembled(drawing).vertex_count;
  };
  EXPECT_EQ(scaled(1), scaled(4));
  EXPECT_EQ(scaled(1), scaled(0.25));
}

TEST(Assemble, DensityMeansTrianglesPerArea) {
  double const normal = assembled(character(3)).vertex_count;
  EXPECT_NEAR(assembled(character(3), {.density = 4}).vertex_count / normal, 4, 1);
}

TEST(Assemble, NothingToInflateIsSaid) {
  auto const model = assemble(drawing_of({}));
  ASSERT_FALSE(model.has_value());
  EXPECT_EQ(model.error().code, ErrorCode::NothingThere);
}

TEST(Assemble, ABadDensityOrThicknessIsRefused) {
  EXPECT_EQ(assemble(character(1), {.density = 0}).error().code, ErrorCode::BadOption);
  auto drawing = character(1);
  drawing.layers[0].thickness = -1;
  auto const model = assemble(drawing);
  EXPECT_EQ(model.error().code, ErrorCode::BadInput);
  EXPECT_EQ(model.error().index, 0);
}

TEST(Assemble, CanBeCancelled) {
  auto const model = assemble(character(3), {}, {{}, [] { return true; }});
  ASSERT_FALSE(model.has_value());
  EXPECT_EQ(model.error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace inkflate
