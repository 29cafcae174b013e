// SPDX-License-Identifier: Apache-2.0
#include "io/stb.h"

#include <cstdlib>
#include <cstring>

#include "base/check.h"

// Without SIMD, whose rounding is not that of the plain code: WebAssembly has only the latter.
#define STBI_NO_SIMD
#define STBI_NO_STDIO
#define STBI_NO_FAILURE_STRINGS
#define STBI_ONLY_JPEG
#define STBI_ASSERT(x) static_cast<void>(0)
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb_image.h>
#include <stb_image_write.h>
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

namespace inkflate::detail {
namespace {

/// stb's scale of 5 (fast) to above 8 (small). On our pictures 5 gives the same size as 8 in two thirds of the time.
constexpr int kCompressionQuality = 5;

}  // namespace

void FreeMemory::operator()(std::uint8_t* memory) const { std::free(memory); }

DecodedJpeg decode_jpeg(std::span<std::byte const> file) {
  DecodedJpeg decoded;
  int channels = 0;
  decoded.rgb.reset(stbi_load_from_memory(reinterpret_cast<stbi_uc const*>(file.data()),
                                          static_cast<int>(file.size()), &decoded.width,
                                          &decoded.height, &channels, STBI_rgb));
  return decoded;
}

std::vector<std::byte> compress_zlib(std::span<std::byte const> data) {
  int size = 0;
  // stb takes a pointer to mutable bytes but does not write.
  auto* const input =
      reinterpret_cast<unsigned char*>(const_cast<std::byte*>(data.data()));  // NOLINT
  std::unique_ptr<std::uint8_t, FreeMemory> const packed(
      stbi_zlib_compress(input, static_cast<int>(data.size()), &size, kCompressionQuality));
  CHECK(packed != nullptr, "no memory to compress a picture");
  std::vector<std::byte> result(static_cast<std::size_t>(size));
  std::memcpy(result.data(), packed.get(), result.size());
  return result;
}

}  // namespace inkflate::detail
