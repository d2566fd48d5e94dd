// What a person reads who does not know the command line: groups, one screen, and what was probably meant.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "commands/options/command_help.h"
#include "commands/program.h"
#include "run_program.h"

namespace seamline {
namespace {

using test::Outcome;
using test::run_seamline;
using testing::HasSubstr;
using testing::Not;

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

TEST(Help, OfTheProgramIsOneScreenOfGroups) {
  const Outcome help = run_seamline("--help");
  EXPECT_EQ(help.status, 0);
  EXPECT_LE(lines_in(help.output), 54U) << help.output;
  EXPECT_LE(longest_line(help.output), 80U) << help.output;
  std::size_t at = 0;
  for (const char* group :
       {"A study:", "Before it:", "Answers:", "Photographs:", "Depth cameras:", "Evidence:"}) {
    const std::size_t found = help.output.find(group);
    ASSERT_NE(found, std::string::npos) << group;
    EXPECT_GT(found, at) << group;
    at = found;
  }
  EXPECT_THAT(help.output, Not(HasSubstr("Subcommands:"))) << "a command that stands in no group";
}

TEST(Help, OfACompositeShowsCommonOptionsOnTwoScreensAndAllWhereAsked) {
  const std::string common = run_seamline("composite --help").output;
  const std::string all = run_seamline("composite --help-all").output;
  EXPECT_LE(lines_in(common), 100U) << common;
  EXPECT_THAT(common, HasSubstr("--background"));
  EXPECT_THAT(common, HasSubstr("Light ("));
  EXPECT_THAT(common, Not(HasSubstr("--keep-sun")));
  EXPECT_THAT(all, HasSubstr("--keep-sun"));
}

TEST(Help, WordsOfShortNamesStandApartAndCountsAreSaidInWords) {
  EXPECT_THAT(run_seamline("predict --help").output, HasSubstr("  set TEXT"));
  const std::string analyze = run_seamline("analyze --help").output;
  EXPECT_THAT(analyze, HasSubstr("  log TEXT REQUIRED"));
  EXPECT_THAT(analyze, HasSubstr("INTEGER:0 to 18446744073709551615=1"));
  EXPECT_THAT(run_seamline("analyze log.sqlite --out a --out b").output,
              HasSubstr("--out: wanted once, found twice"));
  std::string pictures = "flip";
  for (int i = 0; i < 3000; ++i) pictures += " picture_" + std::to_string(i) + ".png";
  const test::Outcome many = test::run_built(pictures);
  EXPECT_EQ(many.status, 1) << "a shell writes out *.png";
}

/// Long names of options that --help or --help-all shows.
TEST(Help, EveryOptionIsShownByHelpAll) {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  for (const auto& [name, command] : every_command(*app)) {
    const std::string shown = command->help("", CLI::AppFormatMode::All);
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_group().empty() || option->get_positional()) continue;
      EXPECT_THAT(shown, HasSubstr("--" + option->get_single_name())) << name;
    }
  }
}

TEST(Help, AWrongWordIsAnsweredWithTheRightOne) {
  EXPECT_THAT(run_seamline("rendr study.toml").output, HasSubstr("no command rendr; did you mean render?"));
  EXPECT_THAT(run_seamline("lab converge").output,
              HasSubstr("no command converge; did you mean convergence?"));
  const Outcome option = run_seamline("render study.toml --spb 4");
  EXPECT_EQ(option.status, 1);
  EXPECT_THAT(option.output, HasSubstr("no option --spb of render; did you mean --spp?"));
  EXPECT_THAT(run_seamline("flip a.png b.png --xyzzyplugh").output,
              HasSubstr("no option --xyzzyplugh of flip (see --help)"));
}

TEST(Help, MovedCommandsWorkByTheirOldSpellingAndSayTheNew) {
  const Outcome old = run_seamline("stability --list");
  EXPECT_EQ(old.status, 0);
  EXPECT_THAT(old.output, HasSubstr("this is now seamline lab stability --list"));
  EXPECT_THAT(run_seamline("lab stability --list").output, Not(HasSubstr("is now")));
}

TEST(Help, BritishAnalyseIsAnalyze) {
  EXPECT_EQ(run_seamline("analyse --help").output, run_seamline("analyze --help").output);
}

}  // namespace
}  // namespace seamline
