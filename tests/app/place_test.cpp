// The window of `seamline place`, as a person uses it.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "composites/objects/objects_file.h"
#include "program_window.h"
#include "support/files/image.h"

namespace seamline::test {
namespace {

namespace fs = std::filesystem;

constexpr int photo_width_px = 320, photo_height_px = 180;
constexpr double wall_m = 4, fov_deg = 60;

/// A grey photograph of a wall at 4 m, and one teapot before it.
class Room {
 public:
  Room() : folder_(made()), window_(folder_, command()) {}

  [[nodiscard]] ProgramWindow& window() { return window_; }

  /// Saves, and reads what was saved.
  renderer::PlacedModel saved() {
    window_.xdotool("key s");
    window_.wait_for("saved", ++saves_);
    return renderer::read_objects_file(objects(), {}).objects.at(0);
  }

 private:
  static fs::path made() {
    const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "place";
    fs::create_directories(folder);
    write_exr(folder / "photo.exr", Image(photo_width_px, photo_height_px, 3, 0.4F));
    write_exr(folder / "depth.exr", Image(photo_width_px, photo_height_px, 1, static_cast<float>(wall_m)));
    write_file_atomically(folder / "objects.toml",
                          "[[object]]\nfile = \"builtin:teapot\"\nposition_m = [0, -0.25, -2]\nheight_m = "
                          "0.5\nstands = true\n");
    return folder;
  }
  [[nodiscard]] fs::path objects() const { return folder_ / "objects.toml"; }
  [[nodiscard]] std::string command() const {
    return fmt::format(
        "place --background '{}' --depth '{}' --depth-view photograph --fov {} --environment 1 1 1 --objects "
        "'{}'",
        (folder_ / "photo.exr").string(), (folder_ / "depth.exr").string(), fov_deg, objects().string());
  }

  fs::path folder_;
  ProgramWindow window_;
  std::ptrdiff_t saves_ = 0;
};

TEST(Place, KeysAndMousePutAnObjectOntoTheSurfaceUnderThePointerAndTheFileSaysSo) {
  if (const std::string missing = what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  Room room;
  ProgramWindow& window = room.window();
  window.wait_for("first picture", 1);
  window.xdotool("key Right Right");
  EXPECT_NEAR(room.saved().position_m.x(), 0.04, 1e-9);
  window.xdotool("key ctrl+z ctrl+z shift+Up");
  EXPECT_TRUE(room.saved().position_m.isApprox(Eigen::Vector3d(0, -0.25, -2.2)));
  window.xdotool("key ctrl+z");
  window.xdotool("mousemove 640 360 click 4");
  EXPECT_NEAR(room.saved().rotation_deg.y(), 5, 1e-9);
  // The window is 1280 px wide, and so is the picture in it.
  constexpr double to_x_px = 960, middle_px = 640;
  window.xdotool(
      fmt::format("mousemove 640 360 mousedown 1 mousemove 700 360 mousemove {} 360 mouseup 1", to_x_px));
  const Eigen::Vector3d put = room.saved().position_m;
  const double along =
      (to_x_px + 0.5 - middle_px) / middle_px * std::tan(fov_deg / 2 * std::numbers::pi / 180);
  EXPECT_NEAR(put.x(), along * wall_m, 0.03);
  EXPECT_GT(put.z(), -wall_m + 0.1) << "a wall: half the teapot's width away from it";
  EXPECT_LT(put.z(), -wall_m + 0.8);
  window.xdotool("key ctrl+z");
  EXPECT_TRUE(room.saved().position_m.isApprox(Eigen::Vector3d(0, -0.25, -2)))
      << "a drag is taken back as one";
  EXPECT_EQ(window.end("Escape"), 0);
}

}  // namespace
}  // namespace seamline::test
