// `seamline render` as a whole: determinism, continuing, the contract of the manifest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>
#include <vector>

#include "run_program.h"
#include "running_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::read_text;
using test::run_seamline;

std::string tiny_study() {
  return test::small_study_with({});
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

/// Files that say how long rendering took.
bool is_about_the_run(const fs::path& file) {
  return file.filename() == "timings.json" || file.stem() == "errors";
}

TEST(Render, SameBytesForOneAndTwoThreads) {
  const fs::path folder = fresh_folder("threads");
  test::write_small_study(folder, tiny_study());
  ASSERT_EQ(run_seamline(render(folder, "one", "--threads 1 --only '*-0256'")).status, 0);
  ASSERT_EQ(run_seamline(render(folder, "two", "--threads 2 --only '*-0256'")).status, 0);
  int files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "one")) {
    if (!entry.is_regular_file() || is_about_the_run(entry.path())) continue;
    const fs::path other = folder / "two" / fs::relative(entry.path(), folder / "one");
    EXPECT_EQ(read_text(entry.path()), read_text(other)) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 12 + 6 + 1);
  EXPECT_EQ(run_seamline("verify " + (folder / "one").string()).status, 0);
}

/// The bedroom alone at two widths, with conditions or without.
std::string bedroom_study(const std::string& conditions) {
  std::string text = test::small_study_with({{"[64, 256, 512, 1024, 2048]", "[64, 512]"}});
  text.erase(text.find("# Types 2 and 4"));
  return text + conditions;
}

TEST(Render, ConditionsShareTheTruthOfOneLightAndCostOthersNothing) {
  const fs::path folder = fresh_folder("conditions");
  test::write_small_study(folder, bedroom_study(""));
  ASSERT_EQ(run_seamline(render(folder, "without", "")).status, 0);
  test::write_text(
      folder / "study.toml",
      bedroom_study("[[condition]]\nname = \"plain\"\n[[condition]]\nname = \"turned\"\nyaw_texels = 0.5\n"
                    "[[condition]]\nname = \"soft\"\nsun_radius_deg = 2.0\n"));
  const test::Outcome outcome = run_seamline(render(folder, "with", "--contact-sheet"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const nlohmann::json manifest = nlohmann::json::parse(read_text(folder / "with/manifest.json"));
  EXPECT_EQ(manifest["version"], 2);
  ASSERT_EQ(manifest["references"].size(), 2U);
  ASSERT_EQ(manifest["stimuli"].size(), 18U);
  EXPECT_TRUE(read_text(folder / "without/references/bedroom.png") ==
              read_text(folder / "with/references/bedroom-plain.png"));
  EXPECT_TRUE(read_text(folder / "without/references/bedroom.png") !=
              read_text(folder / "with/references/bedroom-soft.png"));
  for (const char* level : {"0064", "0512"}) {
    const auto picture = [&](const std::string& set, const std::string& condition) {
      return read_text(folder / set / ("stimuli/bedroom-receiver-statue-" + condition + level) += ".png");
    };
    EXPECT_TRUE(picture("without", "") == picture("with", "plain-")) << level;
    EXPECT_TRUE(picture("without", "") != picture("with", "soft-")) << level;
  }
  EXPECT_EQ(run_seamline("verify " + (folder / "with").string()).status, 0);
  // Above each row of the contact sheet stands whose it is: nine rows below the line of widths.
  const ByteImage sheet = read_bytes_image(folder / "with/contact-receiver.png");
  std::set<std::vector<std::uint8_t>> names;
  constexpr int line_px = 26, row_px = line_px + 200 + 6;
  ASSERT_EQ(sheet.height_px, line_px + 9 * row_px + 6);
  const auto values_of_lines = static_cast<std::ptrdiff_t>(sheet.width_px) * 3;
  for (int row = 0; row < 9; ++row) {
    const auto top = sheet.values.begin() + (line_px + row * row_px) * values_of_lines;
    names.emplace(top, top + line_px * values_of_lines);
  }
  EXPECT_EQ(names.size(), 9U);
}

TEST(Render, ALevelOfNoneIsTheFullMesh) {
  const fs::path folder = fresh_folder("tolerances");
  test::write_small_study(
      folder, test::small_study_with(
                  {{"mesh = \"adaptive\"\n", ""},
                   {"mesh_tolerance = 1e-4\n", ""},
                   {"depth_width_px = [64, 256, 512, 1024, 2048]",
                    "depth_width_px = 256\n[level]\nquantity = \"mesh_tolerance\"\nvalues = [0, 0.1]"}}));
  ASSERT_EQ(run_seamline(render(folder, "set", "--only 'bedroom*statue*'")).status, 0);
  const nlohmann::json manifest = nlohmann::json::parse(read_text(folder / "set/manifest.json"));
  ASSERT_EQ(manifest["stimuli"].size(), 2U);
  EXPECT_EQ(manifest["stimuli"][0]["id"], "bedroom-receiver-statue-0p000000000");
  EXPECT_EQ(manifest["stimuli"][0]["mesh"]["max_relative_error"], 0);
  EXPECT_GT(manifest["stimuli"][0]["mesh"]["triangles"], 100000);
  EXPECT_LT(manifest["stimuli"][1]["mesh"]["triangles"], 50000);
  const test::Outcome refused = run_seamline(render(folder, "other", "--mesh full"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.output,
              testing::HasSubstr("--mesh: wanted a study whose conditions and levels leave the mesh"));
}

TEST(Render, ContinuesWhereItWasStoppedAndEndsWithTheSameBytes) {
  const fs::path folder = fresh_folder("continue");
  test::write_small_study(folder, tiny_study());
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
              testing::HasSubstr("1 stimulus rendered, 2 kept"));
  // Changed inputs: everything is rendered again.
  test::write_small_study(folder, test::small_study_with({{"albedo = 0.5", "albedo = 0.4"}}));
  EXPECT_THAT(run_seamline(render(folder, "parts", "--only 'bedroom*-0064'")).output,
              testing::HasSubstr("3 stimuli rendered, 0 kept"));
}

TEST(Render, CtrlCStopsCleanlyAndARerunContinues) {
  const fs::path folder = fresh_folder("interrupt"), stimuli = folder / "set" / "stimuli";
  test::write_small_study(folder, tiny_study());
  const std::vector<std::string> arguments = {"render", (folder / "study.toml").string(),
                                              "--out",  (folder / "set").string(),
                                              "--spp",  "128",
                                              "--only", "gazebo*-0064"};
  // Interrupted as soon as one stimulus is finished: several are not.
  const test::Running running = test::start(arguments, folder / "output.txt");
  const auto finished = [&] {
    return fs::exists(stimuli) && std::any_of(fs::directory_iterator(stimuli), {}, [](const auto& entry) {
             return !entry.path().filename().string().starts_with(".");
           });
  };
  for (int i = 0; i < 10000 && !finished(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_EQ(test::status_after(running, SIGINT), 130) << read_text(running.output);
  ASSERT_TRUE(finished());
  EXPECT_FALSE(fs::exists(folder / "set" / "manifest.json"));
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder / "set"))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << "half-written: " << entry.path();
  std::string again;
  for (const std::string& argument : arguments) again += "'" + argument + "' ";
  const test::Outcome rest = test::run_built(again);
  EXPECT_EQ(rest.status, 0) << rest.output;
  EXPECT_THAT(rest.output, testing::ContainsRegex("[1-9][0-9]* kept from before"));
  EXPECT_EQ(run_seamline("verify " + (folder / "set").string()).status, 0);
}

TEST(Render, AFailedRunLeavesAFinishedSetAsItWas) {
  const fs::path folder = fresh_folder("failed-run");
  test::write_small_study(folder, tiny_study());
  ASSERT_EQ(run_seamline(render(folder, "set", "--only 'atrium*left-0064'")).status, 0);
  const std::string study = read_text(folder / "set" / "study.toml"),
                    manifest = read_text(folder / "set" / "manifest.json");
  test::write_text(folder / "study.toml",
                   "# changed\n" + test::small_study_with({{"albedo = 0.5", "albedo = 0.4"}}));
  EXPECT_EQ(run_seamline(render(folder, "set", "--only 'zzz*'")).status, 1);
  EXPECT_EQ(read_text(folder / "set" / "study.toml"), study);
  EXPECT_EQ(read_text(folder / "set" / "manifest.json"), manifest);
  EXPECT_EQ(run_seamline("verify " + (folder / "set").string()).status, 0);
  EXPECT_EQ(run_seamline(render(folder, "fresh", "--only 'zzz*'")).status, 1);
  EXPECT_FALSE(fs::exists(folder / "fresh"));
}

TEST(Render, ShardsTogetherMakeTheWholeSet) {
  const fs::path folder = fresh_folder("shards");
  test::write_small_study(folder, tiny_study());
  ASSERT_EQ(run_seamline(render(folder, "whole", "--only 'gazebo*-0064'")).status, 0);
  for (const char* shard : {"1/4", "2/4", "3/4", "4/4"})
    ASSERT_EQ(
        run_seamline(render(folder, "shards", std::string("--only 'gazebo*-0064' --shard ") + shard)).status,
        0);
  EXPECT_EQ(read_text(folder / "whole" / "manifest.json"), read_text(folder / "shards" / "manifest.json"));
  EXPECT_EQ(run_seamline(render(folder, "none", "--shard 5/4")).status, 1);
}

TEST(Render, ChangedBufferOfAGltfFileIsRenderedAgain) {
  const fs::path folder = fresh_folder("buffers");
  test::write_small_study(folder, tiny_study());
  ASSERT_THAT(run_seamline(render(folder, "set", "--only 'bedroom*statue-0064'")).output,
              testing::HasSubstr("1 stimulus rendered"));
  ASSERT_THAT(run_seamline(render(folder, "set", "--only 'bedroom*statue-0064'")).output,
              testing::HasSubstr("0 stimuli rendered, 1 kept"));
  test::write_cube(folder, 0.5F);
  EXPECT_THAT(run_seamline(render(folder, "set", "--only 'bedroom*statue-0064'")).output,
              testing::HasSubstr("1 stimulus rendered"));
}

TEST(Render, ManifestKeepsItsContract) {
  const fs::path folder = fresh_folder("manifest");
  test::write_small_study(folder, tiny_study());
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
