// Every command line of every page, as it stands there, to its end (page_commands_run.h); and that none is
// left out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "page_commands_suites.h"

namespace seamline::page_commands {
namespace {

[[maybe_unused]] const bool pages_are_registered = register_pages(8);

/// Pages and their steps of a kind.
std::vector<std::pair<std::string, std::string>> lines_of_pages(PageStep::Kind kind) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const auto& [name, page] : test::pages())
    for (const PageStep& step : steps_of(page))
      if (step.kind == kind) lines.emplace_back(name, step.text);
  return lines;
}

TEST(CommandsOnPages, AreRunOrListedWithAReason) {
  const auto lines = lines_of_pages(PageStep::Kind::command);
  EXPECT_GE(lines.size(), 200U);
  EXPECT_LE(not_run().size(), 10U);
  for (const NotRun& one : not_run()) {
    EXPECT_NE(one.why, "");
    EXPECT_TRUE(std::any_of(
        lines.begin(), lines.end(),
        [&](const auto& line) { return line.first == one.page && line.second.starts_with(one.begins); }))
        << one.page << " has no " << one.begins;
  }
  // No block of whatever kind hides one.
  std::size_t in_blocks = 0;
  for (const auto& [name, page] : test::pages())
    for (const test::PageBlock& block : page.blocks) {
      std::istringstream text(block.text);
      for (std::string line; std::getline(text, line);)
        in_blocks += is_own(line.substr(std::min(line.find_first_not_of(' '), line.size()))) ? 1 : 0;
    }
  EXPECT_EQ(lines.size(), in_blocks);
  // Each page with a command is followed once.
  std::multiset<std::string> followed;
  for (const std::vector<std::string>& pages : pages_to_follow()) followed.insert(pages.begin(), pages.end());
  for (const auto& [page, line] : lines) EXPECT_EQ(followed.count(page), 1U) << page;
}

TEST(CommandsOnPages, OfOtherProgramsAreListed) {
  const auto lines = lines_of_pages(PageStep::Kind::other_program);
  for (const auto& [page, line] : lines)
    EXPECT_TRUE(std::any_of(other_programs.begin(), other_programs.end(),
                            [&](const OtherProgram& other) { return line.starts_with(other.begins); }))
        << page << ": " << line;
  for (const OtherProgram& other : other_programs)
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                            [&](const auto& line) { return line.second.starts_with(other.begins); }))
        << "on no page: " << other.begins;
}

TEST(CommandsOnPages, EveryReplacementMakesSomeCommandSmaller) {
  const auto lines = lines_of_pages(PageStep::Kind::command);
  for (const std::string& pattern : replaced_patterns())
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const auto& line) {
      return std::regex_search(line.second, std::regex(pattern));
    })) << pattern;
}

/// What is made smaller is made no smaller a second time, and keeps its hash.
TEST(CommandsOnPages, SmallerStudiesStayAsTheyAre) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::studies())) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text = test::read_text(entry.path());
    for (const bool every_stimulus : {false, true}) {
      const std::string small = smaller_study(text, every_stimulus);
      EXPECT_NE(small, text) << entry.path();
      EXPECT_EQ(smaller_study(small, every_stimulus), small) << entry.path();
    }
    ++read;
  }
  EXPECT_GE(read, 25);
}

}  // namespace
}  // namespace seamline::page_commands
