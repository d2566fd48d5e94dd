// From a sensor to a composite on files alone: sense, register, composite.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::run_seamline;

/// What a time-of-flight rig delivers of the bedroom, once.
const fs::path& sensed() {
  static const fs::path folder = [] {
    // Of the test that asks first: two of them may run side by side.
    fs::path made = test::fresh_folder(std::string("sense-") +
                                       testing::UnitTest::GetInstance()->current_test_info()->name());
    const test::Outcome outcome =
        run_seamline("sense builtin:bedroom --sensor tof_160x120 --spp 1 --bounces 0 --out " + made.string());
    if (outcome.status != 0) throw std::runtime_error(outcome.output);
    return made;
  }();
  return folder;
}

int different_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < a.height_px; ++y)
    for (int x = 0; x < a.width_px; ++x)
      count += (a.rgb(x, y) - b.rgb(x, y)).abs().maxCoeff() > 0.02F ? 1 : 0;
  return count;
}

TEST(Sense, WithoutNoiseTheDepthIsWhatTheInstrumentSeesOfTheTruth) {
  const fs::path quiet = test::fresh_folder("sense-quiet");
  ASSERT_EQ(run_seamline("sense builtin:bedroom --sensor tof_160x120 --noise 0 --spp 1 --bounces 0 --out " +
                         quiet.string())
                .status,
            0);
  // What the sensor sees without noise is the truth, but for its holes, and where a pixel sees two surfaces.
  const Image depth = read_image(quiet / "depth.exr"), truth = read_image(quiet / "true_depth.exr");
  std::size_t same = 0;
  for (std::size_t i = 0; i < depth.values.size(); ++i)
    same += std::abs(depth.values[i] - truth.values[i]) <= 0.01F * truth.values[i] ? 1 : 0;
  EXPECT_GT(same, depth.values.size() * 17 / 20);
  EXPECT_EQ(test::read_text(quiet / "true_depth.exr"), test::read_text(sensed() / "true_depth.exr"));
  EXPECT_NE(test::read_text(sensed() / "depth.exr"), test::read_text(quiet / "depth.exr"));
  EXPECT_TRUE(fs::exists(quiet / "amplitude.exr"));
}

TEST(Sense, ItsFilesAreThoseThatRegisterAndCompositeRead) {
  const auto in = [](const fs::path& name) { return (sensed() / name).string(); };
  test::write_cube(sensed());
  const test::Outcome registered =
      run_seamline("register --depth " + in("depth.exr") + " --colour " + in("colour.exr") + " --camera " +
                   in("camera.toml") + " --repair nearest --extrude 40 --out " + in("registered"));
  ASSERT_EQ(registered.status, 0) << registered.output;
  const std::string composite =
      "composite --background " + in("colour.exr") + " --depth " + in("registered/registered.exr") +
      " --camera " + in("camera.toml") + " --object " + in("cube.gltf") +
      " --position 0 -1.5 -3.2 --scale 1.6 --tolerance 0.02 --environment 1 1 1 --spp 1 --bounces 0 "
      "--estimator path ";  // one estimator: pixels that differ are counted
  const auto picture = [&](const std::string& occlusion) {
    const fs::path out = sensed() / ("composite-" + occlusion + ".exr");
    std::string options = composite + "--occlusion " + occlusion + " --out " + out.string();
    const test::Outcome outcome = run_seamline(options);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return read_image(out);
  };
  const Image none = picture("none"), test = picture("depth_test"), buffer = picture("depth_buffer"),
              photograph = read_image(sensed() / "colour.exr");
  // Drawn over everything it covers the most; a depth test in metres and one in a fine buffer agree.
  EXPECT_GE(different_pixels(none, photograph), different_pixels(test, photograph));
  EXPECT_GT(different_pixels(test, photograph), 300);
  EXPECT_LT(different_pixels(test, buffer), 30);
}

TEST(Sense, OcclusionOnlyLeavesEveryOtherByteOfThePhotograph) {
  const auto in = [](const fs::path& name) { return (sensed() / name).string(); };
  test::write_cube(sensed());
  write_png(in("colour.png"), display_image(read_image(in("colour.exr"))));
  const auto picture = [&](const std::string& name, const std::string& options) {
    const test::Outcome outcome =
        run_seamline("composite --background " + in("colour.png") + " --depth " + in("depth-for-it.exr") +
                     " --camera " + in("camera.toml") + " --object " + in("cube.gltf") +
                     " --position 0 -1.5 -3.2 --scale 1.6 --spp 1 --bounces 0 --environment " + options +
                     " --out " + in(name));
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return read_image(in(name));
  };
  // Noise that no repair has touched, in the photograph's pixels.
  ASSERT_EQ(run_seamline("register --depth " + in("depth.exr") + " --colour " + in("colour.png") +
                         " --camera " + in("camera.toml") + " --out " + in("registered-noisy"))
                .status,
            0);
  fs::copy_file(in("registered-noisy/registered.exr"), in("depth-for-it.exr"),
                fs::copy_options::overwrite_existing);
  const Image photograph = read_image(in("colour.png")),
              everywhere = picture("everywhere.png", "9 0 0 --shadows none --occlusion none"),
              occluded = picture("occluded.png", "1 1 1 --shadows none"),
              shaded = picture("shaded.png", "1 1 1");
  int object = 0, specks = 0;
  for (int y = 0; y < photograph.height_px; ++y)
    for (int x = 0; x < photograph.width_px; ++x) {
      // Under red light alone the object has no colour of the grey photograph's.
      const bool covers = (everywhere.rgb(x, y) != photograph.rgb(x, y)).any();
      if (covers) {
        object += (occluded.rgb(x, y) != photograph.rgb(x, y)).any() ? 1 : 0;
      } else {
        ASSERT_TRUE((occluded.rgb(x, y) == photograph.rgb(x, y)).all()) << x << " " << y;
        specks += shaded.rgb(x, y).mean() < 0.5F * photograph.rgb(x, y).mean() ? 1 : 0;
      }
    }
  EXPECT_GT(object, 300);
  EXPECT_GT(specks, 0);  // which is why
}

TEST(Sense, ThePhotographsTrueDepthIsWhatRegisterFindsOfDepthWithoutNoise) {
  const fs::path quiet = test::fresh_folder("sense-truth");
  ASSERT_EQ(run_seamline("sense builtin:bedroom --sensor tof_160x120 --noise 0 --spp 1 --bounces 0 --out " +
                         quiet.string())
                .status,
            0);
  EXPECT_EQ(test::read_text(quiet / "true_registered.exr"),
            test::read_text(sensed() / "true_registered.exr"));
  const auto in = [&](const std::string& name) { return (quiet / name).string(); };
  const test::Outcome registered =
      run_seamline("register --depth " + in("true_depth.exr") + " --colour " + in("colour.exr") +
                   " --camera " + in("camera.toml") + " --extrude 40 --error-tolerance 0.01 --true-depth " +
                   in("true_registered.exr") + " --out " + in("registered"));
  ASSERT_EQ(registered.status, 0) << registered.output;
  // What is wrong is so at outlines, behind things and beyond the view, never where the sensor sees it.
  const std::string table = test::read_text(quiet / "registered" / "errors.csv");
  const auto pixels_of = [&](const std::string& name) {
    const std::size_t at = table.find("\n" + name + ",");
    return std::stol(table.substr(table.find(',', at + name.size() + 2) + 1));
  };
  EXPECT_GT(pixels_of("right"), 640 * 480 * 3 / 4) << table;
  EXPECT_LT(pixels_of("noise"), 30) << table;
  EXPECT_EQ(pixels_of("unmeasured"), 0) << table;
}

TEST(Sense, OptionsThatWouldBeIgnoredAreRefused) {
  const auto refused = [](const std::string& arguments, const char* said) {
    const test::Outcome outcome = run_seamline(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_THAT(outcome.output, testing::HasSubstr(said));
  };
  const std::string composite =
      "composite --background p.png --depth d.exr --object builtin:statue --out o.png ";
  refused(composite + "--occlusion none --occlusion-mask m.png", "--occlusion-mask");
  refused(composite + "--to-sun 0 1 0", "--sun-irradiance");
  refused(composite + "--objects o.toml", "found both");
  refused(composite + "--height 1 --scale 2", "found both");
  refused(composite + "--spp 4 --error 0.01", "found both");
  refused(composite + "--environment 1 1 1 --environment-map m.exr", "--environment");
  refused(composite + "--layers l.png", "--layers: wanted a name ending in .exr");
  refused(composite + "--depth-width 7", "an even width");
  refused(composite + "--camera tof_160x120 --fov 40", "--fov");
  refused(composite + "--camera tof_160x120 --yaw 2", "--yaw");
  refused(composite + "--camera tof_160x120 --jump-ratio 2", "--jumps cut");
  refused(composite + "--camera tof_160x120 --depth-buffer-bits 16", "depth_buffer");
  refused("sense builtin:bedroom --sensor scanner_360 --out o", "a scanner");
  refused("sense builtin:bedroom --sensor tof_160x121 --out o", "did you mean tof_160x120");
}

}  // namespace
}  // namespace seamline
