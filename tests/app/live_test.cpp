// The window of `seamline live`, as a person uses it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "physics/rigid_world.h"
#include "program_window.h"
#include "support/files/image.h"

namespace seamline::test {
namespace {

namespace fs = std::filesystem;

/// A floor that a small sensor sees.
fs::path recorded(const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string command = fmt::format(
      "'{}' record builtin:bedroom --preset tof_160x120 --path still --frames 3 --spp 1 --bounces 0 --noise "
      "0.1 --at 0.4 1.5 -1.5 --look-at 0.1 0.5 -4.2 --out '{}' >/dev/null 2>&1",
      SEAMLINE_PROGRAM, (folder / "recording").string());
  if (std::system(command.c_str()) != 0) throw std::runtime_error(command);
  return folder / "recording";
}

using Row = std::map<std::string, std::string>;  ///< by column

std::vector<Row> rows_of(const fs::path& csv) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
    return all;
  };
  std::istringstream in(read_file(csv));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = cells(line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    Row row;
    const std::vector<std::string> values = cells(line);
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i) row[names[i]] = values[i];
    rows.push_back(row);
  }
  return rows;
}

TEST(LiveWindow, DropsThingsAgainAndStopsTheirFallAtAKeyAndTheTableSaysSo) {
  if (const std::string missing = what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  if (!renderer::has_physics()) GTEST_SKIP() << "built without Bullet";
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "live-window";
  const fs::path recording = recorded(folder);
  ProgramWindow window(
      folder, fmt::format("live '{}' --object builtin:teapot --at 0.2 0 -4 --height 0.2 --size 400x300 "
                          "--physics --drop 0.5 --csv '{}'",
                          recording.string(), (folder / "times.csv").string()));
  window.wait_for_changes(30);  // it has fallen
  write_png(folder / "fallen.png", window.picture());
  window.xdotool("key p");
  window.wait_for_changes(8);
  write_png(folder / "stopped.png", window.picture());
  window.xdotool("key d");
  window.wait_for_changes(8);
  write_png(folder / "let_go.png", window.picture());
  window.xdotool("key p");
  window.wait_for_changes(30);
  window.xdotool("key d");
  window.wait_for_changes(4);
  write_png(folder / "falls_again.png", window.picture());
  ASSERT_EQ(window.end("q"), 0) << window.said();

  const std::vector<Row> rows = rows_of(folder / "times_poses.csv");
  ASSERT_GT(rows.size(), 40U);
  const auto number = [&](std::size_t row, const char* column) { return std::stod(rows[row].at(column)); };
  const double first_y_m = number(0, "y_m");
  const double first_let_go = number(0, "let_go");
  std::size_t stood = 0, let_go_while_stopped = 0, let_go_while_on = 0;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const bool stopped = rows[row].at("simulated_s") == rows[row - 1].at("simulated_s");
    const bool dropped = number(row, "let_go") > number(row - 1, "let_go");
    if (dropped) ++(stopped ? let_go_while_stopped : let_go_while_on);
    if (dropped && stopped) {
      EXPECT_EQ(number(row, "y_m"), first_y_m) << "where it was let go first, and stays there";
    }
    if (!stopped || dropped) continue;
    ++stood;
    for (const char* column : {"x_m", "y_m", "z_m", "pitch_deg", "yaw_deg", "roll_deg"})
      EXPECT_EQ(rows[row].at(column), rows[row - 1].at(column)) << "stopped, row " << row;
  }
  EXPECT_GT(stood, 8U);
  EXPECT_EQ(let_go_while_stopped, 1U);
  EXPECT_EQ(let_go_while_on, 1U);
  EXPECT_EQ(number(rows.size() - 1, "let_go"), first_let_go + 2);
  const auto y_m_of = [&](double let_go) {
    double least_m = 1e9;
    for (std::size_t row = 0; row < rows.size(); ++row)
      if (number(row, "let_go") == let_go) least_m = std::min(least_m, number(row, "y_m"));
    return least_m;
  };
  EXPECT_LT(y_m_of(first_let_go), first_y_m - 0.4);
  EXPECT_NEAR(y_m_of(first_let_go + 1), y_m_of(first_let_go), 0.03) << "it falls again when physics goes on";
}

}  // namespace
}  // namespace seamline::test
