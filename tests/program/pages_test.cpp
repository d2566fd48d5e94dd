// What pages say is so: every command line is one that the program takes, every option, file, link, heading,
// built-in scene and test that a page names is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <regex>
#include <set>

#include "commands/options/command_help.h"
#include "commands/program.h"
#include "pages.h"
#include "support/files/assets.h"
#include "support/text/error.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::ManualPage;
using test::pages;

const fs::path& repository() {
  static const fs::path root = SEAMLINE_SOURCE_DIR;
  return root;
}

bool is_command_line(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin != std::string::npos && (line.compare(begin, 9, "seamline ") == 0 ||
                                        line.compare(begin, 23, "build/release/seamline ") == 0);
}

/// The command lines of a page's blocks, whose lines may be joined by a backslash.
std::vector<std::string> command_lines(const ManualPage& page) {
  std::vector<std::string> lines;
  for (const test::PageBlock& block : page.blocks) {
    std::istringstream text(block.text);
    bool goes_on = false;
    for (std::string line; std::getline(text, line);) {
      if (goes_on)
        lines.back() += "\n" + line;
      else if (is_command_line(line))
        lines.push_back(line);
      else
        continue;
      goes_on = line.ends_with('\\');
    }
  }
  return lines;
}

/// What the shell makes of command lines: the arguments of each.
std::vector<std::vector<std::string>> arguments_of(const std::vector<std::string>& lines) {
  const fs::path folder = test::fresh_folder("pages");
  std::string script =
      "set -ef\nseamline() { printf '\\036'; printf '%s\\037' \"$@\"; }\n"
      "build/release/seamline() { seamline \"$@\"; }\nid=bedroom-receiver-statue\n";
  for (const std::string& line : lines) script += line + "\n";
  test::write_text(folder / "lines", script);
  const test::Outcome outcome = test::run_program("bash", (folder / "lines").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  std::vector<std::vector<std::string>> all;
  for (const char letter : outcome.output) {
    if (letter == '\036')
      all.push_back({""});
    else if (all.empty())
      ADD_FAILURE() << outcome.output;
    else if (letter == '\037')
      all.back().emplace_back();
    else
      all.back().back() += letter;
  }
  for (std::vector<std::string>& arguments : all) arguments.pop_back();
  return all;
}

/// Thrown once arguments are taken, before a command begins.
struct Taken {};

/// What the command line says to its arguments; nothing is done. Empty: it takes them.
std::string refusal_of(const std::vector<std::string>& arguments) {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  app->parse_complete_callback([] { throw Taken{}; });
  std::vector<const char*> pointers = {"seamline"};
  for (const std::string& argument : arguments) pointers.push_back(argument.c_str());
  try {
    app->parse(static_cast<int>(pointers.size()), pointers.data());
  } catch (const InputError& error) {
    return error.what();
  } catch (const Taken&) {
    return "";
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "the command began";
}

TEST(Documentation, EveryCommandLineIsOneThatTheProgramTakes) {
  std::size_t lines_read = 0;
  for (const auto& [name, page] : pages()) {
    const std::vector<std::string> lines = command_lines(page);
    if (lines.empty()) continue;
    const std::vector<std::vector<std::string>> all = arguments_of(lines);
    ASSERT_EQ(all.size(), lines.size()) << name;
    for (std::size_t i = 0; i < lines.size(); ++i)
      EXPECT_EQ(refusal_of(all[i]), "") << name << ": " << lines[i];
    lines_read += lines.size();
  }
  EXPECT_GE(lines_read, 100U);
}

/// The options of each command, and of the program itself under "".
const std::map<std::string, std::set<std::string>>& options_of_commands() {
  static const std::map<std::string, std::set<std::string>> options = [] {
    bool failed = false;
    const std::unique_ptr<CLI::App> app = program(failed);
    std::map<std::string, std::set<std::string>> found;
    const auto take = [&](const CLI::App& command, const std::string& name) {
      for (const CLI::Option* option : command.get_options())
        for (const std::string& one : option->get_lnames()) found[name].insert("--" + one);
    };
    take(*app, "");
    for (const auto& [command_name, command] : every_command(*app)) take(*command, command_name);
    return found;
  }();
  return options;
}

TEST(Documentation, EveryOptionIsOneOfItsCommandOrOfSomeCommand) {
  const std::regex option(R"((^|[ \[])(--[a-z0-9][a-z0-9-]*))"),
      first_word(R"(^(?:seamline )?((?:lab )?[a-z]+) )");
  int options_read = 0;
  for (const auto& [name, page] : pages())
    for (const std::string& span : test::code_spans(page)) {
      std::smatch first;
      const bool of_command =
          std::regex_search(span, first, first_word) && options_of_commands().contains(first[1]);
      if (!of_command && !span.starts_with("--")) continue;  // another program's
      for (auto it = std::sregex_iterator(span.begin(), span.end(), option); it != std::sregex_iterator();
           ++it) {
        bool is_there = false;
        for (const auto& [command, options] : options_of_commands())
          is_there = is_there || ((!of_command || command == first[1]) && options.contains((*it)[2]));
        EXPECT_TRUE(is_there) << name << ": `" << span << "`";
        ++options_read;
      }
    }
  EXPECT_GE(options_read, 100);
}

/// Words of a page; bars and rules of tables are none, nor are the marks of what a command writes.
std::size_t words_of_page(const ManualPage& page) {
  const std::string text = std::regex_replace(test::read_text(page.file), std::regex("<!--[^\n]*-->"), "");
  const std::vector<std::string> words = test::words_of(text);
  return static_cast<std::size_t>(std::count_if(words.begin(), words.end(), [](const std::string& word) {
    return std::any_of(word.begin(), word.end(), [](char letter) {
      const auto byte = static_cast<unsigned char>(letter);
      return std::isalnum(byte) != 0 || byte >= 128;
    });
  }));
}

TEST(Documentation, IsShortEnoughToBeRead) {
  // What is looked up (reference) and what developers read is not counted.
  constexpr std::size_t most_words_of_page = 1200, most_words = 40'000;
  const std::regex read_through("documentation/(tutorials|how-to|explanation|evidence|papers)/.*");
  std::size_t words = 0;
  for (const auto& [name, page] : pages()) {
    if (!std::regex_match(name, read_through)) continue;
    EXPECT_LE(words_of_page(page), most_words_of_page) << name;
    words += words_of_page(page);
  }
  EXPECT_LE(words, most_words) << "cut repetition; move history to the changelog, tables to CSV files";
}

/// A heading as its address: letters and figures in small, spaces as hyphens, all else left out.
std::string anchor_of(std::string heading) {
  heading = std::regex_replace(heading, std::regex(R"(\[([^\]]*)\]\([^)]*\))"), "$1");
  std::string anchor;
  for (const char letter : heading) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalnum(byte) != 0 || byte >= 128 || letter == '_' || letter == '-')
      anchor += static_cast<char>(std::tolower(byte));
    else if (letter == ' ')
      anchor += '-';
  }
  return anchor;
}

TEST(Documentation, EveryLinkLeadsToAFileAndToAHeadingOfIt) {
  const std::regex link(R"(\]\(([^)#\s]*)(#([^)\s]*))?\))");
  int links = 0, headings = 0;
  for (const auto& [name, page] : pages())
    for (auto it = std::sregex_iterator(page.prose.begin(), page.prose.end(), link);
         it != std::sregex_iterator(); ++it) {
      const std::string target = (*it)[1], heading = (*it)[3];
      if (target.find("://") != std::string::npos) continue;
      const fs::path file = target.empty() ? page.file : page.file.parent_path() / target;
      EXPECT_TRUE(fs::exists(file)) << name << " links to " << target;
      ++links;
      if (heading.empty() || file.extension() != ".md" || !fs::exists(file)) continue;
      std::vector<std::string> anchors;
      for (const std::string& one : test::read_manual_page(file).headings) anchors.push_back(anchor_of(one));
      EXPECT_THAT(anchors, testing::Contains(heading)) << name << " links to " << it->str();
      ++headings;
    }
  EXPECT_GE(links, 200);
  EXPECT_GE(headings, 20);
  const std::string first = test::read_text(repository() / "documentation/README.md");
  for (const auto& [name, page] : pages())
    if (name.starts_with("documentation/") && name != "documentation/README.md") {
      EXPECT_THAT(first, testing::HasSubstr("(" + name.substr(std::string("documentation/").size())))
          << "not on documentation/README.md";
    }
}

/// A scene, an object, a sky, or the texts of a language.
bool is_builtin(const std::string& name) {
  if (fs::is_regular_file(repository() / "stimuli/texts" / (name + ".toml"))) return true;
  for (const BuiltinKind kind : {BuiltinKind::scene, BuiltinKind::environment}) try {
      (void)resolve_named_file("builtin:" + name, "--scene", kind);
      return true;
    } catch (const InputError&) {
      continue;
    }
  return false;
}

TEST(Documentation, EveryBuiltinSceneObjectAndSkyIsThere) {
  const std::regex builtin("builtin:([a-z_0-9]+)");
  std::set<std::string> names;
  for (const auto& [name, page] : pages()) {
    const std::string text = test::read_text(page.file);
    for (auto it = std::sregex_iterator(text.begin(), text.end(), builtin); it != std::sregex_iterator();
         ++it)
      names.insert((*it)[1]);
  }
  EXPECT_GE(names.size(), 12U);
  for (const std::string& name : names) EXPECT_TRUE(is_builtin(name)) << name;
}

/// Suite.Test of every test that is written down, in C++.
std::set<std::string> every_test() {
  const std::regex test(R"(^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
  std::set<std::string> tests;
  for (const auto& entry : fs::recursive_directory_iterator(repository() / "tests")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    const std::string text = test::read_text(entry.path());
    for (std::size_t at = text.find("TEST"); at != std::string::npos; at = text.find("TEST", at + 1)) {
      std::smatch parts;
      const std::string here = text.substr(at, 300);
      if (std::regex_search(here, parts, test)) tests.insert(parts[1].str() + "." + parts[2].str());
    }
  }
  return tests;
}

TEST(Documentation, EveryTestThatIsNamedIsThere) {
  const std::set<std::string> tests = every_test();
  EXPECT_GE(tests.size(), 1000U);
  // `Suite.*`, `Suite.Test`, `Suite.Beginning...`, or what a filter asks for.
  const std::regex named(R"((?:.*--gtest_filter='?)?([A-Z]\w+)(?:\.(\*|[A-Z]\w+(\.\.\.)?)|\*)'?)");
  int read = 0;
  for (const auto& [name, page] : pages())
    for (const std::string& span : test::code_spans(page)) {
      std::smatch parts;
      if (!std::regex_match(span, parts, named)) continue;
      std::string beginning = parts[1];
      if (parts[2].matched) beginning += ".";
      if (parts[2].matched && parts[2] != "*")
        beginning += parts[2].str().substr(0, parts[2].length() - (parts[3].matched ? 3 : 0));
      const auto at = tests.lower_bound(beginning);
      EXPECT_TRUE(at != tests.end() && at->starts_with(beginning)) << name << ": " << span;
      ++read;
    }
  EXPECT_GE(read, 20);
}

/// Whether a file of the repository fits, where `*` stands for anything but a slash.
bool is_file(const std::string& pattern) {
  if (pattern.find('*') == std::string::npos) return fs::exists(repository() / pattern);
  const fs::path folder = (repository() / pattern).parent_path();
  if (!fs::is_directory(folder)) return false;
  std::string expression;
  for (const char letter : fs::path(pattern).filename().string())
    expression += letter == '*'   ? std::string("[^/]*")
                  : letter == '.' ? std::string("\\.")
                                  : std::string(1, letter);
  const std::regex wanted(expression);
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(), [&](const auto& entry) {
    return std::regex_match(entry.path().filename().string(), wanted);
  });
}

TEST(Documentation, EveryFileOfTheRepositoryThatIsNamedIsThere) {
  std::set<std::string> folders;
  for (const auto& entry : fs::directory_iterator(repository()))
    if (entry.is_directory() && entry.path().filename() != "build")
      folders.insert(entry.path().filename().string());
  const std::regex path(R"([\w.*-]+(/[\w.*-]+)+/?)");
  int read = 0;
  for (const auto& [name, page] : pages()) {
    std::vector<std::string> words = test::code_spans(page);
    for (const test::PageBlock& block : page.blocks) {
      std::istringstream text(block.text);
      for (std::string word; text >> word;) words.push_back(word);
    }
    for (const std::string& span : words) {
      std::istringstream text(span);
      for (std::string word; text >> word;) {
        while (!word.empty() && std::string(",;:").find(word.back()) != std::string::npos) word.pop_back();
        if (!std::regex_match(word, path) || !folders.contains(word.substr(0, word.find('/')))) continue;
        EXPECT_TRUE(is_file(word)) << name << ": " << word;
        ++read;
      }
    }
  }
  EXPECT_GE(read, 50);
}

/// Every picture of the manual: it is shown on a page, and a command of documentation/pictures/README.md
/// makes it.
TEST(Documentation, EveryPictureHasACommandAndAPage) {
  const fs::path folder = repository() / "documentation/pictures";
  std::string shown;
  for (const auto& [name, page] : pages()) shown += page.prose;
  std::map<std::string, std::string> commands;
  const std::regex row(R"(\| `([^`]+)` \| `([^`]+)` \|)");
  const std::string list = test::read_text(folder / "README.md");
  for (auto it = std::sregex_iterator(list.begin(), list.end(), row); it != std::sregex_iterator(); ++it)
    EXPECT_TRUE(commands.emplace((*it)[1], (*it)[2]).second) << it->str() << " stands there twice";
  std::size_t pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const fs::path file = entry.path();
    if (file.extension() != ".png" && file.extension() != ".svg") continue;
    ++pictures;
    EXPECT_THAT(shown, testing::HasSubstr("pictures/" + file.filename().string())) << "on no page";
    const std::string command = commands[file.filename().string()];
    ASSERT_NE(command, "") << file.filename() << " has no command";
    const std::string script = command.substr(0, command.find(' '));
    const fs::path program = script.find('/') == std::string::npos ? folder / script : repository() / script;
    ASSERT_TRUE(fs::is_regular_file(program)) << command;
    EXPECT_NE(fs::status(program).permissions() & fs::perms::owner_exec, fs::perms::none) << program;
    // A script that takes names lists this one.
    if (command.find(' ') != std::string::npos && script.find('/') == std::string::npos) {
      EXPECT_THAT(" " + test::read_text(program) + " ", testing::HasSubstr(" " + file.stem().string() + " "));
    }
  }
  EXPECT_EQ(commands.size(), pictures) << "a picture of the list is not there";
}

}  // namespace
}  // namespace seamline
