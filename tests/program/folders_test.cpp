// Folders look in one direction: the table of the design, kept by reading every include.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace seamline {
namespace {

namespace fs = std::filesystem;

/// Which folders a folder may include, besides itself.
const std::map<std::string, std::set<std::string>> allowed = {
    {"stimuli/support", {}},
    {"stimuli", {"stimuli/support"}},
    {"scenes", {"stimuli/support"}},
    {"renderer", {"stimuli", "stimuli/support"}},
    {"study", {"stimuli", "stimuli/support"}},
    {"study/app", {"study", "stimuli", "stimuli/support"}},
    {"analysis/statistics", {"stimuli/support"}},
    {"analysis/psychometric", {"analysis/statistics", "study", "stimuli", "stimuli/support"}},
    {"analysis/ordinal", {"analysis/statistics", "study", "stimuli", "stimuli/support"}},
    {"analysis",
     {"analysis/statistics", "analysis/psychometric", "analysis/ordinal", "study", "stimuli",
      "stimuli/support"}},
    {"analysis/report",
     {"analysis", "analysis/psychometric", "analysis/ordinal", "study", "stimuli", "stimuli/support"}},
    {"analysis/commands",
     {"analysis/report", "analysis", "analysis/psychometric", "study", "stimuli", "stimuli/support"}},
    {"stability",
     {"analysis", "analysis/psychometric", "analysis/ordinal", "renderer", "study", "stimuli",
      "stimuli/support"}}};

std::string folder_of(const std::string& include) {
  const std::size_t slash = include.rfind('/');
  return slash == std::string::npos ? "" : include.substr(0, slash);
}

TEST(Folders, LookInOneDirection) {
  const fs::path root = SEAMLINE_SOURCE_DIR;
  const std::regex include_line("^\\s*#include \"([^\"]+)\"");
  int includes = 0;
  for (const auto& [folder, may_look_at] : allowed) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include_line)) continue;
        ++includes;
        const std::string target = folder_of(match[1]);
        EXPECT_TRUE(target == folder || may_look_at.contains(target))
            << entry.path() << " includes " << match[1];
      }
    }
  }
  EXPECT_GT(includes, 100);
}

TEST(Folders, NoGeneratorOrShuffleOfTheStandardLibraryIsUsed) {
  const fs::path root = SEAMLINE_SOURCE_DIR;
  const std::regex forbidden(
      "std::shuffle\\(|std::(uniform|normal|bernoulli|binomial|poisson|discrete)[a-z_]*_distribution|std::"
      "mt19937|std::random_device");
  for (const auto& [folder, ignored] : allowed) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);)
        EXPECT_FALSE(std::regex_search(line, forbidden)) << entry.path() << ": " << line;
    }
  }
}

}  // namespace
}  // namespace seamline
