// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/sketch_limits.h"

namespace inkflate::cli {

/// The name that means standard input or standard output.
inline constexpr std::string_view kStandardStream = "-";

/// The whole content of a file, or of standard input for "-".
///
/// errors  FileSystem; TooLarge (more than kMaxFileBytes; noticed before memory is taken)
Result<std::vector<std::byte>> read_file(std::string const& path);

/// Puts a file in place as a whole: a new file beside it is written, brought to the disk and renamed, so that at
/// every moment there is the old file or the new one. A link at that name is replaced, not followed, except that
/// devices and pipes (also behind a link) are written to. "-" is standard output.
///
/// out     nothing: done; else FileSystem, and what was there before is unchanged
std::optional<Error> write_file(std::string const& path, std::span<std::byte const> content);
std::optional<Error> write_file(std::string const& path, std::string_view content);

/// As write_file; and the regular file that was there before stays beside it under the name with a "~" at its end, where the
/// file system lets us: work is not lost for want of its last version.
std::optional<Error> save_file(std::string const& path, std::span<std::byte const> content);

}  // namespace inkflate::cli
