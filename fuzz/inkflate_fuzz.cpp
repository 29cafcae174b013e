// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "base/check.h"
#include "io/read_document_json.h"
#include "io/read_inkflate.h"
#include "io/write_document_json.h"
#include "io/write_inkflate.h"

// Any bytes, as an archive or as its document, end in a project or an error; a project survives being written and read.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer gives the name
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  auto const bytes = std::as_bytes(std::span(data, size));
  auto const project = inkflate::read_inkflate(bytes);
  if (project) {
    auto const file = inkflate::write_inkflate(*project);
    CHECK(file.has_value(), "a project that was read can be written");
    auto const again = inkflate::read_inkflate(*file);
    CHECK(again.has_value() && *again == *project, "a written project reads as the same");
  }
  auto const document = inkflate::read_document_json({reinterpret_cast<char const*>(data), size});
  if (document) {
    auto const text = inkflate::write_document_json(document->project, document->template_name);
    auto const again = inkflate::read_document_json(text);
    CHECK(again.has_value() && *again == *document, "a written document reads as the same");
    auto const file = inkflate::write_inkflate(document->project);
    CHECK(file.has_value(), "a document that was read can be saved");
  }
  return 0;
}
