// A session of a thousand trials: memory stays flat. Prints how long frames took, and how soon a picture was
// on the screen after its turn had come; those are numbers to read, not to assert. A few minutes.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "picture_set.h"
#include "scripted_window.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;
using test::Line;

double resident_mb(pid_t process) {
  std::ifstream status(fmt::format("/proc/{}/status", process));
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
  return 0;
}

/// A column of a CSV file, without empty cells; rows whose screen begins with `screen`.
std::vector<double> column(const fs::path& csv, std::size_t index, const std::string& screen) {
  std::vector<double> values;
  std::ifstream in(csv);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() > index && !cells[index].empty() && cells[1].starts_with(screen))
      values.push_back(std::stod(cells[index]));
  }
  std::sort(values.begin(), values.end());
  return values;
}

void print_times(const char* what, const std::vector<double>& sorted_ns) {
  if (sorted_ns.empty()) return;
  const auto at = [&](double share) {
    return sorted_ns[static_cast<std::size_t>(share * static_cast<double>(sorted_ns.size() - 1))] * 1e-6;
  };
  std::printf("%s: %zu, median %.2f ms, 99th percentile %.2f ms, longest %.2f ms\n", what, sorted_ns.size(),
              at(0.5), at(0.99), at(1));
}

TEST(WindowLong, MemoryStaysFlatOverAThousandTrials) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "long";
  fs::remove_all(folder);
  std::string widths;
  for (int i = 1; i <= 334; ++i) widths += fmt::format("{}{}", i == 1 ? "" : ", ", 2 * i);
  (void)test::write_picture_set(folder / "set",
                                {.width_px = 960,
                                 .height_px = 540,
                                 .widths = widths,
                                 .different = 20,
                                 .session = "break_every_trials = 500\ninter_trial_s = 0.05\n",
                                 .top = "participant_form = false",
                                 .more = "[consent]\ntext = \"Discs.\"\n"});
  const test::XServer server(folder / "screen", 1280, 800);
  test::keep_display_profile(folder / "run" / "config", 1280, 800);
  test::WindowDriver window(server, {.set = folder / "set",
                                     .log = folder / "log.sqlite",
                                     .options = "--frame-times '" + (folder / "frames.csv").string() + "'",
                                     .folder = folder / "run"});
  double after_50_mb = 0, after_1000_mb = 0;
  test::drive(window, 1, [&](const Line& line) {
    const int answered = line["answered"];
    if (answered >= 50 && after_50_mb == 0) after_50_mb = resident_mb(window.process());
    if (answered >= 1000 && after_1000_mb == 0) after_1000_mb = resident_mb(window.process());
    return false;
  });
  EXPECT_EQ(window.wait_end(), 0) << window.output();
  std::printf("resident memory after 50 trials %.1f MB, after 1000 %.1f MB\n", after_50_mb, after_1000_mb);
  print_times("frames of trials", column(folder / "frames.csv", 3, "trial/"));
  print_times("pictures, from their turn to the end of the swap that showed them",
              column(folder / "frames.csv", 5, "trial/"));
  EXPECT_GT(after_50_mb, 0);
  EXPECT_NEAR(after_1000_mb, after_50_mb, 0.05 * after_50_mb);
}

}  // namespace
}  // namespace seamline::study::app
