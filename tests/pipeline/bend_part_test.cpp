// SPDX-License-Identifier: Apache-2.0
#include "pipeline/bend_part.h"

#include <gtest/gtest.h>

#include "document/apply.h"
#include "support/editor_documents.h"

namespace inkflate {
namespace {

/// A layer as it is after so many shifts by one px.
std::vector<BendSource> shifted_versions(int count) {
  auto document = with_disc(empty_document(), {300, 300}, 100);
  std::vector<BendSource> versions;
  for (int i = 0; i < count; ++i) {
    versions.push_back({document.layers->front(), {}});
    document = *apply(document, TransformLayers{{LayerId{1}}, Affine::translation({1, 0})});
  }
  return versions;
}

TEST(BendPart, KnowsItsRestHoweverManyVersionsHaveCome) {
  auto const versions = shifted_versions(200);
  BendPart part(versions.front());
  for (auto const& version : versions) part.remember({version});
  EXPECT_TRUE(part.meet(versions.front()));
  EXPECT_TRUE(part.meet(versions.back()));
  EXPECT_EQ(part.now().source, versions.back());
  // It keeps so many and no more: a session may be long.
  EXPECT_FALSE(part.meet(versions[1]));
  EXPECT_FALSE(part.meet(versions[100]));
}

TEST(BendPart, IsTheSameAfterWhatChangesNoShape) {
  auto const document = with_disc(empty_document(), {300, 300}, 100);
  BendPart part({document.layers->front(), {}});
  for (Command const& command : std::vector<Command>{RenameLayer{LayerId{1}, "nose"},
                                                     SetBendPins{LayerId{1}, {{{200, 300}}}},
                                                     SetThickness{LayerId{1}, 1.5}}) {
    auto const next = apply(document, command);
    ASSERT_TRUE(next) << next.error().message;
    EXPECT_TRUE(part.meet({next->layers->front(), {}}));
  }
  auto const moved = apply(document, TransformLayers{{LayerId{1}}, Affine::translation({1, 0})});
  EXPECT_FALSE(part.meet({moved->layers->front(), {}}));
}

TEST(BendPart, HasAPoseInEveryVersionOnceItIsReady) {
  auto const document = with_disc(empty_document(), {300, 300}, 100);
  auto const renamed = *apply(document, RenameLayer{LayerId{1}, "nose"});
  BendPart part({document.layers->front(), {}});
  ASSERT_TRUE(part.meet({renamed.layers->front(), {}}));
  ASSERT_FALSE(part.make_ready({}));
  ASSERT_TRUE(part.meet({document.layers->front(), {}}));
  EXPECT_EQ(part.now().pose, part.rest_pose());
}

}  // namespace
}  // namespace inkflate
