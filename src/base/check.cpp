// SPDX-License-Identifier: Apache-2.0
#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace inkflate::detail {

void fail_check(char const* condition, char const* why, char const* file, int line) {
  std::fprintf(stderr, "%s:%d: our own fault: %s does not hold (%s)\n", file, line, condition, why);
  std::abort();
}

}  // namespace inkflate::detail
