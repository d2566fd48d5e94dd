// `seamline flip`: what people see of the difference between two pictures.
#include <gtest/gtest.h>

#include <cstdlib>

#include "refusal.h"
#include "run_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::run_seamline;

/// The mean that is said of a region.
double mean_of(const std::string& output, const std::string& region) {
  const std::string before = "\n" + region + ": mean ";
  const std::size_t at = ("\n" + output).find(before);
  EXPECT_NE(at, std::string::npos) << output;
  return at == std::string::npos ? -1 : std::atof(output.c_str() + at + before.size() - 1);
}

struct Pair {
  fs::path folder, first, second;
  [[nodiscard]] std::string files() const { return first.string() + " " + second.string(); }
};

/// Two pictures that differ in the left half alone.
Pair two_pictures(const std::string& name) {
  const fs::path folder = test::fresh_folder(name);
  Pair pair{folder, folder / "a.exr", folder / "b.exr"};
  Image image(128, 32, 3, 0.3F);
  write_exr(pair.first, image);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 40; ++x) image.set_rgb(x, y, Rgb(0.6F, 0.2F, 0.1F));
  write_exr(pair.second, image);
  return pair;
}

TEST(Flip, APictureDoesNotDifferFromItself) {
  const Pair pair = two_pictures("flip-same");
  const test::Outcome outcome = run_seamline("flip " + pair.first.string() + " " + pair.first.string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(mean_of(outcome.output, "picture"), 0);
}

TEST(Flip, IsSymmetricAndRegionsTogetherAreThePicture) {
  const Pair pair = two_pictures("flip-regions");
  const std::string regions = " --region left=0,0,64,32 --region right=64,0,64,32";
  const test::Outcome outcome =
      run_seamline("flip " + pair.files() + regions + " --map " + (pair.folder / "map.png").string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const double left = mean_of(outcome.output, "left"), right = mean_of(outcome.output, "right");
  EXPECT_GT(left, 0.05);
  EXPECT_LT(right, 0.001);
  EXPECT_NEAR((left + right) / 2, mean_of(outcome.output, "picture"), 1e-4);
  EXPECT_EQ(read_bytes_image(pair.folder / "map.png").width_px, 128);
  const test::Outcome turned =
      run_seamline("flip " + pair.second.string() + " " + pair.first.string() + regions);
  EXPECT_NEAR(mean_of(turned.output, "left"), left, 1e-4);
}

TEST(Flip, RefusesWhatItCannotCompare) {
  const Pair pair = two_pictures("flip-wrong");
  for (const char* region : {"left", "=0,0,8,8", "a=0,0,8", "a=0,0,8,8,8", "a=0,0,8,x", "a=-1,0,8,8",
                             "a=0,0,0,8", "a=100,0,29,8", "a=2147483647,0,8,8", "a=0,0,99999999999,8"})
    test::expect_refused("flip " + pair.files() + " --region " + region, "--region");
  write_exr(pair.folder / "small.exr", Image(64, 32, 3, 0.3F));
  test::expect_refused("flip " + pair.first.string() + " " + (pair.folder / "small.exr").string(),
                       "128 x 32");
  test::expect_refused("flip " + pair.files() + " --map map.exr", "--map");
}

}  // namespace
}  // namespace seamline
