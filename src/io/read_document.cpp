// SPDX-License-Identifier: Apache-2.0
#include "io/read_document.h"

#include <utility>

#include "io/journal.h"
#include "io/read_inkflate.h"
#include "io/read_monster_mash.h"
#include "io/read_picture.h"
#include "io/read_scap.h"
#include "io/read_svg.h"

namespace inkflate {
namespace {

std::string sentence(SvgWarning const& warning) {
  return "left out " + std::to_string(warning.count) + " with " + warning.reason +
         " (the first at byte " + std::to_string(warning.first_byte) + ")";
}

Result<ReadDocument> from(Result<SvgReading> read) {
  if (!read) return read.error();
  ReadDocument document = {FileFormat::Svg, {std::move(read->drawing)}, {}};
  for (auto const& warning : read->warnings) document.warnings.push_back(sentence(warning));
  return document;
}

Result<ReadDocument> from(Result<Sketch> read) {
  if (!read) return read.error();
  return ReadDocument{FileFormat::Scap, {{std::move(*read), {}, {}}}, {}};
}

Result<ReadDocument> from(Result<Picture> read, FileFormat format) {
  if (!read) return read.error();
  return ReadDocument{format, {}, std::move(*read)};
}

Result<ReadDocument> from(Result<Project> read, FileFormat format) {
  if (!read) return read.error();
  return ReadDocument{format, std::move(*read), {}};
}

Result<ReadDocument> from(Result<ReadJournal> read) {
  if (!read) return read.error();
  ReadDocument document = {FileFormat::Journal, to_project(read->history.document()), {}};
  if (read->is_damaged) {
    document.warnings.push_back("left out all that follows a damaged line, at byte " +
                                std::to_string(read->bytes));
  }
  return document;
}

}  // namespace

Result<ReadDocument> read_document(std::span<std::byte const> content) {
  auto const format = sniff_format(content);
  switch (format) {
    case FileFormat::Svg:
      return from(read_svg_with_warnings(content));
    case FileFormat::Scap:
      return from(read_scap(content));
    case FileFormat::Png:
    case FileFormat::Jpeg:
      return from(read_picture(content), format);
    case FileFormat::Inkflate:
      return from(read_inkflate(content), format);
    case FileFormat::MonsterMash:
      return from(read_monster_mash(content), format);
    case FileFormat::Journal:
      return from(read_journal(content));
    case FileFormat::Zip:
      return Error{ErrorCode::Unsupported,
                   "a zip archive that is neither an Inkflate nor a Monster Mash project"};
    case FileFormat::Glb:
    case FileFormat::Obj:
    case FileFormat::Stl:
    case FileFormat::ThreeMf:
      return Error{ErrorCode::Unsupported, std::string("a model (") + file_format_name(format) +
                                               "), which holds no drawing"};
    case FileFormat::Unknown:
      break;
  }
  return Error{
      ErrorCode::Unsupported,
      "not a format we know; drawings are read from SVG, SCAP, PNG, JPEG, .inkflate, Monster "
      "Mash projects and journals"};
}

bool has_layers(ReadDocument const& document) { return !document.project.drawing.layers.empty(); }

}  // namespace inkflate
