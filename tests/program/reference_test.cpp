// The pages of documentation/reference are those of this program: every command and option, every key that a
// study file may have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <regex>
#include <set>

#include "commands/manual/command_line.h"
#include "commands/program.h"
#include "pages.h"
#include "stimuli/definition/artifact.h"
#include "stimuli/definition/interface_texts.h"
#include "stimuli/definition/quantity.h"
#include "stimuli/settings/whole/settings_page.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

const fs::path& source_folder() {
  static const fs::path root = SEAMLINE_SOURCE_DIR;
  return root;
}

TEST(Reference, CommandsAreThoseOfTheProgram) {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  EXPECT_EQ(test::read_text(source_folder() / "documentation/reference/commands.md"),
            packaging::reference_page(packaging::command_line(*app)))
      << "copy manual/commands.md of the build folder";
}

void add_matches(const std::string& text, const std::regex& expression, std::set<std::string>& keys) {
  for (auto it = std::sregex_iterator(text.begin(), text.end(), expression); it != std::sregex_iterator();
       ++it)
    if (!(*it)[1].str().ends_with('_')) keys.insert((*it)[1]);
}

/// Keys of the rows of settings.
std::set<std::string> keys_of_rows() {
  std::set<std::string> keys;
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() / "stimuli/settings"))
    if (entry.is_regular_file())
      add_matches(test::read_text(entry.path()), std::regex("[.]key = \"([a-z0-9_]+)\""), keys);
  return keys;
}

/// Keys in the code of the reader: those of the rows of settings, and the first text that a function of a
/// table is given, and lists of keys.
std::set<std::string> keys_of_the_reader() {
  const std::regex asked(
      R"re((?:\.|->)(?:has|is_text|number|integer|long_integer|boolean|text|triple|integers|numbers|texts|table|tables)\(\s*"([a-z0-9_]+)")re"),
      helped(
          R"re((?:number|read_word|read_setting|read_range|read_layer|read_even_width|read_limits|read_direction|both)\(\s*(?:\*?[a-z_]+, )?"([a-z0-9_]+)")re");
  std::set<std::string> keys = keys_of_rows();
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() / "stimuli/study_file")) {
    if (entry.path().extension() != ".cpp" || entry.path().filename() == "carried_texts.cpp") continue;
    const std::string text = test::read_text(entry.path());
    for (const std::regex& expression : {asked, helped}) add_matches(text, expression, keys);
  }
  for (const PhraseEntry& phrase : every_phrase()) keys.insert(std::string(phrase.key));
  for (const Quantity quantity : every_quantity) keys.insert(std::string(facts(quantity).key));
  return keys;
}

/// Keys in the first cells of the page's tables.
std::set<std::string> keys_of_the_page(const std::string& page) {
  const std::regex row(R"re(^\|((?: *`[a-z0-9_]+`,?)+) *\|)re"), key(R"re(`([a-z0-9_]+)`)re");
  std::set<std::string> keys;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    std::smatch cell;
    if (!std::regex_search(line, cell, row)) continue;
    const std::string first = cell[1];
    for (auto it = std::sregex_iterator(first.begin(), first.end(), key); it != std::sregex_iterator(); ++it)
      keys.insert((*it)[1]);
  }
  return keys;
}

/// Whether code holds a key: as a text, or without the unit that is put behind it.
bool code_has(const std::string& code, const std::string& key) {
  const std::string stem = key.substr(0, key.rfind('_'));
  return code.find("\"" + key + "\"") != std::string::npos ||
         code.find("\"" + stem + "\"") != std::string::npos ||
         code.find("\"" + stem + "_\"") != std::string::npos;
}

TEST(Reference, TablesOfSettingsAreThoseOfTheReader) {
  const std::string page = test::read_text(source_folder() / "documentation/reference/study_file.md");
  EXPECT_EQ(page, with_settings_tables(page)) << "copy manual/study_file.md of the build folder";
  EXPECT_EQ(test::complaint_of([] { (void)with_settings_tables("<!-- settings nonsense -->\n"); }),
            "<!-- settings nonsense -->: wanted the name of a table, found nonsense");
}

/// A value that code reads without a row has no row on the page, and nobody suggests it. These are no value
/// of one member: a source, noise that may be "none", and the parameters of QUEST+'s grid.
TEST(Reference, EveryValueThatIsReadHasARow) {
  const std::regex value(
      R"re((?:\.|->)(?:is_text|number|integer|long_integer|boolean|text|triple|integers|numbers|texts)\(\s*"([a-z0-9_]+)")re");
  const std::set<std::string> rows = keys_of_rows(), without = {"source", "noise", "count", "weights"};
  std::set<std::string> read, missing;
  for (const auto& entry : fs::recursive_directory_iterator(source_folder() / "stimuli/study_file"))
    if (entry.path().extension() == ".cpp" && entry.path().filename() != "carried_texts.cpp" &&
        entry.path().filename() != "texts_reader.cpp")  // files of texts are no study files
      add_matches(test::read_text(entry.path()), value, read);
  EXPECT_GE(read.size(), 25U);
  for (const std::string& key : read)
    if (!rows.contains(key)) missing.insert(key);
  EXPECT_EQ(missing, without);
}

TEST(Reference, TheStudyFilesPageHasEveryKeyThatIsReadAndNoOther) {
  const std::string page = test::read_text(source_folder() / "documentation/reference/study_file.md");
  const std::set<std::string> read = keys_of_the_reader(), listed = keys_of_the_page(page);
  EXPECT_GE(read.size(), 250U);
  EXPECT_GE(listed.size(), 250U);
  for (const std::string& key : read)
    EXPECT_TRUE(page.find("`" + key + "`") != std::string::npos ||
                page.find("[" + key + "]") != std::string::npos)
        << key << " is not on the page";
  std::string code;
  for (const char* folder : {"stimuli/study_file", "stimuli/settings", "stimuli/definition"})
    for (const auto& entry : fs::recursive_directory_iterator(source_folder() / folder))
      if (entry.is_regular_file()) code += test::read_text(entry.path());
  for (const std::string& key : listed) EXPECT_TRUE(code_has(code, key)) << key << " is on the page only";
}

}  // namespace
}  // namespace seamline
