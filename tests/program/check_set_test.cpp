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

/// A set whose references are grey. At the first level stimuli have a band of ten steps that is as wide as
/// the object's index says; at the others one of three steps, a pixel wider. 10 pixels are one degree.
RenderedSet set_of_bands(const std::string& name, const std::string& levels = "depth_width_px = [64, 128]\n",
                         const std::string& conditions = "") {
  const fs::path folder = test::fresh_folder(name);
  std::string text =
      "format = \"seamline study 1\"\nname = \"bands\"\nwidth_px = 64\nheight_px = 48\n" + levels +
      conditions +
      "[observer]\npixels_per_degree = 10\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\n"
      "artifacts = [\"receiver\"]\n[scene.sun]\nto_sun = [1, 1, 0]\nirradiance_w_m2 = [1, 1, 1]\n";
  for (const char* object : {"ball", "disc", "coin"})
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n", object);
  Manifest manifest = study::begin_set_of_text(folder, text);
  const auto put = [&](const std::string& file, const ByteImage& picture) {
    write_png(folder / file, picture);
    return sha256_of_file(folder / file);
  };
  const std::string ids = put("ids.png", test::disc_ids(64, 48)),
                    grey = put("grey.png", grey_with_band(0, 0));
  const double first = manifest.stimuli.front().stimulus.level;
  for (ManifestStimulus& record : manifest.stimuli) {
    const std::string& truth = truth_of(record.stimulus);
    if (std::none_of(manifest.references.begin(), manifest.references.end(),
                     [&](const ManifestReference& known) { return known.truth == truth; }))
      manifest.references.push_back({truth, "grey.png", "ids.png", grey, ids});
    record.reference = "grey.png";
    record.object_ids = "ids.png";
    const bool strong = record.stimulus.level == first;
    record.sha256 =
        put(record.image, grey_with_band(record.stimulus.object_index + (strong ? 0 : 1), strong ? 10 : 3));
  }
  write_manifest(folder, manifest);
  return study::load_rendered_set(folder);
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

TEST(CheckSet, KnowsEveryQuantityAndCondition) {
  const auto page_of = [](const RenderedSet& set) {
    const Outcome outcome = run_seamline("check " + set.folder.string() + " --out " + set.folder.string());
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return outcome.output + test::read_text(set.folder / "seams.html") +
           test::read_text(set.folder / "seams.csv");
  };
  // The sun's radius changes the truth, its axis is linear, and 0 is a level like others.
  const std::string sun = page_of(set_of_bands(
      "check-set-sun", "depth_width_px = 64\n[level]\nquantity = \"sun_radius_deg\"\nvalues = [0, 2.5]\n"));
  EXPECT_THAT(sun, HasSubstr("| receiver | 2.5 degrees "));
  EXPECT_THAT(sun, HasSubstr("object_index,sun_radius_deg,pixels_per_degree"));
  EXPECT_THAT(sun, HasSubstr("angular radius of the sun (degrees)"));
  const std::string mesh = page_of(set_of_bands(
      "check-set-mesh",
      "depth_width_px = 64\n[level]\nquantity = \"mesh_tolerance\"\nvalues = [0, 0.001, 0.1]\n"));
  EXPECT_THAT(mesh, HasSubstr("| receiver | none "));
  EXPECT_THAT(mesh, HasSubstr(">none<"));
  const std::string conditions = page_of(set_of_bands(
      "check-set-conditions", "depth_width_px = [64, 128]\n",
      "[[condition]]\nname = \"first\"\nisolation = \"query\"\n[[condition]]\nname = \"second\"\n"
      "isolation = \"mask\"\n"));
  EXPECT_THAT(conditions, HasSubstr("| receiver | second    | 64 px "));
  EXPECT_THAT(conditions, HasSubstr("receiver, second"));
  EXPECT_THAT(conditions, HasSubstr(",receiver,second,coin,"));
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
