#pragma once
#include <gtest/gtest.h>

#include <algorithm>

#include "page_commands_run.h"
#include "page_commands_steps.h"

/// The pages as tests: a test a page, or some pages that go on in one folder, in suites that run side by
/// side.
namespace seamline::page_commands {

/// Every page with a command, alone or with those that go on where it ends.
[[nodiscard]] inline std::vector<std::vector<std::string>> pages_to_follow() {
  const std::string tutorials = "documentation/tutorials/";
  std::vector<std::vector<std::string>> all;
  for (const auto& [name, page] : test::pages())
    if (has_commands(page) && !name.starts_with(tutorials)) all.push_back({name});
  all.push_back({tutorials + "first_study.md", tutorials + "lab_session.md", tutorials + "online_study.md"});
  for (const char* name : {"counts_to_threshold.md", "object_in_photograph.md"})
    all.push_back({tutorials + name});
  return all;
}

class FollowedPages : public testing::Test {
 public:
  explicit FollowedPages(std::vector<std::string> pages) : pages_(std::move(pages)) {}
  void TestBody() override { follow_pages(pages_); }

 private:
  std::vector<std::string> pages_;
};

/// Registers all pages in some suites, of which each takes its turn.
inline bool register_pages(int suites) {
  int number = 0;
  for (const std::vector<std::string>& pages : pages_to_follow()) {
    const std::string suite = "CommandsOfPages" + std::to_string(1 + number++ % suites);
    testing::RegisterTest(suite.c_str(), std::filesystem::path(pages.front()).stem().c_str(), nullptr,
                          nullptr, __FILE__, __LINE__,
                          [pages]() -> testing::Test* { return new FollowedPages(pages); });
  }
  return true;
}

}  // namespace seamline::page_commands
