// SPDX-License-Identifier: Apache-2.0
// Damaged and malicious GLB files end in the right error and never in a crash.
#include <gtest/gtest.h>

#include "io/put_bytes.h"
#include "io/read_mesh.h"

namespace inkflate {
namespace {

std::vector<std::byte> glb(std::string json, std::size_t binary_bytes = 36) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::vector<std::byte> file;
  put_text(file, "glTF");
  put_little_endian32(file, 2);
  put_little_endian32(file, static_cast<std::uint32_t>(28 + json.size() + binary_bytes));
  put_little_endian32(file, static_cast<std::uint32_t>(json.size()));
  put_text(file, "JSON" + json);
  put_little_endian32(file, static_cast<std::uint32_t>(binary_bytes));
  put_text(file, std::string_view("BIN\0", 4));
  file.resize(file.size() + binary_bytes);
  return file;
}

/// One triangle without indices; each part of it can be replaced.
struct Parts {
  std::string nodes = R"([{"mesh":0}])";
  std::string primitive = R"({"attributes":{"POSITION":0}})";
  std::string accessor = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":3})";
  std::string view = R"({"buffer":0,"byteOffset":0,"byteLength":36})";
  std::string buffer = R"({"byteLength":36})";

  std::string json() const {
    return R"({"nodes":)" + nodes + R"(,"meshes":[{"primitives":[)" + primitive +
           R"(]}],"accessors":[)" + accessor + R"(],"bufferViews":[)" + view + R"(],"buffers":[)" +
           buffer + "]}";
  }
};

ErrorCode code_of_json(std::string const& json) {
  auto const reading = read_mesh(glb(json));
  return reading ? ErrorCode::Cancelled : reading.error().code;
}
ErrorCode code_of(Parts const& parts) { return code_of_json(parts.json()); }

TEST(HostileGlb, TheFileThatIsDamagedBelowIsGood) {
  EXPECT_TRUE(read_mesh(glb(Parts().json())).has_value());
}

TEST(HostileGlb, AccessorsBeyondTheirData) {
  std::string const head = R"({"bufferView":0,"componentType":5126,"type":"VEC3",)";
  for (char const* const rest :
       {R"("count":4})", R"("count":3,"byteOffset":4})", R"("count":9007199254740992})",
        R"("count":3,"byteOffset":9007199254740992})", R"("count":-3})", R"("count":3.5})",
        R"("count":"3"})", R"("count":18446744073709551615})"}) {
    EXPECT_EQ(code_of({.accessor = head + rest}), ErrorCode::BadInput) << rest;
  }
}

TEST(HostileGlb, ViewsBeyondTheFile) {
  for (char const* const view :
       {R"({"buffer":0,"byteLength":37,"byteOffset":4})",
        R"({"buffer":0,"byteLength":36,"byteOffset":9007199254740992})",
        R"({"buffer":0,"byteLength":36,"byteStride":4611686018427387904})",
        R"({"buffer":0,"byteLength":36,"byteStride":1})", R"({"buffer":0})"}) {
    EXPECT_EQ(code_of({.view = view}), ErrorCode::BadInput) << view;
  }
}

TEST(HostileGlb, WhatIsNotThere) {
  EXPECT_EQ(code_of({.nodes = R"([{"mesh":7}])"}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({.nodes = R"([{"mesh":"0"}])"}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({.nodes = "[]"}), ErrorCode::NothingThere);
  EXPECT_EQ(code_of({.nodes = "7"}), ErrorCode::NothingThere);
  EXPECT_EQ(code_of({.primitive = "{}"}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({.primitive = R"({"attributes":{"POSITION":5}})"}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({.primitive = R"({"attributes":{"POSITION":0},"indices":9})"}),
            ErrorCode::BadInput);
}

TEST(HostileGlb, NodesInACircle) {
  EXPECT_EQ(code_of({.nodes = R"([{"children":[1]},{"children":[0],"mesh":0}])"}),
            ErrorCode::BadInput);
  EXPECT_EQ(code_of({.nodes = R"([{"children":[0],"mesh":0}])"}), ErrorCode::BadInput);
  EXPECT_EQ(code_of({.nodes = R"([{"children":[1,1]},{"mesh":0}])"}), ErrorCode::BadInput);
}

TEST(HostileGlb, DataOutsideOfTheFile) {
  EXPECT_EQ(code_of({.buffer = R"({"byteLength":36,"uri":"../../secret.bin"})"}),
            ErrorCode::Unsupported);
}

TEST(HostileGlb, KindsThatWeDoNotReadAreNamed) {
  EXPECT_EQ(code_of({.nodes = R"([{"mesh":0,"scale":[2,2,2]}])"}), ErrorCode::Unsupported);
  EXPECT_EQ(code_of({.nodes = R"([{"children":[1],"matrix":[]},{"mesh":0}])"}),
            ErrorCode::Unsupported);
  EXPECT_EQ(code_of({.primitive = R"({"attributes":{"POSITION":0},"mode":5})"}),
            ErrorCode::Unsupported);
}

TEST(HostileGlb, DeepJsonIsRefusedBeforeItIsRead) {
  EXPECT_EQ(code_of_json(std::string(100'000, '[') + std::string(100'000, ']')),
            ErrorCode::TooLarge);
  EXPECT_EQ(code_of_json("{"), ErrorCode::BadInput);
  EXPECT_EQ(code_of_json("[1e999]"), ErrorCode::BadInput);
}

TEST(HostileGlb, OneMeshShownTooOften) {
  std::string nodes = "[";
  for (int i = 0; i < 2000; ++i) nodes += R"({"mesh":0},)";
  nodes.back() = ']';
  auto const json =
      Parts{.nodes = nodes,
            .accessor = R"({"bufferView":0,"componentType":5126,"type":"VEC3","count":6000})",
            .view = R"({"buffer":0,"byteLength":72000})"}
          .json();
  auto const reading = read_mesh(glb(json, 72'000));
  ASSERT_FALSE(reading.has_value());
  EXPECT_EQ(reading.error().code, ErrorCode::TooLarge);
}

}  // namespace
}  // namespace inkflate
