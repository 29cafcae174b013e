// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace inkflate::zip {

/// The numbers of a zip archive (PKWARE APPNOTE 6.3.3, section 4.3).
inline constexpr std::uint32_t kFileHeader = 0x04034b50;
inline constexpr std::uint32_t kDirectoryHeader = 0x02014b50;
inline constexpr std::uint32_t kDirectoryEnd = 0x06054b50;
inline constexpr std::size_t kFileHeaderBytes = 30;
inline constexpr std::size_t kDirectoryHeaderBytes = 46;
inline constexpr std::size_t kDirectoryEndBytes = 22;
inline constexpr std::uint32_t kStored = 0;
inline constexpr std::uint32_t kDeflated = 8;
inline constexpr std::uint32_t kEncryptedFlags = 0x2041;  // of any kind
inline constexpr std::uint32_t kUtf8Flag = 0x0800;

}  // namespace inkflate::zip
