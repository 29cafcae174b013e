// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace inkflate::detail {

/// Prints where and why, then ends the program. Never returns.
[[noreturn]] void fail_check(char const* condition, char const* why, char const* file, int line);

}  // namespace inkflate::detail

/// Stops the program in every build when our own code breaks a precondition.
#define CHECK(condition, why)                                              \
  do {                                                                     \
    if (!(condition)) [[unlikely]] {                                       \
      ::inkflate::detail::fail_check(#condition, why, __FILE__, __LINE__); \
    }                                                                      \
  } while (false)

/// CHECK for conditions that cost time; only in builds with INKFLATE_DCHECKS.
#ifdef INKFLATE_DCHECKS
#define DCHECK(condition, why) CHECK(condition, why)
#else
#define DCHECK(condition, why) static_cast<void>(0)
#endif
