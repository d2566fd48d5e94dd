// The building blocks on a user's own files: capture, mesh, composite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::run_seamline;

TEST(Workbench, AnObjectIsCompositedIntoAPhotographThroughItsDepthMap) {
  const fs::path folder = test::fresh_folder("workbench");
  const auto in = [&](const char* name) { return (folder / name).string(); };
  ASSERT_EQ(run_seamline("capture builtin:bedroom --width 512 --out " + in("depth.exr")).status, 0);
  ASSERT_EQ(run_seamline("mesh " + in("depth.exr") + " --out " + in("local.glb")).status, 0);
  // The mesh is a scene file again: captured from its own centre it gives the same depth, within its bound
  // and the grid's.
  ASSERT_EQ(
      run_seamline("capture " + in("local.glb") + " --at 0 0 0 --width 512 --out " + in("again.exr")).status,
      0);
  const Image depth = read_image(folder / "depth.exr"), again = read_image(folder / "again.exr");
  int near = 0, finite = 0;
  for (std::size_t i = 0; i < depth.values.size(); ++i) {
    if (std::isinf(depth.values[i])) continue;
    ++finite;
    near += std::abs(again.values[i] / depth.values[i] - 1) < 2e-3 ? 1 : 0;
  }
  EXPECT_GT(near, finite * 0.9);

  Image photograph(120, 68, 3, 0.4F);
  write_exr(folder / "photo.exr", photograph);
  const std::string composite =
      "composite --background " + in("photo.exr") + " --depth " + in("depth.exr") +
      " --object builtin:lion --position 0.2 -1.9 -3.4 --scale 0.5 --look-at 0 -0.206 -1 --fov 61"
      " --to-sun -0.69 0.32 0.65 --sun-irradiance 4 4 4 --environment 0.1 0.1 0.1 --bounces 1 --spp 8 "
      "--tolerance 1e-3 ";
  ASSERT_EQ(run_seamline(composite + "--out " + in("ratio.exr")).status, 0);
  ASSERT_EQ(run_seamline(composite + "--additive --out " + in("additive.exr")).status, 0);
  const Image ratio = read_image(folder / "ratio.exr");
  int same = 0, darker = 0;
  for (int y = 0; y < ratio.height_px; ++y)
    for (int x = 0; x < ratio.width_px; ++x) {
      same += std::abs(ratio.at(x, y) - 0.4F) < 0.03F ? 1 : 0;
      darker += ratio.at(x, y) < 0.25F ? 1 : 0;
    }
  EXPECT_GT(same, ratio.width_px * ratio.height_px * 6 / 10);
  EXPECT_GT(darker, 40);
  EXPECT_NE(read_image(folder / "additive.exr").values, ratio.values);
}

TEST(Workbench, PlacesAreWrittenWithBlanksOrCommasAndEndingsInAnyLetters) {
  const fs::path folder = test::fresh_folder("workbench-commas");
  const auto in = [&](const char* name) { return (folder / name).string(); };
  write_exr(folder / "panorama.exr", Image(32, 16, 3, 0.5F));
  write_exr(folder / "depth.exr", Image(32, 16, 1, 3.0F));
  const std::string composite = "composite --background " + in("panorama.exr") + " --depth " +
                                in("depth.exr") +
                                " --object builtin:statue --height 1 --spp 2 --tolerance 0.01 --threads 1";
  ASSERT_EQ(run_seamline(composite + " --position 0,-1,-2 --out " + in("a.PNG")).status, 0);
  ASSERT_EQ(run_seamline(composite + " --position 0 -1 -2 --out " + in("b.png")).status, 0);
  EXPECT_EQ(test::read_text(folder / "a.PNG"), test::read_text(folder / "b.png"));
  const test::Outcome two = run_seamline(composite + " --position 0,-1 --out " + in("c.png"));
  EXPECT_NE(two.status, 0);
  EXPECT_THAT(two.output, testing::HasSubstr("--position"));
}

TEST(Workbench, WrongFilesAreExitStatusOne) {
  const fs::path folder = test::fresh_folder("workbench-wrong");
  write_exr(folder / "odd.exr", Image(10, 4, 1, 1.0F));
  const test::Outcome outcome =
      run_seamline("mesh " + (folder / "odd.exr").string() + " --out " + (folder / "m.glb").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.output, testing::HasSubstr("odd.exr"));
  write_exr(folder / "sky.exr", Image(8, 4, 1, std::numeric_limits<float>::infinity()));
  EXPECT_EQ(
      run_seamline("mesh " + (folder / "sky.exr").string() + " --out " + (folder / "m.glb").string()).status,
      1);
  EXPECT_FALSE(fs::exists(folder / "m.glb"));
}

}  // namespace
}  // namespace seamline
