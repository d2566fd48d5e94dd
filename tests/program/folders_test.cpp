// Folders look in one direction, and every one of them is on its page: documentation/developers/folders.md,
// kept by reading every include.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace seamline {
namespace {

namespace fs = std::filesystem;

constexpr int most_files_of_a_kind = 16;

struct Page {
  std::map<std::string, std::set<std::string>> looks_at;  ///< of top folders
  std::vector<std::string> rooms;                         ///< lowest first
};

Page read_page() {
  Page page;
  std::ifstream in(fs::path(SEAMLINE_SOURCE_DIR) / "documentation/developers/folders.md");
  const std::regex top(R"(^\| `([a-z0-9_]+)/` \|.*\|(.*)\|$)"), room(R"(^\| `([a-z0-9_/]+[a-z0-9_])` \|)"),
      name(R"(`([a-z0-9_]+)/`)");
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_search(line, match, top)) {
      const std::string seen = match[2];
      auto& targets = page.looks_at[match[1]];
      for (auto it = std::sregex_iterator(seen.begin(), seen.end(), name); it != std::sregex_iterator(); ++it)
        targets.insert((*it)[1]);
    } else if (std::regex_search(line, match, room)) {
      page.rooms.push_back(match[1]);
    }
  }
  return page;
}

bool is_source(const fs::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".h";
}

std::string top_of(const std::string& folder) {
  return folder.substr(0, folder.find('/'));
}

/// Sources of the product by folder, relative to the root; those of the root itself are left out.
std::map<std::string, std::vector<fs::path>> sources(const Page& page) {
  const fs::path root = SEAMLINE_SOURCE_DIR;
  std::map<std::string, std::vector<fs::path>> found;
  for (const auto& [top, ignored] : page.looks_at)
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
      if (is_source(entry.path()))
        found[fs::relative(entry.path().parent_path(), root).generic_string()].push_back(entry.path());
  return found;
}

TEST(Folders, EveryOneIsOnThePageAndNoneIsCrowded) {
  const Page page = read_page();
  ASSERT_GE(page.rooms.size(), 40U);
  const auto folders = sources(page);
  for (const auto& [folder, files] : folders) {
    EXPECT_EQ(std::count(page.rooms.begin(), page.rooms.end(), folder), 1) << folder;
    for (const char* kind : {".h", ".cpp"})
      EXPECT_LE(
          std::count_if(files.begin(), files.end(), [&](const fs::path& f) { return f.extension() == kind; }),
          most_files_of_a_kind)
          << folder << " " << kind;
  }
  for (const std::string& room : page.rooms)
    EXPECT_TRUE(folders.contains(room)) << room << " is on the page only";
  // A folder of sources at the top that the page does not name.
  const std::set<std::string> others = {"tests", "fuzz", "benchmarks"};
  for (const auto& entry : fs::directory_iterator(SEAMLINE_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || name.starts_with(".") || name.starts_with("build") || name == "out" ||
        others.contains(name))
      continue;
    const auto files = fs::recursive_directory_iterator(entry.path());
    const bool has_sources = std::any_of(fs::begin(files), fs::end(files),
                                         [](const auto& file) { return is_source(file.path()); });
    EXPECT_TRUE(!has_sources || page.looks_at.contains(name)) << name;
  }
}

TEST(Folders, LookInOneDirection) {
  const Page page = read_page();
  std::map<std::string, std::size_t> rank;
  for (std::size_t i = 0; i < page.rooms.size(); ++i) rank[page.rooms[i]] = i;
  const std::regex include_line("^\\s*#include \"([^\"]+)\"");
  int includes = 0;
  for (const auto& [folder, files] : sources(page))
    for (const fs::path& file : files) {
      std::ifstream in(file);
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (!std::regex_search(line, match, include_line)) continue;
        ++includes;
        const std::string target = fs::path(match[1].str()).parent_path().generic_string();
        ASSERT_TRUE(rank.contains(target)) << file << " includes " << match[1];
        if (target == folder) continue;
        EXPECT_LT(rank[target], rank[folder]) << file << " includes " << match[1];
        EXPECT_TRUE(top_of(target) == top_of(folder) ||
                    page.looks_at.at(top_of(folder)).contains(top_of(target)))
            << file << " includes " << match[1];
        EXPECT_TRUE(!target.starts_with("study/app") || folder.starts_with("study/app") ||
                    folder == "commands")
            << file << " includes " << match[1];
        // Builds without a screen have no window.
        EXPECT_TRUE(target != "window" || top_of(folder) != "study" || folder.starts_with("study/app") ||
                    folder == "commands")
            << file << " includes " << match[1];
        EXPECT_TRUE(target != "window" || top_of(folder) != "live" || folder == "live/window")
            << file << " includes " << match[1];
      }
    }
  EXPECT_GT(includes, 1000);
}

TEST(Folders, NoGeneratorOrShuffleOfTheStandardLibraryIsUsed) {
  const std::regex forbidden(
      "std::shuffle\\(|std::(uniform|normal|bernoulli|binomial|poisson|discrete)[a-z_]*_distribution|std::"
      "mt19937|std::random_device");
  for (const auto& [folder, files] : sources(read_page()))
    for (const fs::path& file : files) {
      std::ifstream in(file);
      for (std::string line; std::getline(in, line);)
        EXPECT_FALSE(std::regex_search(line, forbidden)) << file << ": " << line;
    }
}

}  // namespace
}  // namespace seamline
