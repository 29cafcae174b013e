// SPDX-License-Identifier: Apache-2.0
#include "pipeline/close_document.h"

#include <gtest/gtest.h>

#include <cmath>

#include "document/apply.h"
#include "support/closed_documents.h"
#include "support/editor_documents.h"
#include "support/sketches.h"

namespace inkflate {
namespace {

Stroke far(Stroke stroke) {
  stroke.depth = StrokeDepth::Far;
  return stroke;
}

/// Three quarters of a circle: too open to be closed by itself.
Stroke open_arc(Vec2 centre, double radius) {
  return arc_stroke(centre, radius, radius, 0, 3.14159);
}

TEST(CloseDocument, NearAndFarStrokesBecomeTwoLayersFarOnesBehind) {
  auto const document =
      simplified(drawn({circle_stroke({400, 500}, 200), far(circle_stroke({600, 500}, 150))}));
  ASSERT_EQ(document.layers->size(), 2);
  EXPECT_NEAR(area(layer_at(document, 0)), 3.1416 * 150 * 150, 2000);
  EXPECT_NEAR(area(layer_at(document, 1)), 3.1416 * 200 * 200, 2000);
  EXPECT_TRUE(document.loose.is_empty());
}

TEST(CloseDocument, NewPartsGoBeforeOrBehindAllThatAreThere) {
  auto document = simplified(drawn({circle_stroke({500, 500}, 100)}));
  document = simplified(
      drawn(document, {far(circle_stroke({500, 500}, 200)), circle_stroke({500, 500}, 50)}));
  ASSERT_EQ(document.layers->size(), 3);
  EXPECT_GT(area(layer_at(document, 0)), area(layer_at(document, 1)));
  EXPECT_GT(area(layer_at(document, 1)), area(layer_at(document, 2)));
}

TEST(CloseDocument, ALimbThatIsOpenTowardsAPartIsClosedWithinIt) {
  auto const body = simplified(drawn({circle_stroke({500, 500}, 200)}));
  // A leg: two sides that begin in the body, as wide as they are long, and a foot.
  auto const leg = line_stroke({{410, 640}, {410, 840}, {590, 840}, {590, 640}});
  auto const document = simplified(drawn(body, {leg}));
  ASSERT_EQ(document.layers->size(), 2);
  auto const& limb = layer_at(document, 1);
  EXPECT_NEAR(area(limb), 180 * 200, 2500);
  EXPECT_LT(bounds(flatten(limb.outlines.front(), 0.1)).min.y, 660);
  // Drawn again, it is closed there again.
  auto const opened = must(apply(document, OpenLayer{limb.id}));
  EXPECT_NEAR(area(layer_at(simplified(opened), 1)), area(limb), 500);
  // What is hidden is nothing to be joined to.
  auto const hidden = must(apply(drawn(body, {leg}), SetHidden{layer_at(body, 0).id, true}));
  auto const alone = close_document(hidden);
  EXPECT_TRUE(!alone->command || area(alone->command->sets[0].shapes[0]) < 0.9 * area(limb));
}

TEST(CloseDocument, NumbersOfPartsAreNotGivenTwice) {
  auto document = simplified(drawn({circle_stroke({200, 500}, 100)}));
  document = must(apply(document, RenameLayer{layer_at(document, 0).id, "part 2"}));
  document = simplified(
      drawn(document, {circle_stroke({500, 500}, 100), far(circle_stroke({800, 500}, 100))}));
  ASSERT_EQ(document.layers->size(), 3);
  EXPECT_EQ(layer_at(document, 0).name, "part 3");
  EXPECT_EQ(layer_at(document, 1).name, "part 2");
  EXPECT_EQ(layer_at(document, 2).name, "part 1");
}

TEST(CloseDocument, StrokesInGroupsBecomeLayersOfTheirNames) {
  auto arm = circle_stroke({300, 300}, 80);
  arm.group = 0;
  auto guide = circle_stroke({600, 300}, 80);
  guide.group = 1;
  Project project;
  project.drawing.sketch = sketch_of({arm, guide, circle_stroke({600, 700}, 150)});
  project.drawing.sketch.groups = {{"arm"}, {"construction"}};
  project.drawing.stray = {0, 1, 2};
  auto const document = simplified(must(make_document(project)));
  ASSERT_EQ(document.layers->size(), 2);
  EXPECT_EQ(layer_at(document, 0).name, "arm");
  EXPECT_EQ(layer_at(document, 1).name, "part 1");
  EXPECT_EQ(layer_at(document, 0).noise.size(), 1);  // the guide
}

TEST(CloseDocument, LayerIsOneShapeWhateverGroupsItsStrokesAreIn) {
  auto left = arc_stroke({500, 500}, 200, 200, 1.5708, 4.7124);
  left.group = 0;
  auto guide = circle_stroke({500, 500}, 400);
  guide.group = 1;
  Project project;
  project.drawing.sketch = sketch_of({left, guide});
  project.drawing.sketch.groups = {{"arm"}, {"construction"}};
  project.drawing.stray = {};
  Layer layer;
  layer.is_open = true;
  layer.noise = {0, 1};
  layer.id = LayerId{1};
  project.drawing.layers = {layer};
  project.next_id = 2;
  auto document = must(make_document(project));
  document =
      simplified(drawn(document, {arc_stroke({500, 500}, 200, 200, 4.7124, 7.854)}, LayerId{1}));
  ASSERT_EQ(document.layers->size(), 1);
  EXPECT_NEAR(area(layer_at(document, 0)), 3.1416 * 200 * 200, 2000);
  EXPECT_EQ(layer_at(document, 0).noise.size(), 1);
}

TEST(CloseDocument, OpenLayerKeepsItsIdNameAndPlace) {
  auto document = simplified(drawn({circle_stroke({300, 300}, 100)}));
  document = simplified(drawn(document, {circle_stroke({700, 700}, 100)}));
  auto const id = layer_at(document, 0).id;
  document = must(apply(document, RenameLayer{id, "tail"}));
  document = must(apply(document, RedrawLayer{id}));
  document = drawn(document, {circle_stroke({300, 300}, 50), circle_stroke({400, 300}, 30)}, id);
  document = simplified(document);
  ASSERT_EQ(document.layers->size(), 3);
  EXPECT_EQ(layer_at(document, 0).name, "tail");
  EXPECT_EQ(layer_at(document, 0).id, id);
  EXPECT_FALSE(layer_at(document, 0).is_open);
  EXPECT_NEAR(area(layer_at(document, 0)), 3.1416 * 50 * 50, 1000);
  EXPECT_EQ(layer_at(document, 1).name, "part 1");  // what came with it
  EXPECT_EQ(layer_at(document, 2).name, "part 2");
}

TEST(CloseDocument, ChoiceIsThatOfTheDocumentAndOfEachOpenLayer) {
  auto document = drawn({arc_stroke({300, 300}, 100, 100, 0, 3.8)});
  EXPECT_FALSE(closed(document).command.has_value());
  CloseChoice const wide = {250, {}, {}};
  document = must(apply(document, SetChoice{LayerId::None, wide}));
  document = simplified(document);
  ASSERT_EQ(document.layers->size(), 1);
  EXPECT_EQ(layer_at(document, 0).choice, wide);
  document = must(apply(document, OpenLayer{layer_at(document, 0).id}));
  document = must(apply(document, SetChoice{layer_at(document, 0).id, {50, {}, {}}}));
  EXPECT_EQ(closed(document).faults.size(), 1);
}

TEST(CloseDocument, MarkOfOneDepthDoesNotRefuseTheOther) {
  auto document = drawn({open_arc({250, 250}, 200), far(circle_stroke({800, 800}, 100))});
  document = must(apply(document, SetChoice{LayerId::None, {std::nullopt, {}, {{250, 350}}}}));
  EXPECT_EQ(simplified(document).layers->size(), 2);
}

TEST(CloseDocument, HelpLineGivesAnOpenRun) {
  auto const document = simplified(drawn(
      {open_arc({500, 500}, 200), line_stroke({{300, 500}, {700, 500}}, StrokeKind::HelpLine)}));
  ASSERT_EQ(document.layers->size(), 1);
  int help_runs = 0;
  for (auto const& run : runs(layer_at(document, 0).outlines.front(), 1))
    help_runs += run.kind == RunKind::HelpLine ? 1 : 0;
  EXPECT_EQ(help_runs, 1);
}

TEST(CloseDocument, ClosingsAreCounted) {
  EXPECT_EQ(closed(drawn({circle_stroke({500, 500}, 200)})).closings, 0);
  auto const gap = arc_stroke({500, 500}, 200, 200, 0, 6.1);
  auto const other = far(arc_stroke({500, 500}, 100, 100, 0, 6.0));
  EXPECT_EQ(closed(drawn({gap, other})).closings, 2);
}

TEST(CloseDocument, FaultNamesTheSetAndTheOpening) {
  auto document = simplified(drawn({circle_stroke({800, 800}, 50)}));
  auto const id = layer_at(document, 0).id;
  document = must(apply(document, RedrawLayer{id}));
  document = drawn(document, {open_arc({500, 500}, 200)}, id);
  document = drawn(document, {circle_stroke({200, 200}, 50), far(open_arc({300, 600}, 100))});
  auto const result = closed(document);
  ASSERT_EQ(result.faults.size(), 2);
  EXPECT_EQ(result.faults[0].layer, id);
  EXPECT_EQ(result.faults[0].error.code, ErrorCode::NothingThere);
  EXPECT_LT(distance(result.faults[0].place, {500, 500}), 10);
  EXPECT_EQ(result.faults[1].layer, LayerId::None);
  EXPECT_EQ(result.faults[1].depth, StrokeDepth::Far);
  EXPECT_LT(distance(result.faults[1].place, {300, 600}), 10);
  ASSERT_TRUE(result.command.has_value());
  auto const after = must(apply(document, *result.command));
  EXPECT_EQ(after.layers->size(), 2);
  EXPECT_EQ(after.loose.size(), 1);
  EXPECT_TRUE(find_layer(after, id)->layer.is_open);
}

TEST(CloseDocument, StrokesThatDrawNothingAreNoiseOfTheFirstShape) {
  auto const document =
      simplified(drawn({line_stroke({{900, 100}, {905, 104}}), circle_stroke({300, 500}, 200),
                        circle_stroke({800, 500}, 100)}));
  ASSERT_EQ(document.layers->size(), 2);
  EXPECT_EQ(layer_at(document, 0).noise.size(), 1);
  EXPECT_TRUE(layer_at(document, 1).noise.empty());
}

TEST(CloseDocument, NoiseAloneIsAFault) {
  auto const result =
      closed(drawn({line_stroke({{900, 100}, {905, 104}}), line_stroke({{20, 20}})}));
  EXPECT_FALSE(result.command.has_value());
  ASSERT_EQ(result.faults.size(), 1);
  EXPECT_EQ(result.faults[0].error.code, ErrorCode::NothingThere);
}

TEST(CloseDocument, SourcesOfOutlinesNameTheStrokesThatDrewThem) {
  auto const document =
      simplified(drawn({far(circle_stroke({200, 200}, 100)), circle_stroke({700, 700}, 200)}));
  ASSERT_EQ(document.layers->size(), 2);
  for (auto const& layer : *document.layers) {
    ASSERT_EQ(layer->strokes.size(), 1);
    for (auto const& source : layer->layer.outlines.front().sources) EXPECT_EQ(source.stroke, 0);
  }
  EXPECT_EQ((*document.layers)[0]->strokes[0]->stroke.depth, StrokeDepth::Far);
}

TEST(CloseDocument, NothingRoughIsNothingThere) {
  auto const refusal = close_document(empty_document());
  ASSERT_FALSE(refusal.has_value());
  EXPECT_EQ(refusal.error().code, ErrorCode::NothingThere);
  auto const redrawn = simplified(drawn({circle_stroke({500, 500}, 100)}));
  EXPECT_FALSE(close_document(redrawn).has_value());
  EXPECT_FALSE(
      close_document(must(apply(redrawn, RedrawLayer{layer_at(redrawn, 0).id}))).has_value());
}

TEST(CloseDocument, CanBeCancelledAtEveryStage) {
  auto const document =
      drawn({circle_stroke({500, 500}, 100), far(circle_stroke({500, 500}, 200))});
  int stages = 0;
  ASSERT_TRUE(close_document(document, {[&](auto) { ++stages; }, {}}).has_value());
  for (int stop = 0; stop < stages; ++stop) {
    int seen = 0;
    auto const result = close_document(document, {{}, [&] { return seen++ == stop; }});
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Cancelled);
  }
}

TEST(CloseDocument, HostileStrokesEndInFaultsOrFiniteShapes) {
  std::vector<std::vector<Stroke>> const drawings = {
      {line_stroke({{1e6, 1e6}}), line_stroke({{-1e6, -1e6}}), circle_stroke({5, 5}, 3)},
      {circle_stroke({1e6 - 1, 1e6 - 1}, 1e-3)},
      {circle_stroke({0, 0}, 1e-300)},
      {line_stroke({{3, 3}, {3, 3}, {3, 3}})},
      {circle_stroke({0, 0}, 1e6), far(line_stroke({{1e-9, 0}, {0, 1e-9}}))},
  };
  for (auto const& strokes : drawings) {
    auto const result = closed(drawn(strokes));
    for (auto const& fault : result.faults) EXPECT_TRUE(is_finite(fault.place));
    if (!result.command) continue;
    for (auto const& set : result.command->sets) {
      for (auto const& shape : set.shapes) EXPECT_TRUE(std::isfinite(area(shape)));
    }
  }
}

TEST(CloseLayerAgain, TakesAnotherChoice) {
  auto document =
      simplified(drawn({circle_stroke({500, 500}, 100), arc_stroke({500, 500}, 300, 300, 0, 5.9)}));
  auto const id = layer_at(document, 0).id;
  CloseChoice const choice = {std::nullopt, {{500, 250}}, {}};
  auto const command = close_layer_again(document, id, choice);
  ASSERT_TRUE(command.has_value());
  document = must(apply(document, OpenLayer{id}));
  auto const after = must(apply(document, *command));
  ASSERT_EQ(after.layers->size(), 1);
  EXPECT_EQ(layer_at(after, 0).id, id);
  EXPECT_EQ(layer_at(after, 0).choice, choice);
  EXPECT_LT(area(layer_at(after, 0)), area(layer_at(document, 0)) / 2);
}

TEST(CloseLayerAgain, RefusesWhatHasNoStrokesAndWhatStaysOpen) {
  auto const document = simplified(drawn({arc_stroke({500, 500}, 300, 300, 0, 5.9)}));
  auto const id = layer_at(document, 0).id;
  auto const code = [&](Document const& d, LayerId layer, CloseChoice const& choice) {
    auto const result = close_layer_again(d, layer, choice);
    EXPECT_FALSE(result.has_value());
    return result ? ErrorCode::FileSystem : result.error().code;
  };
  EXPECT_EQ(code(document, LayerId{77}, {}), ErrorCode::NothingThere);
  EXPECT_EQ(code(must(apply(document, RedrawLayer{id})), id, {}), ErrorCode::NothingThere);
  EXPECT_EQ(code(document, id, {5, {}, {}}), ErrorCode::NothingThere);
  EXPECT_EQ(code(document, id, {-5, {}, {}}), ErrorCode::BadOption);
}

}  // namespace
}  // namespace inkflate
