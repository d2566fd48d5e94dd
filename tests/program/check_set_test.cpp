// `seamline check SET` on pictures whose seams are known.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using study::RenderedSet;
using test::Outcome;
using test::run_seamline;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// A grey picture with a band as high as the picture.
ByteImage grey_with_band(int band_px, int steps) {
  ByteImage image{64, 48, 3, {}};
  for (int i = 0; i < 64 * 48; ++i)
    for (int c = 0; c < 3; ++c)
      image.values.push_back(
          static_cast<std::uint8_t>(i % 64 >= 20 && i % 64 < 20 + band_px ? 100 + steps : 100));
  return image;
}

/// Bands of ten steps and a width of the object's index, at the first level; of three steps and a pixel more
/// at the second. 10 pixels are one degree.
RenderedSet set_of_bands(const std::string& name, const std::string& more = "", const std::string& top = "") {
  RenderedSet set = test::write_picture_set(
      test::fresh_folder(name),
      {.width_px = 64, .height_px = 48, .top = top, .more = "[observer]\npixels_per_degree = 10\n" + more});
  const auto put = [&](const std::string& file, int band_px, int steps) {
    write_png(set.folder / file, grey_with_band(band_px, steps));
    return sha256_of_file(set.folder / file);
  };
  for (ManifestReference& reference : set.manifest.references)
    reference.image_sha256 = put(reference.image, 0, 0);
  const double first = set.manifest.stimuli.front().stimulus.level;
  for (ManifestStimulus& record : set.manifest.stimuli) {
    const bool strong = record.stimulus.level == first;
    record.sha256 = put(record.image, record.stimulus.object_index + (strong ? 0 : 1), strong ? 10 : 3);
  }
  write_manifest(set.folder, set.manifest);
  return set;
}

TEST(CheckSet, MeasuresSeamsInPixelsAndDegrees) {
  const RenderedSet set = set_of_bands("check-set");
  const fs::path out = set.folder / "seams";
  const Outcome outcome = run_seamline("check " + set.folder.string() + " --out " + out.string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("2, 4 and 8 steps of 255 beyond noise"));
  EXPECT_THAT(outcome.output, HasSubstr("10 pixels per degree"));
  // Means over bands of 1, 2 and 3 pixels, 48 high: 96 px, 0.96 square degrees, 2 px, 0.2 degrees.
  EXPECT_THAT(
      outcome.output,
      HasSubstr("| receiver | 64 px           | 96 (0.9600)  | 96 (0.9600) | 96 (0.9600) | 2.0 (0.200) | "
                "2.0 (0.200) | 2.0 (0.200) |"));
  EXPECT_THAT(
      outcome.output,
      HasSubstr("| receiver | 128 px          | 144 (1.4400) | 0 (0.0000)  | 0 (0.0000)  | 3.0 (0.300) | "
                "0.0 (0.000) | 0.0 (0.000) |"));
  const std::string csv = test::read_text(out / "seams.csv");
  EXPECT_THAT(csv,
              testing::StartsWith(
                  "stimulus,scene,artifact,condition,object,object_index,depth_width_px,pixels_per_degree,"
                  "noise_sd_steps,area_over_2_px,area_over_2_deg2,band_over_2_px,band_over_2_deg,"
                  "area_over_4_px,"));
  EXPECT_THAT(csv,
              HasSubstr("room-receiver-coin-0064,room,receiver,,coin,3,64,10,0,144,1.44,3,0.3,144,1.44,3,0.3,"
                        "144,1.44,3,0.3\n"));
  EXPECT_THAT(csv,
              HasSubstr("room-receiver-ball-0128,room,receiver,,ball,1,128,10,0,96,0.96,2,0.2,0,0,0,0,0,0,0,"
                        "0\n"));
  const std::string html = test::read_text(out / "seams.html");
  EXPECT_THAT(html, HasSubstr("<svg"));
  EXPECT_THAT(html, HasSubstr("<td>room-receiver-disc-0064</td><td>96</td>"));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  // Again: the same bytes; nothing else in the folder.
  ASSERT_EQ(run_seamline("check " + set.folder.string() + " --out " + out.string()).status, 0);
  EXPECT_EQ(test::read_text(out / "seams.csv"), csv);
  EXPECT_EQ(test::read_text(out / "seams.html"), html);
  EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator()), 2);
}

TEST(CheckSet, WithoutAFolderOnlyPrints) {
  const RenderedSet set = set_of_bands("check-set-prints");
  const auto files = [&] {
    return std::distance(fs::recursive_directory_iterator(set.folder), fs::recursive_directory_iterator());
  };
  const auto before = files();
  EXPECT_EQ(run_seamline("check " + set.folder.string()).status, 0);
  EXPECT_EQ(files(), before);
}

TEST(CheckSet, SaysInOneSentenceWhatIsWrong) {
  const fs::path empty = test::fresh_folder("check-set-empty");
  const auto expect_refused = [](const std::string& arguments, const std::string& part) {
    const Outcome outcome = run_seamline("check " + arguments);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(part));
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  };
  expect_refused(empty.string(), "manifest.json");
  const RenderedSet set = set_of_bands("check-set-bad");
  const std::string folder = set.folder.string();
  const std::string study = (test::studies() / "quick.toml").string();
  expect_refused(folder + " --asset-root " + folder, "--asset-root: wanted only with a study file");
  expect_refused(study + " --out " + folder + "/out", "--out: wanted only with the folder of a rendered set");
  Manifest manifest = set.manifest;
  const fs::path picture = set.folder / manifest.stimuli[2].image;
  write_png(picture, test::noise_with_discs(32, 48, 3));
  manifest.stimuli[2].sha256 = sha256_of_file(picture);
  write_manifest(set.folder, manifest);
  expect_refused(folder, "wanted 64 x 48 pixels with 3 channels, as in the manifest, found 32 x 48 pixels");
  test::write_text(picture, "no picture");
  manifest.stimuli[2].sha256 = sha256_of_file(picture);
  write_manifest(set.folder, manifest);
  expect_refused(folder, picture.filename().string());
  fs::remove(picture);
  expect_refused(folder, picture.filename().string());
}

}  // namespace
}  // namespace seamline
