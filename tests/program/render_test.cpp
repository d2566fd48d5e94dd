// `seamline render` as a whole: determinism, continuing, the contract of the manifest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "run_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::read_text;
using test::run_seamline;

std::string tiny_study() {
  return test::quick_study_with({{"width_px = 480", "width_px = 96"}, {"height_px = 270", "height_px = 54"}});
}

std::string render(const fs::path& folder, const std::string& set, const std::string& more) {
  return "render " + (folder / "study.toml").string() + " --out " + (folder / set).string() + " --spp 2 " +
         more;
}

TEST(Render, PaperStudyHas84Stimuli) {
  for (const char* study : {"depth_resolution.toml", "depth_resolution_isolated.toml"}) {
    const test::Outcome outcome = run_seamline("render " + (test::studies() / study).string() + " --dry-run");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 84);
    EXPECT_THAT(outcome.output, testing::HasSubstr("bedroom-receiver-statue-0512\n"));
  }
}

TEST(Render, SameBytesForOneAndTwoThreads) {
  const fs::path folder = fresh_folder("threads");
  test::write_text(folder / "study.toml", tiny_study());
  ASSERT_EQ(run_seamline(render(folder, "one", "--threads 1 --only '*-0256'")).status, 0);
  ASSERT_EQ(run_seamline(render(folder, "two", "--threads 2 --only '*-0256'")).status, 0);
  int files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "one")) {
    if (!entry.is_regular_file() || entry.path().filename() == "timings.json") continue;
    const fs::path other = folder / "two" / fs::relative(entry.path(), folder / "one");
    EXPECT_EQ(read_text(entry.path()), read_text(other)) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 12 + 6 + 1);
  EXPECT_EQ(run_seamline("verify " + (folder / "one").string()).status, 0);
}

TEST(Render, ContinuesWhereItWasStoppedAndEndsWithTheSameBytes) {
  const fs::path folder = fresh_folder("continue");
  test::write_text(folder / "study.toml", tiny_study());
  ASSERT_EQ(run_seamline(render(folder, "whole", "--only 'bedroom*-0064'")).status, 0);
  // Part of the work first, as after an interruption; then everything: only what is missing is rendered.
  ASSERT_EQ(run_seamline(render(folder, "parts", "--only 'bedroom*teapot-0064'")).status, 0);
  const test::Outcome rest = run_seamline(render(folder, "parts", "--only 'bedroom*-0064'"));
  EXPECT_THAT(rest.output, testing::HasSubstr("2 stimuli rendered, 1 kept from before"));
  EXPECT_EQ(read_text(folder / "whole" / "manifest.json"), read_text(folder / "parts" / "manifest.json"));
  // A damaged picture is rendered again.
  fs::resize_file(folder / "parts" / "stimuli" / "bedroom-receiver-statue-0064.png", 100);
  EXPECT_EQ(run_seamline("verify " + (folder / "parts").string()).status, 1);
  EXPECT_THAT(run_seamline(render(folder, "parts", "--only 'bedroom*-0064'")).output,
              testing::HasSubstr("1 stimuli rendered, 2 kept"));
  // Changed inputs: everything is rendered again.
  test::write_text(folder / "study.toml", test::quick_study_with({{"width_px = 480", "width_px = 96"},
                                                                  {"height_px = 270", "height_px = 54"},
                                                                  {"albedo = 0.5", "albedo = 0.4"}}));
  EXPECT_THAT(run_seamline(render(folder, "parts", "--only 'bedroom*-0064'")).output,
              testing::HasSubstr("3 stimuli rendered, 0 kept"));
}

TEST(Render, CtrlCStopsCleanlyAndARerunCompletes) {
  const fs::path folder = fresh_folder("interrupt");
  test::write_text(folder / "study.toml", tiny_study());
  // `timeout` sends SIGINT after a second; whatever was finished by then is kept.
  const std::string command = "timeout -s INT 1 " + std::string(SEAMLINE_PROGRAM) + " render " +
                              (folder / "study.toml").string() + " --out " + (folder / "set").string() +
                              " --spp 64 --only 'gazebo*-0064' >/dev/null 2>&1";
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status));
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "set"))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << "half-written: " << entry.path();
  EXPECT_EQ(run_seamline(render(folder, "set", "--only 'gazebo*-0064'")).status, 0);
  EXPECT_EQ(run_seamline("verify " + (folder / "set").string()).status, 0);
}

TEST(Render, ManifestKeepsItsContract) {
  const fs::path folder = fresh_folder("manifest");
  test::write_text(folder / "study.toml", tiny_study());
  ASSERT_EQ(run_seamline(render(folder, "set", "--only 'atrium*left-0064' --layers --contact-sheet")).status,
            0);
  const auto manifest = nlohmann::json::parse(read_text(folder / "set" / "manifest.json"));
  EXPECT_EQ(manifest["format"], "seamline set");
  ASSERT_EQ(manifest["stimuli"].size(), 1U);
  const auto& stimulus = manifest["stimuli"][0];
  for (const char* key :
       {"id", "scene", "artifact", "object", "object_index", "condition", "isolation", "image", "object_ids",
        "reference", "spp", "rays", "rmse", "mesh", "tiny_denominators", "sha256"})
    EXPECT_TRUE(stimulus.contains(key)) << key;
  EXPECT_EQ(stimulus["condition"]["depth_height_px"], 32);
  for (const char* file : {"study.toml", "timings.json", "contact-occlusion.png", "references/atrium.png",
                           "references/atrium-ids.png"})
    EXPECT_TRUE(fs::exists(folder / "set" / file)) << file;
  for (const char* layer : {"background.exr", "reference.exr", "with.exr", "without.exr", "ratio.exr",
                            "matte.exr", "composite.exr", "difference.exr", "local_scene.png"})
    EXPECT_TRUE(fs::exists(folder / "set" / "layers" / "atrium-occlusion-teapot_left-0064" / layer)) << layer;
}

}  // namespace
}  // namespace seamline
