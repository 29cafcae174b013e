// SPDX-License-Identifier: Apache-2.0
#include "io/format.h"

#include <gtest/gtest.h>

#include "io/bytes.h"
#include "io/write_zip.h"

namespace inkflate {
namespace {

TEST(Format, IsToldByContent) {
  struct Case {
    std::string_view bytes;
    FileFormat format;
  };
  for (auto const& [bytes, format] :
       {Case{"<svg/>", FileFormat::Svg},
        Case{"\xef\xbb\xbf <?xml?><!-- --><s:svg>", FileFormat::Svg},
        Case{{"\xff\xfe<\0s\0v\0g\0", 10}, FileFormat::Svg},
        Case{"<html></html>", FileFormat::Unknown},
        Case{"#593 394\n@1", FileFormat::Scap},
        Case{"#\t593\t394", FileFormat::Scap},
        Case{"{\n#1 0", FileFormat::Scap},
        Case{"# a comment", FileFormat::Unknown},
        Case{"{\"document\": 1}", FileFormat::Unknown},
        Case{"\x89PNG\r\n\x1a\n....", FileFormat::Png},
        Case{"\xff\xd8\xff\xe0", FileFormat::Jpeg},
        Case{"PK\x03\x04....", FileFormat::Zip},
        Case{"PK\x05\x06", FileFormat::Zip},
        Case{"glTF\2", FileFormat::Glb},
        Case{"................ {\"format\":\"inkflate journal\"}", FileFormat::Journal},
        Case{"................ {}", FileFormat::Unknown},
        Case{"solid cube\n", FileFormat::Stl},
        Case{"# made by\n\nmtllib a.mtl\nv 0 0 0", FileFormat::Obj},
        Case{"very much text", FileFormat::Unknown},
        Case{"v\n", FileFormat::Unknown},
        Case{"", FileFormat::Unknown},
        Case{"#", FileFormat::Unknown},
        Case{"\xff\xfe", FileFormat::Unknown},
        Case{"\x89PNG", FileFormat::Unknown}}) {
    EXPECT_EQ(sniff_format(as_bytes(bytes)), format) << bytes;
  }
}

TEST(Format, ArchivesAreToldByWhatTheyHold) {
  struct Case {
    std::string name;
    FileFormat format;
  };
  for (auto const& [name, format] : {Case{"document.json", FileFormat::Inkflate},
                                     Case{"my/_ORG_000.png", FileFormat::MonsterMash},
                                     Case{"_seg_000.png", FileFormat::MonsterMash},
                                     Case{"3D/3dmodel.model", FileFormat::ThreeMf},
                                     Case{"other/document.json", FileFormat::Zip}}) {
    std::vector<ZipFile> const files = {{"readme", {}}, {name, {}}};
    EXPECT_EQ(sniff_format(write_zip(files)), format) << name;
  }
}

TEST(Format, BinaryStlIsToldByItsSize) {
  std::vector<std::byte> bytes(84 + 2 * 50);
  bytes[80] = std::byte{2};
  EXPECT_EQ(sniff_format(bytes), FileFormat::Stl);
  bytes.pop_back();
  EXPECT_EQ(sniff_format(bytes), FileFormat::Unknown);
}

TEST(Format, HasANameForMessages) {
  using enum FileFormat;
  std::string names;
  for (auto const format :
       {Svg, Scap, Png, Jpeg, Inkflate, MonsterMash, ThreeMf, Zip, Glb, Obj, Stl, Unknown}) {
    names += file_format_name(format);
    names += ' ';
  }
  EXPECT_EQ(names, "SVG .scap PNG JPEG .inkflate Monster Mash 3MF zip GLB OBJ STL unknown ");
}

}  // namespace
}  // namespace inkflate
