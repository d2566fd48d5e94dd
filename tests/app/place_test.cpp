// The window of `seamline place`, as a person uses it.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <regex>
#include <thread>

#include "renderer/composite/objects_file.h"
#include "support/files/image.h"
#include "x_server.h"

namespace seamline::test {
namespace {

namespace fs = std::filesystem;

constexpr int photo_width_px = 320, photo_height_px = 180;
constexpr double wall_m = 4, fov_deg = 60;

/// A grey photograph of a wall at 4 m, and one teapot before it.
class Room {
 public:
  Room() : folder_(fs::path(SEAMLINE_TEST_OUTPUT) / "place"), server_(folder_ / "x", 1280, 800) {
    write_exr(folder_ / "photo.exr", Image(photo_width_px, photo_height_px, 3, 0.4F));
    write_exr(folder_ / "depth.exr", Image(photo_width_px, photo_height_px, 1, static_cast<float>(wall_m)));
    write_file_atomically(objects(),
                          "[[object]]\nfile = \"builtin:teapot\"\nposition_m = [0, -0.25, -2]\nheight_m = "
                          "0.5\nstands = true\n");
    fs::remove(folder_ / "output");
    const std::string command = fmt::format(
        "exec env -u WAYLAND_DISPLAY DISPLAY={} LIBGL_ALWAYS_SOFTWARE=1 '{}' place --background '{}' --depth "
        "'{}' "
        "--depth-view photograph --fov {} --environment 1 1 1 --objects '{}' >'{}' 2>&1 </dev/null",
        server_.display(), SEAMLINE_PROGRAM, (folder_ / "photo.exr").string(),
        (folder_ / "depth.exr").string(), fov_deg, objects().string(), (folder_ / "output").string());
    child_ = ::fork();
    if (child_ == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
      ::_exit(127);
    }
  }
  ~Room() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
  }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;

  [[nodiscard]] fs::path objects() const { return folder_ / "objects.toml"; }
  [[nodiscard]] std::string said() const {
    return fs::exists(folder_ / "output") ? read_file(folder_ / "output") : "";
  }

  /// Waits until the program has said something so often.
  void wait_for(const std::string& words, std::ptrdiff_t times) const {
    for (int look = 0; look < 6000; ++look) {
      const std::string text = said();
      const std::regex wanted(words);
      if (std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), std::sregex_iterator()) >=
          times)
        return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("waited for \"" + words + "\": " + said());
  }
  void xdotool(const std::string& arguments) const {
    const std::string command = "DISPLAY=" + server_.display() + " xdotool " + arguments + " >/dev/null 2>&1";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("xdotool " + arguments);
  }
  /// Saves, and reads what was saved.
  renderer::PlacedModel saved() {
    xdotool("key s");
    wait_for("saved", ++saves_);
    return renderer::read_objects_file(objects(), {}).objects.at(0);
  }
  int end() {
    xdotool("key Escape");
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  fs::path folder_;
  XServer server_;
  pid_t child_ = -1;
  std::ptrdiff_t saves_ = 0;
};

TEST(Place, KeysAndMousePutAnObjectOntoTheSurfaceUnderThePointerAndTheFileSaysSo) {
  if (const std::string missing = what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  Room room;
  room.wait_for("first picture", 1);
  room.xdotool("key Right Right");
  EXPECT_NEAR(room.saved().position_m.x(), 0.04, 1e-9);
  room.xdotool("key ctrl+z ctrl+z shift+Up");
  EXPECT_TRUE(room.saved().position_m.isApprox(Eigen::Vector3d(0, -0.25, -2.2)));
  room.xdotool("key ctrl+z");
  room.xdotool("mousemove 640 360 click 4");
  EXPECT_NEAR(room.saved().rotation_deg.y(), 5, 1e-9);
  // The window is 1280 px wide, and so is the picture in it.
  constexpr double to_x_px = 960, middle_px = 640;
  room.xdotool(
      fmt::format("mousemove 640 360 mousedown 1 mousemove 700 360 mousemove {} 360 mouseup 1", to_x_px));
  const Eigen::Vector3d put = room.saved().position_m;
  const double along =
      (to_x_px + 0.5 - middle_px) / middle_px * std::tan(fov_deg / 2 * std::numbers::pi / 180);
  EXPECT_NEAR(put.x(), along * wall_m, 0.03);
  EXPECT_GT(put.z(), -wall_m + 0.1) << "a wall: half the teapot's width away from it";
  EXPECT_LT(put.z(), -wall_m + 0.8);
  room.xdotool("key ctrl+z");
  EXPECT_TRUE(room.saved().position_m.isApprox(Eigen::Vector3d(0, -0.25, -2)))
      << "a drag is taken back as one";
  EXPECT_EQ(room.end(), 0);
}

}  // namespace
}  // namespace seamline::test
