// What comes from outside is bounded before memory is taken, and stays in its folder.
#include "support/text/limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "png_parts.h"
#include "stimuli/set/manifest.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "support/text/text_bounds.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;

class Limits : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "study" / "below");
    fs::create_directories(folder_ / "elsewhere");
  }
  const TemporaryFolder folder_;
};

/// A PNG's signature and header, and nothing of its pixels.
std::string png_header(std::uint32_t width_px, std::uint32_t height_px) {
  return test::png_head(width_px, height_px, std::string("\x08\x02\0", 3)) + test::big_endian(0) + "IDAT";
}

TEST_F(Limits, APictureThatPromisesMoreThanItsFileCanHoldIsRefused) {
  write_file_atomically(folder_ / "bomb.png", png_header(16384, 16384));
  EXPECT_THAT(complaint_of([&] { (void)read_bytes_image(folder_ / "bomb.png"); }),
              AllOf(HasSubstr("bomb.png"), HasSubstr("wanted a file that can hold 16384 x 16384 pixels"),
                    HasSubstr("found 41 bytes")));
  write_file_atomically(folder_ / "wide.png", png_header(1000000, 1000));
  EXPECT_THAT(complaint_of([&] { (void)read_image(folder_ / "wide.png"); }),
              AllOf(HasSubstr("wide.png"), HasSubstr("wanted a")));
}

TEST_F(Limits, AnHdrOfTwoToThe31PixelsIsRefused) {
  const auto with_size = [&](const std::string& size) {
    write_file_atomically(folder_ / "bomb.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n");
    return complaint_of([&] { (void)read_image(folder_ / "bomb.hdr"); });
  };
  EXPECT_THAT(with_size("-Y 32768 +X 65536"), AllOf(HasSubstr("bomb.hdr"), HasSubstr("wanted a")));
  EXPECT_THAT(with_size("-Y 16384 +X 16384"), HasSubstr("wanted a file that can hold"));
}

TEST_F(Limits, OtherPictureFormatsAreNeverTried) {
  write_file_atomically(folder_ / "a.png", "8BPS a PSD by another name");
  EXPECT_THAT(complaint_of([&] { (void)read_image(folder_ / "a.png"); }),
              HasSubstr("wanted an EXR, HDR, PNG, JPEG or TIFF image"));
  EXPECT_THAT(complaint_of([&] { (void)read_image("null.null?RES=64x64"); }), HasSubstr("no such file"));
}

TEST_F(Limits, AFileWithoutEndIsNotReadToItsEnd) {
  EXPECT_THAT(complaint_of([] { (void)read_file("/dev/zero", 1 << 20); }),
              HasSubstr("/dev/zero: wanted at most 1048576 bytes, found more"));
  write_file_atomically(folder_ / "four", "1234");
  EXPECT_EQ(read_file(folder_ / "four", 4), "1234");
  EXPECT_THROW((void)read_file(folder_ / "four", 3), InputError);
}

TEST_F(Limits, TextsMayNotNestDeeperThanTheStackIsMeantFor) {
  const auto brackets = [](std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
  };
  const std::size_t deepest = limits::deepest_text_nesting;
  EXPECT_NO_THROW(require_bounded_json(brackets(deepest), "a.json"));
  EXPECT_THAT(complaint_of([&] { require_bounded_json("\n" + brackets(deepest + 1), "a.json"); }),
              HasSubstr("a.json: line 2: wanted at most 128 levels"));
  EXPECT_NO_THROW(require_bounded_json("\"" + brackets(9999) + "\\\"[\"", "a.json"));

  EXPECT_NO_THROW(require_bounded_toml("a = " + brackets(deepest), "a.toml"));
  EXPECT_THROW(require_bounded_toml("a = " + brackets(100000), "a.toml"), InputError);
  std::string many = "[";
  for (std::int64_t i = 0; i < limits::most_text_values; ++i) many += "0,";
  EXPECT_THAT(complaint_of([&] { require_bounded_json(many, "a.json"); }),
              HasSubstr("a.json: wanted at most 10000000 values, found more"));
  EXPECT_THAT(complaint_of([&] { require_bounded_toml("a = " + many, "a.toml"); }),
              HasSubstr("10000000 values"));
  std::string dotted = "a";
  for (int i = 0; i < 100000; ++i) dotted += ".a";
  EXPECT_THROW(require_bounded_toml(dotted + " = 1", "a.toml"), InputError);
  EXPECT_NO_THROW(require_bounded_toml("a = \"" + dotted + "\" # " + dotted, "a.toml"));
  EXPECT_NO_THROW(require_bounded_toml("a = '''\n" + dotted + brackets(999) + "'''", "a.toml"));
  EXPECT_THAT(complaint_of([&] { (void)read_study_text(dotted + " = 1", "a.toml"); }), HasSubstr("levels"));
  EXPECT_THAT(complaint_of([&] { (void)stimulus_record_from_text(brackets(100000), "record.json"); }),
              HasSubstr("record.json: line 1: wanted at most 128 levels"));
}

TEST_F(Limits, TomlThatFuzzingFound) {
  for (const char* text :
       {"a = [{,na\n", "a = 0.\xd0\xac", "a = 1\xc3\xa9", "\xd0\xac = 1", "a = {b = 1,}", "a = {", "a."})
    EXPECT_THAT(complaint_of([&] { (void)read_study_text(text, "a.toml"); }), HasSubstr("a.toml: ")) << text;
}

TEST_F(Limits, ANumberTooLargeForTheMachineIsRefused) {
  EXPECT_THAT(complaint_of([] { (void)stimulus_record_from_text(R"({"spp": 961e308})", "record.json"); }),
              HasSubstr("record.json: wanted JSON"));
}

TEST_F(Limits, AnExrAttributeLiesInsideTheFileAndHasItsTypesSize) {
  write_exr(folder_ / "a.exr", Image(4, 2, 1, 1.0F));
  const std::string good = read_file(folder_ / "a.exr");
  const auto with_size = [&](const char* type, const char* size) {
    std::string bytes = good;
    const std::size_t at = bytes.find(std::string("\0", 1) + type + std::string("\0", 1));
    if (at == std::string::npos) return std::string("no such type");
    bytes.replace(at + std::string(type).size() + 2, 4, size, 4);
    write_file_atomically(folder_ / "b.exr", bytes);
    return complaint_of([&] { (void)read_image(folder_ / "b.exr"); });
  };
  EXPECT_THAT(with_size("float", "\5\0\0\0"),
              HasSubstr("b.exr: wanted a whole EXR file, found a value of type float with 5 bytes"));
  EXPECT_THAT(with_size("string", "\1\0\0\x70"),
              HasSubstr("an attribute of 1879048193 bytes that leads out"));
  EXPECT_THAT(with_size("chlist", "\1\0\0\0"), HasSubstr("a list of channels of another length"));
}

TEST_F(Limits, ManifestsHoldWholeNumbersOfTheirKindAndFilesOfTheirSet) {
  ManifestStimulus record;
  record.id = "room-shadow-a-0064";
  record.stimulus = {.scene = "room",
                     .artifact = Artifact::shadow,
                     .object = "a",
                     .object_index = 1,
                     .level = 1.0 * 64,
                     .depth = {.width_px = 64}};
  record.image = "stimuli/a.png";
  const std::string good = stimulus_record_text(record);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return complaint_of([&] { (void)stimulus_record_from_text(text, "r.json"); });
  };
  EXPECT_EQ(with("\"spp\":0", "\"spp\":16"), "no complaint");
  EXPECT_THAT(with("\"spp\":0", "\"spp\":1e300"), HasSubstr("r.json: spp: wanted a whole number"));
  EXPECT_THAT(with("\"spp\":0", "\"spp\":4294967296"), HasSubstr("found 4294967296"));
  EXPECT_THAT(with("\"spp\":0", "\"spp\":1.5"), HasSubstr("found 1.5"));
  EXPECT_THAT(with("\"depth_width_px\":64", "\"depth_width_px\":-2"), HasSubstr("from 2 to 16384, found -2"));
  for (const char* file : {"/etc/passwd", "../a.png", "stimuli/../../a.png"})
    EXPECT_THAT(with("stimuli/a.png", file), HasSubstr("image: wanted a path below the set's folder"));
  for (const char* id : {"", "../a", "a/b", ".hidden", "a\\nb"})
    EXPECT_THAT(with("room-shadow-a-0064", id), HasSubstr("r.json: id: wanted letters"));
}

TEST_F(Limits, ScenesLieBelowTheStudyFileOrTheAssetRoot) {
  write_file_atomically(folder_ / "study" / "below" / "a.glb", "a");
  write_file_atomically(folder_ / "elsewhere" / "b.glb", "b");
  write_file_atomically(folder_ / "secret.glb", "c");
  fs::create_symlink(folder_ / "elsewhere" / "b.glb", folder_ / "study" / "link.glb");
  fs::create_directory_symlink(folder_ / "elsewhere", folder_ / "study" / "linked");
  const AssetFolders own{.study_file = folder_ / "study" / "s.toml"};
  const AssetFolders both{.study_file = own.study_file, .asset_root = folder_ / "elsewhere"};
  const auto refusal = [&](const AssetFolders& folders, const std::string& name) {
    return complaint_of([&] { (void)resolve_asset(name, folders, "scene[0].file"); });
  };
  EXPECT_EQ(resolve_asset("below/a.glb", own, ""), folder_ / "study" / "below" / "a.glb");
  EXPECT_EQ(resolve_asset("below/../below/a.glb", own, ""), folder_ / "study" / "below/../below/a.glb");
  const std::string absolute = (folder_ / "elsewhere" / "b.glb").string();
  for (const std::string& name :
       {std::string("../elsewhere/b.glb"), std::string("link.glb"), std::string("linked/b.glb"), absolute}) {
    EXPECT_THAT(refusal(own, name),
                AllOf(HasSubstr("s.toml: scene[0].file: wanted a file in the study file's folder"),
                      HasSubstr("asset_root"), HasSubstr("found \"" + name + "\"")));
    EXPECT_EQ(refusal(both, name), "no complaint") << name;
  }
  EXPECT_EQ(resolve_asset("b.glb", both, ""), folder_ / "elsewhere" / "b.glb");
  for (const char* name : {"../secret.glb", "linked/../secret.glb"})
    EXPECT_NE(refusal(both, name), "no complaint") << name;
  EXPECT_THAT(refusal(own, "none.glb"), HasSubstr("wanted a file, found no file at"));
  EXPECT_THAT(refusal(own, "builtin:../../secret"), HasSubstr("wanted a built-in scene"));
}

TEST_F(Limits, FilesOfASetMayNotLeaveItThroughALink) {
  write_file_atomically(folder_ / "secret.png", "s");
  write_file_atomically(folder_ / "study" / "own.png", "o");
  fs::create_symlink(folder_ / "secret.png", folder_ / "study" / "out.png");
  fs::create_symlink(folder_ / "study" / "own.png", folder_ / "study" / "in.png");
  const fs::path set = folder_ / "study";
  const auto refusal = [&](const std::string& name) {
    return complaint_of([&] { (void)path_below(set, name, {.file = "manifest.json", .field = "image"}); });
  };
  EXPECT_EQ(path_below(set, "own.png", {}), set / "own.png");
  EXPECT_EQ(refusal("in.png"), "no complaint");
  EXPECT_EQ(refusal("not-there.png"), "no complaint");
  EXPECT_EQ(refusal("out.png"),
            "manifest.json: image: wanted a file in the folder of the file that names it, or below, found "
            "\"out.png\", which leads out of it");
  EXPECT_NE(refusal("../secret.png"), "no complaint");
  EXPECT_NE(refusal((set / "own.png").string()), "no complaint");
  EXPECT_NE(refusal(std::string("own.png\0x", 9)), "no complaint");
}

}  // namespace
}  // namespace seamline
