#pragma once
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "run_program.h"

/// The pages that people read, taken apart.
namespace seamline::test {

struct PageBlock {
  std::string kind;  ///< what stands behind the fence: "sh", "toml", "sh by hand", nothing
  std::string text;
};

struct ManualPage {
  std::filesystem::path file;
  std::string prose;                  ///< what is outside of blocks
  std::vector<PageBlock> blocks;      ///< fenced ones
  std::vector<std::string> headings;  ///< without their marks
};

inline ManualPage read_manual_page(const std::filesystem::path& file) {
  ManualPage page{.file = file, .prose = {}, .blocks = {}, .headings = {}};
  std::ifstream in(file);
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) {
      if (!inside) page.blocks.push_back({.kind = line.substr(3), .text = {}});
      inside = !inside;
    } else if (inside) {
      page.blocks.back().text += line + "\n";
    } else {
      page.prose += line + "\n";
      if (line.starts_with("#")) page.headings.push_back(line.substr(line.find_first_not_of("# ")));
    }
  }
  if (inside) throw std::runtime_error(file.string() + " ends in a block");
  return page;
}

/// Every page of the repository for people: documentation/ and its folders by kind of page, README and
/// CONTRIBUTING, by path from its root. What lies deeper is data of a page.
inline const std::map<std::string, ManualPage>& pages() {
  static const std::map<std::string, ManualPage> read = [] {
    const std::filesystem::path root = SEAMLINE_SOURCE_DIR;
    std::map<std::string, ManualPage> found;
    for (const char* name : {"README.md", "CONTRIBUTING.md", "tests/data/README.md"})
      found[name] = read_manual_page(root / name);
    const auto read_folder = [&](const std::filesystem::path& folder) {
      for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".md")
          found[entry.path().lexically_relative(root).generic_string()] = read_manual_page(entry.path());
    };
    read_folder(root / "documentation");
    for (const auto& entry : std::filesystem::directory_iterator(root / "documentation"))
      if (entry.is_directory()) read_folder(entry.path());
    return found;
  }();
  return read;
}

/// The pieces of text in backticks, outside of blocks.
inline std::vector<std::string> code_spans(const ManualPage& page) {
  std::vector<std::string> spans;
  const std::string& text = page.prose;
  for (std::size_t open = text.find('`'); open != std::string::npos;) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string::npos) break;
    spans.push_back(text.substr(open + 1, close - open - 1));
    open = text.find('`', close + 1);
  }
  return spans;
}

}  // namespace seamline::test
