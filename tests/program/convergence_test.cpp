// `seamline lab convergence` as a whole: its files, their columns, and slopes that are numbers. Never a time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "run_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using test::run_seamline;
using testing::HasSubstr;
using testing::StartsWith;

std::string convergence(const fs::path& study, const fs::path& out, const std::string& more) {
  return "lab convergence " + study.string() + " --out " + out.string() +
         " --size 32x18 --spp 2 --seconds 0.5 " + more;
}

int lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// The slope of a series' error that was found; NaN where there is none.
double slope_of(const fs::path& folder, const std::string& series) {
  std::istringstream slopes(read_text(folder / "slopes.csv"));
  for (std::string line; std::getline(slopes, line);)
    if (line.starts_with(series)) return std::stod(line.substr(series.size()));
  return std::nan("");
}

TEST(Convergence, WritesEveryPart) {
  const fs::path folder = test::fresh_folder("convergence");
  const std::string from = "depth_width_px = [64, 256, 512, 1024, 2048]";
  test::write_text(folder / "study.toml", test::quick_study_with({{from, "depth_width_px = [64, 128]"}}));
  const test::Outcome outcome =
      run_seamline(convergence(folder / "study.toml", folder / "out",
                               "--tolerances 1e-2,1e-3 --only atrium-occlusion-teapot_middle-0064"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto csv = [&](const char* name) { return read_text(folder / "out" / name); };
  EXPECT_THAT(csv("samples.csv"), StartsWith("series,spp,seconds,rays,rmse,rmse_given\npath coupled,1,"));
  EXPECT_THAT(csv("mesh.csv"),
              StartsWith("tolerance,triangles,build_seconds,bvh_seconds,mesh_mb,embree_mb,"
                         "mrays_per_second,depth_error,rmse,changed_share,largest_change\n"));
  EXPECT_EQ(lines(csv("mesh.csv")), 1 + 3 + 1);  // header, these tolerances and the study's, full density
  EXPECT_THAT(csv("width.csv"), StartsWith("width,texels_per_pixel,rmse,"));
  EXPECT_EQ(lines(csv("width.csv")), 1 + 2);
  EXPECT_EQ(lines(csv("compositing.csv")), 1 + 4);
  for (const char* figure : {"samples.svg", "mesh.svg", "width.svg"})
    EXPECT_THAT(csv(figure), HasSubstr("</svg>")) << figure;
  EXPECT_THAT(csv("convergence.md"), HasSubstr("## slopes"));
  EXPECT_THAT(outcome.output, HasSubstr(csv("convergence.md")));
  EXPECT_THAT(csv("data_dictionary.csv"), HasSubstr("mesh.csv,depth_error"));
}

TEST(Convergence, MeansOfFramesComeNearerToTheTruth) {
  const fs::path folder = test::fresh_folder("convergence-frames");
  ASSERT_EQ(run_seamline(convergence(test::studies() / "quick.toml", folder,
                                     "--parts sensor,repair --only bedroom-receiver-statue-0064"))
                .status,
            0);
  EXPECT_THAT(read_text(folder / "sensor.csv"), StartsWith("series,frames,seconds,error\n"));
  EXPECT_THAT(read_text(folder / "repair.csv"), StartsWith("series,radius_or_draws,seconds,error\n"));
  EXPECT_NEAR(slope_of(folder, "sensor,time of flight,error in frames,"), -0.5, 0.05);
}

TEST(Convergence, RegistrationFollowsThePixelsOfTheDepthCamera) {
  const fs::path folder = test::fresh_folder("convergence-registration");
  ASSERT_EQ(run_seamline(convergence(test::studies() / "quick.toml", folder,
                                     "--parts registration --only bedroom-receiver-statue-0064"))
                .status,
            0);
  EXPECT_THAT(read_text(folder / "registration.csv"), StartsWith("series,depth_width_px,seconds,error\n"));
  EXPECT_NEAR(slope_of(folder, "registration,points,error in depth_width_px,"), 0, 0.1);
  EXPECT_NEAR(slope_of(folder, "registration,mesh,error in depth_width_px,"), -2, 0.1);
}

TEST(Convergence, AMaskAnswersInPlaceOfTheDepthMap) {
  const fs::path folder = test::fresh_folder("convergence-mitigation");
  const test::Outcome outcome =
      run_seamline(convergence(test::studies() / "quick.toml", folder,
                               "--parts mitigation,filter --only atrium-occlusion-teapot_middle-0064"));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(read_text(folder / "mitigation.csv"), StartsWith("series,width_px,seconds,error\n"));
  EXPECT_THAT(read_text(folder / "filter.csv"), StartsWith("series,samples a pixel,seconds,error\n"));
  const auto error_at = [&](const std::string& table, const std::string& row) {
    std::istringstream rows(read_text(folder / table));
    for (std::string line; std::getline(rows, line);)
      if (line.starts_with(row)) return std::stod(line.substr(line.rfind(',') + 1));
    return std::nan("");
  };
  // Who is in front is all that this stimulus asks, and the widest painted mask is nearly the truth.
  EXPECT_LT(error_at("mitigation.csv", "painted mask and matte,1024,"),
            0.5 * error_at("mitigation.csv", "depth mesh,32,"));
  EXPECT_LT(slope_of(folder, "filter,no filter,error in samples a pixel,"), -0.3);
}

TEST(Convergence, SlopesOfSamplesAreNumbers) {
  const fs::path folder = test::fresh_folder("convergence-slopes");
  ASSERT_EQ(run_seamline(convergence(test::studies() / "quick.toml", folder,
                                     "--parts samples --only bedroom-receiver-statue-0064"))
                .status,
            0);
  std::istringstream slopes(read_text(folder / "slopes.csv"));
  std::string line;
  std::getline(slopes, line);
  ASSERT_EQ(line, "part,series,of,found,expected,why");
  int of_path = 0;
  while (std::getline(slopes, line)) {
    const std::size_t expected = line.find(",-0.5,");
    ASSERT_NE(expected, std::string::npos) << line;
    const std::string found = line.substr(line.rfind(',', expected - 1) + 1);
    if (found.front() == ',') continue;  // too few errors that are clear of the reference's noise
    const double slope = std::stod(found);
    EXPECT_TRUE(std::isfinite(slope)) << line;
    // Without bias, more samples are less error. Seconds are not asked.
    if (line.find(",path ") == std::string::npos || line.find("in samples") == std::string::npos) continue;
    EXPECT_LT(slope, 0) << line;
    ++of_path;
  }
  EXPECT_EQ(of_path, 3 * 2);
  EXPECT_FALSE(fs::exists(folder / "mesh.csv"));
}

TEST(Convergence, WrongInputIsExitStatusOne) {
  const fs::path folder = test::fresh_folder("convergence-wrong");
  const std::string study = (test::studies() / "quick.toml").string();
  const auto complaint = [&](const std::string& more) {
    const test::Outcome outcome =
        run_seamline("lab convergence " + study + " --out " + (folder / "out").string() + " " + more);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    return outcome.output;
  };
  EXPECT_THAT(complaint("--only 'bedroom*'"), HasSubstr("--only: wanted a pattern that matches one"));
  EXPECT_THAT(complaint("--only no-such"), HasSubstr("which matches 0"));
  EXPECT_THAT(complaint("--only bedroom-receiver-statue-0064 --size 48"), HasSubstr("--size: wanted WxH"));
  EXPECT_THAT(complaint("--only bedroom-receiver-statue-0064 --size 2x2"), HasSubstr("\"2x2\""));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
}  // namespace seamline
