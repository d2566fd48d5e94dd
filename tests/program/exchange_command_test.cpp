// Exports as people type them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "refusal.h"
#include "run_program.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using test::expect_refused;
using test::fresh_folder;
using test::Outcome;
using test::run_seamline;
using testing::HasSubstr;

/// Six simulated people who answered a small set; the log's path.
std::string answered_log(const std::filesystem::path& folder) {
  (void)test::write_picture_set(folder / "set", {.width_px = 64, .height_px = 48});
  const std::string log = (folder / "log.sqlite").string();
  const Outcome made =
      run_seamline("study " + (folder / "set").string() + " --observer threshold --count 6 --log " + log);
  if (made.status != 0) throw std::runtime_error(made.output);
  return log;
}

TEST(ExchangeCommand, OneLayoutAtATimeAndNothingIsOverwritten) {
  const auto folder = fresh_folder("exchange");
  const std::string log = answered_log(folder);
  const std::string out = (folder / "out").string();
  expect_refused("export tables " + log, "folder");
  expect_refused("export " + log + " --csv " + out + " --bids " + out, "--csv and --bids at a time");
  expect_refused("export web " + log + " " + out + " --anonymise", "--anonymise");
  EXPECT_FALSE(std::filesystem::exists(out));
  for (const std::string layout : {"csv", "psych-ds", "bids"}) {
    const std::string place = out + layout;
    const Outcome written =
        run_seamline("export tables " + log + " " + place + " --anonymise --layout " + layout);
    EXPECT_EQ(written.status, 0) << written.output;
    EXPECT_THAT(written.output, HasSubstr("answers of 6 participants"));
    expect_refused("export tables " + log + " " + place + " --layout " + layout,
                   "wanted a folder that is empty");
  }
}

}  // namespace
}  // namespace seamline
