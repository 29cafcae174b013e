// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>

#include "cli/program.h"
#include "io/read_picture.h"

namespace inkflate {

/// A picture that the program has left in a folder. One pixel, and the test fails, where there is none.
inline Picture picture_in(ScratchFolder const& folder, std::string const& name) {
  auto const content = folder.read(name);
  auto const picture = read_picture(std::as_bytes(std::span(content)));
  EXPECT_TRUE(picture) << name;
  return picture ? *picture : Picture(1, 1);
}

}  // namespace inkflate
