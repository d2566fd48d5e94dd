// A set whose pictures are not what its manifest says is refused by every command that opens it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/text/error.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using study::RenderedSet;

using test::fresh_folder;
using test::Outcome;
using test::run_seamline;
using testing::HasSubstr;

void expect_refused(const RenderedSet& set, const std::string& part) {
  const std::string folder = set.folder.string();
  for (const std::string& command :
       {"verify " + folder, "study " + folder + " --observer perfect --log " + folder + "/log.sqlite",
        "predict " + folder + " --gain 1", "check " + folder}) {
    const Outcome outcome = run_seamline(command);
    EXPECT_EQ(outcome.status, 1) << command << ": " << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(part)) << command;
  }
  EXPECT_THROW(check_manifest_shapes(set.folder, set.manifest), InputError);
}

TEST(SetPictures, OfAnotherSizeOrKindAreRefused) {
  RenderedSet set = test::write_picture_set(fresh_folder("pictures-size"), {.width_px = 64, .height_px = 48});
  EXPECT_EQ(run_seamline("verify " + set.folder.string()).status, 0);
  const Manifest right = set.manifest;
  const auto put = [&](const std::string& file, const ByteImage& picture) {
    write_png(set.folder / file, picture);
    return sha256_of_file(set.folder / file);
  };
  set.manifest.stimuli[2].sha256 = put(set.manifest.stimuli[2].image, test::noise_with_discs(32, 48, 3));
  write_manifest(set.folder, set.manifest);
  expect_refused(set, "wanted 64 x 48 pixels with 3 channels, as in the manifest, found 32 x 48 pixels");

  set.manifest = right;
  (void)put(set.manifest.stimuli[2].image, test::noise_with_discs(64, 48, 3));
  set.manifest.references[0].object_ids_sha256 = put("room-ids.png", test::noise_with_discs(64, 48, 3));
  write_manifest(set.folder, set.manifest);
  expect_refused(set, "room-ids.png: wanted 64 x 48 pixels with 1 channels");
}

TEST(SetPictures, OfAStimulusThatAreNotItsScenesAreRefused) {
  RenderedSet set =
      test::write_picture_set(fresh_folder("pictures-names"), {.width_px = 64, .height_px = 48});
  write_png(set.folder / "tiny.png", test::disc_ids(4, 4));
  set.manifest.stimuli[1].object_ids = "tiny.png";
  write_manifest(set.folder, set.manifest);
  expect_refused(set, "stimuli[1].object_ids: wanted \"room-ids.png\", as in references, found \"tiny.png\"");
}

TEST(SetPictures, AReportWithoutOneSaysSo) {
  const RenderedSet set =
      test::write_picture_set(fresh_folder("pictures-report"), {.width_px = 64, .height_px = 48});
  const std::string folder = set.folder.string();
  ASSERT_EQ(
      run_seamline("study " + folder + " --observer threshold --count 4 --log " + folder + "/log.sqlite")
          .status,
      0);
  std::filesystem::remove(set.folder / "picture-0000.png");
  const Outcome outcome =
      run_seamline("analyze " + folder + "/log.sqlite --bootstrap 100 --out " + folder + "/report");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("picture-0000.png"));
  EXPECT_THAT(test::read_text(set.folder / "report" / "report.html"), HasSubstr("not shown: "));
}

}  // namespace
}  // namespace seamline
