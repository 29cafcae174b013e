// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "io/read_zip.h"
#include "io/write_zip.h"
#include "model/project.h"

namespace inkflate {

/// The file of an archive in which a project's document lies, and by which a project is known.
inline constexpr std::string_view kDocumentFile = "document.json";

/// The files that hold a project: document.json, a preview, and its pictures.
///
/// in      as write_document_json; a template picture has pixels
/// errors  TooLarge (more than the reader would take)
Result<std::vector<ZipFile>> project_files(Project const& project);

/// The archive with these files. TooLarge: it would be more than we read.
Result<std::vector<std::byte>> write_project_zip(std::span<ZipFile const> files);

/// Reads them back; other files are passed over.
///
/// errors  BadInput (no document, or damaged; index: as in read_document_json), TooLarge, Unsupported (a newer version)
Result<Project> read_project_files(std::span<ZipEntry const> entries);

}  // namespace inkflate
