// Panoramas of a page: the sum of the files that stand for one is what the set shows, code by code.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/online/page/web_export.h"
#include "study/online/page/web_pictures.h"
#include "study/trials/trial_picture.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "tests/app/picture_set.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;

constexpr const char* turned = R"(
[scene.camera]
projection = "panorama"
[look]
kind = "mouse"
view_px = [64, 64]
fov_limits_deg = [40, 90]
[consent]
text = "Discs."
[catch]
attention = 1
reference = 1
)";

TEST(WebPanorama, FilesAddUpToWhatTheSetShows) {
  if (!fs::exists(web_page_folder() / "jspsych.js")) GTEST_SKIP() << "built without the page (jsPsych)";
  const TemporaryFolder folder;
  RenderedSet set = test::write_picture_set(
      folder / "set", {.width_px = 256, .height_px = 128, .widths = "64, 128", .more = turned});
  // A part of each stimulus differs from the reference, by codes that leave 0 to 255; the last one is of one
  // grey, which is smaller whole.
  const ByteImage reference = read_bytes_image(folder / "set/room.png");
  const std::size_t stimuli = set.manifest.stimuli.size();
  for (std::size_t i = 0; i < stimuli; ++i) {
    ByteImage picture = reference;
    for (std::size_t at = 1000 * i; at < 1000 * i + 5000; ++at)
      picture.values[at] = static_cast<std::uint8_t>(picture.values[at] + 1 + 50 * i);
    if (i + 1 == stimuli) std::fill(picture.values.begin(), picture.values.end(), std::uint8_t{77});
    write_png(folder / "set" / set.manifest.stimuli[i].image, picture);
    set.manifest.stimuli[i].sha256 = sha256_of_file(folder / "set" / set.manifest.stimuli[i].image);
  }
  write_manifest(folder / "set", set.manifest);
  set = load_rendered_set(folder / "set");
  (void)export_web({.set_folder = folder / "set", .out_folder = folder / "page", .slots = 3});

  const ShownNames names(set);
  fs::create_directories(folder / "again");
  WebFiles files(folder / "again");
  const WebPictures pictures = add_pictures(set, names, files);
  std::size_t whole_bytes = 0, bytes = 0;
  for (const auto& [shown, file] : pictures.file) {
    const Trial trial{.kind = shown.first, .stimulus = shown.second};
    ByteImage sum = read_bytes_image(folder / "page" / file);
    const auto base = pictures.base.find(file);
    const bool last = shown.second + 1 == static_cast<int>(stimuli);
    EXPECT_EQ(base != pictures.base.end(),
              trial.kind == TrialKind::attention || (trial.kind == TrialKind::stimulus && !last))
        << "differences where they are smaller";
    if (base != pictures.base.end()) {
      const ByteImage under = read_bytes_image(folder / "page" / base->second);
      for (std::size_t i = 0; i < sum.values.size(); ++i)
        sum.values[i] = static_cast<std::uint8_t>(sum.values[i] + under.values[i]);
    }
    EXPECT_EQ(sum.values, load_trial_picture(set, trial).values) << file;
    if (trial.kind != TrialKind::stimulus) continue;
    bytes += fs::file_size(folder / "page" / file);
    whole_bytes +=
        fs::file_size(folder / "set" / set.manifest.stimuli.at(static_cast<std::size_t>(shown.second)).image);
  }
  EXPECT_LT(3 * bytes, whole_bytes);

  // study.json tells the page which file is added to which.
  const auto study = nlohmann::json::parse(read_file(folder / "page/study.json"));
  std::size_t differences = 0;
  for (const auto& picture : study.at("pictures")) {
    if (!picture.contains("base")) continue;
    ++differences;
    EXPECT_EQ(picture.at("base"), pictures.base.at(picture.at("file").get<std::string>()));
  }
  EXPECT_EQ(differences, pictures.base.size());
  EXPECT_EQ(study.at("looks").at(0).at("fov_limits_deg").dump(), "[40.0,90.0]");
}

}  // namespace
}  // namespace seamline::study::online
