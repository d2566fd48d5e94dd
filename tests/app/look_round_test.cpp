// A panorama in the window: the codes on the screen at the poses that were reached, and a person who finds
// the disc behind the start by mouse.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "picture_set.h"
#include "study/exchange/look_records.h"
#include "study/trials/looking.h"
#include "study/trials/trial_picture.h"
#include "window_driver.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;
using test::Line;

constexpr int view_width_px = 320, view_height_px = 180;
constexpr const char* turned_by_mouse = R"(
[scene.camera]
projection = "panorama"
[look]
kind = "mouse"
view_px = [320, 180]
horizontal_fov_deg = 70
start_deg = [10, -5]
[consent]
text = "Discs."
[training]
trials = 0
[[instructions.page]]
text = "Look round."
)";

/// A panorama seen by a pinhole, written without the window's shader: rotation by rotation, then bilinear.
double code_in_view(const ByteImage& panorama, const Pose& pose, double x_px, double y_px, int channel) {
  constexpr double pi = std::numbers::pi, rad = pi / 180;
  const double tangent = std::tan(35 * rad) / (view_width_px / 2.0);
  const Eigen::Vector3d ray((x_px - view_width_px / 2.0) * tangent, (view_height_px / 2.0 - y_px) * tangent,
                            -1);
  const Eigen::Vector3d d = (Eigen::AngleAxisd(-pose.yaw_deg * rad, Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(pose.pitch_deg * rad, Eigen::Vector3d::UnitX()) * ray)
                                .normalized();
  const double u = (std::atan2(d.x(), -d.z()) / (2 * pi) + 0.5) * panorama.width_px - 0.5;
  const double v = (0.5 - std::asin(d.y()) / pi) * panorama.height_px - 0.5;
  const auto code = [&](double column, double row) {
    const int x = (static_cast<int>(column) + panorama.width_px) % panorama.width_px;
    const int y = std::clamp(static_cast<int>(row), 0, panorama.height_px - 1);
    return double{1} * panorama.values[static_cast<std::size_t>((y * panorama.width_px + x) * 3 + channel)];
  };
  const double left = std::floor(u), top = std::floor(v), s = u - left, t = v - top;
  return (1 - t) * ((1 - s) * code(left, top) + s * code(left + 1, top)) +
         t * ((1 - s) * code(left, top + 1) + s * code(left + 1, top + 1));
}

class LookRoundTest : public testing::Test {
 protected:
  fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "look_round";
  std::optional<test::XServer> server;
  std::optional<test::WindowDriver> window;
  RenderedSet set;

  void SetUp() override {
    if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
    fs::remove_all(folder);
    set = test::write_picture_set(folder / "set", {.width_px = 1024,  // wider than the screen
                                                   .height_px = 512,
                                                   .widths = "64",
                                                   .session = "inter_trial_s = 0.05\n",
                                                   .top = "participant_form = false",
                                                   .more = turned_by_mouse});
    server.emplace(folder / "screen", 800, 600);
    test::keep_display_profile(folder / "run" / "config", 800, 600);
    window.emplace(
        *server,
        test::WindowRun{.set = folder / "set", .log = folder / "log.sqlite", .folder = folder / "run"});
    window->wait_screen("consent");
    window->keys("Tab Tab Return");
    for (const char* screen : {"instructions", "ready"}) {
      window->wait_screen(screen);
      window->key("Return");
    }
  }

  [[nodiscard]] double largest_difference(const Line& line) const {
    const ByteImage screen = server->picture();
    std::size_t at = 0;
    while (set.manifest.stimuli[at].id != line["stimulus"]) ++at;
    const ByteImage panorama = load_trial_picture(set, {.stimulus = static_cast<int>(at)});
    const Pose pose{line["pose"][0], line["pose"][1]};
    const int x0 = line["picture"][0], y0 = line["picture"][1];
    double largest = 0;
    for (int y = 0; y < view_height_px; y += 3)
      for (int x = 0; x < view_width_px; x += 3) {
        if (std::abs(x - view_width_px / 2) < 12 && std::abs(y - view_height_px / 2) < 12) continue;  // mark
        for (int c = 0; c < 3; ++c) {
          const auto shown =
              screen.values[static_cast<std::size_t>(((y0 + y) * screen.width_px + x0 + x) * 3 + c)];
          largest = std::max(largest, std::abs(shown - code_in_view(panorama, pose, x + 0.5, y + 0.5, c)));
        }
      }
    return largest;
  }

  /// Soon after the swap, however busy the machine is.
  void expect_view_on_screen(const Line& line) const {
    double largest = largest_difference(line);
    for (int look = 0; look < 200 && largest > 1; ++look) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      largest = largest_difference(line);
    }
    EXPECT_LE(largest, 1) << line["pose"];
  }

  /// Turns by keys until the pose is reached, and waits for it.
  Line press_and_wait(const std::string& key, double yaw_deg, double pitch_deg) {
    window->key(key);
    return window->wait("a turn", [&](const Line& line) {
      return line.contains("pose") && std::abs(line["pose"][0].get<double>() - yaw_deg) < 1e-6 &&
             std::abs(line["pose"][1].get<double>() - pitch_deg) < 1e-6;
    });
  }
};

TEST_F(LookRoundTest, CodesAreThoseOfAnIndependentResamplingAndTheDiscBehindIsFound) {
  Line line = window->wait_trial("trial", 0, "choosing");
  window->move(5, 5);
  EXPECT_EQ(line["pose"], (Line{10.0, -5.0}));
  expect_view_on_screen(line);
  double yaw = 10, pitch = -5;
  for (const char* key : {"shift+Up", "shift+Up", "shift+Up", "shift+Up", "shift+Up", "shift+Up", "Up"}) {
    pitch = std::min(90.0, pitch + (std::string(key) == "Up" ? 3 : 15));
    expect_view_on_screen(press_and_wait(key, yaw, pitch));
  }
  for (int i = 0; i < 9; ++i) {
    pitch -= 15;
    expect_view_on_screen(press_and_wait("shift+Down", yaw, pitch));
    yaw -= 15;
    expect_view_on_screen(press_and_wait("shift+Left", yaw, pitch));
  }
  for (int i = 0; i < 3; ++i) line = press_and_wait("shift+Up", yaw, pitch += 15);
  // The first disc is a quarter to the left, a digit chooses nothing, and a drag is no click.
  window->key("1");
  const double x = line["picture"][0].get<double>() + 160, y = line["picture"][1].get<double>() + 90;
  window->drag(x, y, x - 60, y);
  line = window->wait("a drag", [&](const Line& now) { return now["pose"][0].get<double>() > yaw + 5; });
  EXPECT_EQ(line["phase"], "choosing");
  const double per_px = degrees_per_pixel(*set.study.look);
  EXPECT_NEAR(line["pose"][0].get<double>(), yaw + 60 * per_px, 1e-6);
  window->drag(x - 60, y, x, y);
  window->wait("the drag back", [&](const Line& now) { return now["pose"][0].get<double>() < yaw + 1e-6; });
  expect_view_on_screen(*window->now());
  for (const double wanted : {-90.0})
    for (yaw = (*window->now())["pose"][0]; std::abs(yaw - wanted) > 2;) {
      const bool right = yaw < wanted;
      yaw += right ? 3 : -3;
      line = press_and_wait(right ? "Right" : "Left", yaw, (*window->now())["pose"][1]);
    }
  while (std::abs(line["pose"][1].get<double>()) > 2) {
    const bool down = line["pose"][1].get<double>() > 0;
    line = press_and_wait(down ? "Down" : "Up", yaw, line["pose"][1].get<double>() + (down ? -3 : 3));
  }
  window->click(x, y);
  line = window->wait_trial("trial", 0, "rating");
  write_png(folder / "rating.png", server->picture());
  window->key("2");
  window->wait("the answer's end", [](const Line& now) { return now["answered"].get<int>() == 1; });
  SQLite::Database log((folder / "log.sqlite").string());
  EXPECT_EQ(log.execAndGet("SELECT chosen_index FROM answers").getInt(), 1);
  EXPECT_EQ(log.execAndGet("SELECT image_scale FROM answers").getDouble(), 1);
  const std::string looked =
      log.execAndGet("SELECT group_concat(detail, ';') FROM events WHERE kind = 'look'").getString();
  const auto poses = poses_of(looked);
  ASSERT_TRUE(poses) << looked;
  EXPECT_EQ(poses->front().pose, (Pose{10, -5}));
  EXPECT_NEAR(poses->back().pose.yaw_deg, yaw, 0.051);
  EXPECT_GT(poses->size(), 25U);
  const std::vector<LookedTrial> looks = read_looks(read_log(folder / "log.sqlite"));
  ASSERT_EQ(looks.size(), 1U);
  EXPECT_EQ(looks.front().poses.size(), poses->size());
}

}  // namespace
}  // namespace seamline::study::app
