// Exports as people type them, and read by other people's programs where those are there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "refusal.h"
#include "run_program.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using test::expect_refused;
using test::fresh_folder;
using test::Outcome;
using test::run_program;
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
  expect_refused("export " + log, "found nothing to write");
  expect_refused("export " + log + " --csv " + out + " --bids " + out, "found --csv and --bids");
  expect_refused("export " + log + " --web " + out + " --anonymise", "--anonymise: wanted a log's tables");
  EXPECT_FALSE(std::filesystem::exists(out));
  for (const std::string layout : {"--csv", "--psych-ds", "--bids"}) {
    const std::string place = out + layout;
    const Outcome written = run_seamline("export " + log + " " + layout + " " + place + " --anonymise");
    EXPECT_EQ(written.status, 0) << written.output;
    EXPECT_THAT(written.output, HasSubstr("answers of 6 participants"));
    expect_refused("export " + log + " " + layout + " " + place, "wanted a folder that is empty");
  }
}

/// `bids-validator` of npm: the program that SEAMLINE_BIDS_VALIDATOR names, else one on the path.
std::string bids_validator() {
  const char* named = std::getenv("SEAMLINE_BIDS_VALIDATOR");
  return named != nullptr ? named : "bids-validator";
}

TEST(ExchangeCommand, TheValidatorOfBidsFindsNoError) {
  if (run_program(bids_validator(), "--version").status != 0)
    GTEST_SKIP() << "bids-validator 1.15 of npm is neither on the path nor named by SEAMLINE_BIDS_VALIDATOR";
  const auto folder = fresh_folder("exchange-bids");
  const std::string log = answered_log(folder);
  for (const std::string how : {"", " --anonymise"}) {
    const std::string out = (folder / (how.empty() ? "bids" : "anonymous")).string();
    ASSERT_EQ(run_seamline("export " + log + " --bids '" + out + "'" + how).status, 0);
    const Outcome judged = run_program(bids_validator(), "'" + out + "'");
    EXPECT_EQ(judged.status, 0) << judged.output;
    EXPECT_THAT(judged.output, testing::AllOf(HasSubstr("6 - Subjects"), testing::Not(HasSubstr("[ERR]"))));
  }
}

}  // namespace
}  // namespace seamline
