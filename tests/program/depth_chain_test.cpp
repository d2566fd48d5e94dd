// Studies that say how depth is captured, as people run them.
#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "run_program.h"

namespace seamline {
namespace {

using test::fresh_folder;
using test::Outcome;
using test::read_text;
using test::run_seamline;
using test::studies;
using test::write_text;
using testing::HasSubstr;
using testing::Not;

/// The shipped study of noise in smaller pictures and with coarser meshes.
std::string small_study_text() {
  return test::with_replaced(read_text(studies() / "sensor_noise.toml"),
                             {{"width_px = 480", "width_px = 96"},
                              {"height_px = 270", "height_px = 54"},
                              {"seed = 1", "seed = 1\nmesh_tolerance = 1e-2"}});
}

/// The same with other levels and another table `depth`.
std::string study_text(const std::string& level_and_depth) {
  const std::string text = small_study_text();
  const std::size_t first = text.find("[level]"), last = text.find("# Pictures of half");
  return text.substr(0, first) + level_and_depth + "\n" + text.substr(last);
}

nlohmann::json manifest_of(const std::filesystem::path& set) {
  return nlohmann::json::parse(read_text(set / "manifest.json"));
}

TEST(DepthChain, ASetOfNoisyDepthIsRenderedCountedVerifiedAndKept) {
  const auto folder = fresh_folder("depth_chain");
  const std::string set = (folder / "set").string();
  write_text(folder / "study.toml", small_study_text());
  const std::string command = "render " + (folder / "study.toml").string() +
                              " --only 'bedroom-receiver-statue-*' --spp 2 --explain --out " + set;
  const Outcome outcome = run_seamline(command);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  for (const char* part : {"pinhole 320 x 288 px", "time_of_flight, scale 1", "registration       none",
                           "\nbedroom: holes in the depth pictures: "})
    EXPECT_THAT(outcome.output, HasSubstr(part));
  EXPECT_THAT(outcome.output, Not(HasSubstr("The levels differ in holes")));
  EXPECT_THAT(run_seamline("check " + set).output, HasSubstr("\nbedroom: holes in the depth pictures: "));
  const nlohmann::json manifest = manifest_of(set);
  EXPECT_EQ(manifest["version"], 2);
  std::set<int> holes;  // of the camera, whatever its noise
  for (const nlohmann::json& stimulus : manifest["stimuli"]) {
    const nlohmann::json& counts = stimulus["mesh"]["sensor"];
    EXPECT_EQ(counts["measured"].get<int>() + counts["holes"].get<int>() + counts["outliers"].get<int>(),
              320 * 288);
    const std::string depth = stimulus["condition"]["depth"];
    EXPECT_THAT(depth, HasSubstr(fmt::format(" scale {};", stimulus["level"]["value"].get<double>())));
    holes.insert(counts["holes"].get<int>());
  }
  EXPECT_GT(*holes.begin(), 0);
  EXPECT_LT(*holes.rbegin() - *holes.begin(), 320 * 288 / 100);
  EXPECT_EQ(run_seamline("verify " + set).status, 0);
  EXPECT_THAT(run_seamline(command).output, HasSubstr("0 stimuli rendered, 5 kept"));
  EXPECT_EQ(manifest_of(set), manifest);
  EXPECT_EQ(run_seamline(command + " --true-error 'bedroom-receiver-statue-0004*' --true-error-spp 2").status,
            0);
}

TEST(DepthChain, CheckSaysWhereLevelsDifferInHoles) {
  const auto folder = fresh_folder("depth_holes");
  const auto checked = [&](const std::string& noise) {
    write_text(
        folder / "study.toml",
        study_text("[level]\nquantity = \"depth_noise\"\nvalues = [0, 2]\n[depth]\nsource = \"pinhole\"\n"
                   "size_px = [64, 48]\nfield_of_view_deg = 60\nnoise = { " +
                   noise + " }\n"));
    return run_seamline("check " + (folder / "study.toml").string()).output;
  };
  EXPECT_THAT(checked("model = \"time_of_flight\", weakest_amplitude_e = 300"),
              testing::AllOf(HasSubstr("note    bedroom: holes in the depth pictures: "),
                             Not(HasSubstr("The levels differ in holes"))));
  EXPECT_THAT(
      checked("model = \"generic\", relative_sigma = 0.01, dropout_share = 0.05"),
      HasSubstr("The levels differ in holes: a threshold of the depth noise over them is one of holes"));
}

TEST(DepthChain, ADepthMapInAFileIsASourceAndAnotherFileIsAnotherPicture) {
  const auto folder = fresh_folder("depth_file_source");
  write_text(
      folder / "study.toml",
      study_text(
          "[level]\nquantity = \"calibration_error_m\"\nvalues = [0]\n"
          "[depth]\nsource = \"file\"\nfile = \"wall.pgm\"\nsize_px = [64, 48]\nfield_of_view_deg = 60\n"
          "convention = \"planar\"\nmetres_per_step = 0.001\n"));
  const auto write_wall = [&](char high_byte) {
    std::string bytes = "P5\n64 48\n65535\n";
    for (int i = 0; i < 64 * 48; ++i) bytes += {high_byte, '\0'};
    write_text(folder / "wall.pgm", bytes);
  };
  write_wall('\x0f');  // 3.84 m
  const std::string command = "render " + (folder / "study.toml").string() +
                              " --only 'bedroom-receiver-statue-*' --spp 2 --out " +
                              (folder / "set").string();
  const Outcome outcome = run_seamline(command);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const nlohmann::json mesh = manifest_of(folder / "set")["stimuli"][0]["mesh"];
  EXPECT_EQ(mesh["sensor"]["measured"], 64 * 48);
  EXPECT_LT(mesh["triangles"], 600);  // a wall, and the picture's edges
  write_wall('\x10');
  EXPECT_THAT(run_seamline(command).output, HasSubstr("1 stimulus rendered, 0 kept"));
  write_text(folder / "wall.pgm", "P5\n32 48\n65535\n");
  const Outcome damaged = run_seamline(command);
  EXPECT_EQ(damaged.status, 1);
  EXPECT_THAT(damaged.output, HasSubstr("wall.pgm"));
}

}  // namespace
}  // namespace seamline
