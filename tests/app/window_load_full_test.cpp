// How long a participant waits for the first picture of a large set; beside a set of the paper's size.
#include <gtest/gtest.h>

#include "picture_set.h"
#include "scripted_window.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Three stimuli for each width.
std::string widths(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + std::to_string(64 + 2 * i);
  return text;
}

TEST(WindowLoad, ALargeSetComesToItsFirstTrial) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "load";
  fs::remove_all(folder);
  const test::XServer server(folder / "screen", 800, 600);
  std::printf("%8s %16s %16s\n", "stimuli", "first screen, s", "first trial, s");
  for (const int count : {28, 1667}) {
    const fs::path here = folder / std::to_string(3 * count);
    (void)test::write_picture_set(
        here / "set", {.widths = widths(count), .different = 16, .top = "participant_form = false"});
    test::keep_display_profile(here / "run" / "config", 800, 600);
    const Clock::time_point start = Clock::now();
    test::WindowDriver window(
        server,
        {.set = here / "set", .log = here / "log.sqlite", .options = "--pilot", .folder = here / "run"});
    (void)window.wait("a screen", [](const test::Line&) { return true; });
    const double first_screen_s = seconds_since(start);
    test::drive(window, 1, [](const test::Line& line) {
      return line["screen"] == "trial" && line["phase"] == "choosing";
    });
    std::printf("%8d %16.2f %16.2f\n", 3 * count, first_screen_s, seconds_since(start));
    EXPECT_EQ((*window.now())["trial"], 0);
  }
}

}  // namespace
}  // namespace seamline::study::app
