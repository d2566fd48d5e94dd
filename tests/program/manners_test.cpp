// Manners of the source, kept by reading it: who writes files, how SQL is put together, what tests need.
#include <gtest/gtest.h>
#include <regex.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "run_program.h"
#include "study/online/intake/import.h"
#include "support/text/counted.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> read_sources() {
  const fs::path root = SEAMLINE_SOURCE_DIR;
  std::map<std::string, std::string> found;
  const auto take = [&](const fs::path& path) {
    if (path.extension() != ".cpp" && path.extension() != ".h") return;
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    found[fs::relative(path, root).generic_string()] = text.str();
  };
  for (const char* folder :
       {"support", "sensors", "scenes", "physics", "registration", "stimuli", "raytracer", "renderer", "sets",
        "composites", "x3d", "study", "analysis", "live", "laboratory", "commands"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) take(entry.path());
  return found;
}

/// Every source file of the product, by its path from the root.
const std::map<std::string, std::string>& sources() {
  static const std::map<std::string, std::string> read = read_sources();
  return read;
}

/// By the C library's expressions, which read all sources in a tenth of the time of C++'s.
std::set<std::string> files_with(const std::string& pattern) {
  regex_t wanted{};
  if (regcomp(&wanted, pattern.c_str(), REG_EXTENDED | REG_NOSUB) != 0) throw std::invalid_argument(pattern);
  std::set<std::string> files;
  for (const auto& [file, text] : sources())
    if (regexec(&wanted, text.c_str(), 0, nullptr, 0) == 0) files.insert(file);
  regfree(&wanted);
  return files;
}

TEST(Manners, OneFunctionWritesFiles) {
  EXPECT_GT(sources().size(), 200U);
  // Besides write_file_atomically: a trace and frame times, which grow by the line while the window is open
  // and are for tests and for those who measure; the log (SQLite's own), with the empty file that claims its
  // name, and the lock beside it; the lock of a set.
  const std::set<std::string> openers = {
      "sets/sharing/set_claim.cpp",  "support/files/atomic_file.cpp", "study/app/pictures/frame_times.cpp",
      "study/app/screens/trace.cpp", "study/log/log_create.cpp",      "study/log/session_claims.cpp"};
  EXPECT_EQ(files_with(R"(std::(basic_)?o?fstream\b|\bfopen\(|\bO_CREAT\b|\bcreat\(|\bmkstemp\()"), openers);
  // A log that is recovered or upgraded takes its name when it is whole, too.
  EXPECT_EQ(files_with(R"(::rename\(|fs::rename\(|filesystem::rename\()"),
            (std::set<std::string>{"support/files/atomic_file.cpp", "study/log/recovery/new_log.cpp"}));
  // Libraries that could open files for writing by themselves give their bytes to it; that of pictures writes
  // into memory.
  EXPECT_EQ(files_with("ImageOutput::create"), std::set<std::string>{"support/codec/openimageio_codec.cpp"});
  EXPECT_NE(sources().at("support/codec/openimageio_codec.cpp").find("output->set_ioproxy(&bytes)"),
            std::string::npos);
  for (const std::string& file : files_with(R"(\.encode\(|WriteGltfSceneToFile|set output)"))
    EXPECT_NE(sources().at(file).find("write_file_atomically"), std::string::npos) << file;
}

TEST(Manners, OnePlaceMakesTemporaryFoldersAndNoNameIsForeseen) {
  // A folder among the system's temporary files that was not made by mkdtemp may be another user's, with what
  // they laid into it.
  const std::set<std::string> maker = {"support/files/temporary_folder.cpp"};
  EXPECT_EQ(
      files_with(R"(temp_directory_path|\bmkdtemp\(|"TMPDIR"|"/(var/)?tmp|\btmpnam\(|\btempnam\(|P_tmpdir)"),
      maker);
  // The process id names nothing: it is 1 in every container.
  EXPECT_EQ(files_with(R"(\bgetpid\()"), std::set<std::string>());
  // What runs other programs; gnuplot's script lies in a folder of its own.
  EXPECT_EQ(files_with(R"(\bposix_spawnp?\(|\bexec[lv][pe]*\(|\bpopen\(|\bsystem\()"),
            std::set<std::string>{"support/running/child_process.cpp"});
  EXPECT_EQ(files_with(R"(\brun_child\()"),
            (std::set<std::string>{"laboratory/evidence/remake.cpp", "support/files/gnuplot.cpp",
                                   "support/running/child_process.cpp", "support/running/child_process.h"}));
  EXPECT_NE(sources().at("support/files/gnuplot.cpp").find("const TemporaryFolder folder;"),
            std::string::npos);
}

TEST(Manners, PicturesOfASetAreOpenedWhereTheSetIs) {
  // A set may have come from somebody else, with links out of its folder: whoever opens what a manifest names
  // asks path_in_set. Its own two files know better, and so does what writes a set; `flip` and
  // `observe` open what their user names.
  const std::set<std::string> known = {"sets/set_pictures.cpp", "stimuli/set/manifest_pictures.cpp",
                                       "commands/photographs/flip_command.cpp",
                                       "analysis/detection/seen_pairs.cpp"};
  EXPECT_EQ(files_with(R"((folder|set)[a-z_]*(\(\))? / [a-z_.>()-]+(\.|->)(image|reference|object_ids)\b)"),
            std::set<std::string>{"sets/set_pictures.cpp"});
  for (const std::string& file : files_with(R"(\bread_bytes_image\()")) {
    const std::string& text = sources().at(file);
    const bool confined = text.find("path_in_set") != std::string::npos ||
                          text.find("path_below") != std::string::npos || known.contains(file) ||
                          file.starts_with("support/files/");
    EXPECT_TRUE(confined) << file;
  }
}

TEST(Manners, WhatLiesBesideALogIsFoundInOnePlace) {
  // Beside the path that was given there may be a link's folder (study/log/log_place.h).
  EXPECT_EQ(files_with(R"re("-(wal|shm|journal|lock)")re"),
            (std::set<std::string>{"commands/demo.cpp", "study/log/log_place.cpp"}));
}

TEST(Manners, SqlIsNeverPutTogetherFromValues) {
  // The only SQL that is formatted is the schema, from the words of enumerations, and that of recovering,
  // upgrading and merging logs, and of asking whether one holds anything, from the names of its tables and
  // columns; the only one that is joined, a list of columns in log_records.cpp. Values are always bound.
  const std::regex sql_word(R"re("[^"\n]*\b(SELECT|INSERT|UPDATE|DELETE|PRAGMA|CREATE TABLE)\b[^"\n]*")re");
  const std::regex formatted(
      R"re((fmt::)?format(_to)?\(\s*(fmt::runtime\()?"[^"]*\b(SELECT|INSERT|UPDATE|DELETE)\b)re");
  const std::regex joined(
      R"re((\+\s*"[^"\n]*\b(FROM|WHERE|VALUES|SET)\b)|(\b(SELECT|INSERT|UPDATE|DELETE|WHERE|VALUES)\b[^"\n]*"\s*\+))re");
  int with_sql = 0;
  std::set<std::string> joining, formatting;
  for (const auto& [file, text] : sources()) {
    with_sql += std::regex_search(text, sql_word) ? 1 : 0;
    if (std::regex_search(text, formatted)) formatting.insert(file);
    if (std::regex_search(text, joined)) joining.insert(file);
  }
  EXPECT_GE(with_sql, 6);
  EXPECT_EQ(formatting, (std::set<std::string>{"study/log/log_create.cpp", "study/log/online/log_merge.cpp",
                                               "study/log/recovery/log_recovery.cpp",
                                               "study/log/recovery/log_salvage.cpp",
                                               "study/log/recovery/log_upgrade.cpp"}));
  EXPECT_EQ(joining, (std::set<std::string>{"study/log/log_records.cpp"}));
  // What is joined there is a constant of the file.
  const std::string records = sources().at("study/log/log_records.cpp");
  const std::regex operand(R"(\+\s*([A-Za-z_]+)\s*\+)");
  for (auto match = std::sregex_iterator(records.begin(), records.end(), operand);
       match != std::sregex_iterator(); ++match)
    EXPECT_EQ((*match)[1], "display_columns");
  EXPECT_NE(records.find("constexpr const char* display_columns"), std::string::npos);
}

TEST(Manners, EverythingInHtmlIsEscaped) {
  // Whoever makes a page escapes: a page without it would be one where it was forgotten.
  for (const std::string& file : files_with(R"(<(td|th|h1|h2|figcaption)>\{\})"))
    EXPECT_NE(sources().at(file).find("html_escape"), std::string::npos) << file;
}

TEST(Manners, QuickTestsNeedNothingBesideTheRepositoryAndCiRefusesWhatIsSkipped) {
  const fs::path root = SEAMLINE_SOURCE_DIR;
  int read = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root / "tests")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with("_test.cpp") || name.ends_with("_full_test.cpp") || name == "manners_test.cpp")
      continue;
    const std::string text = test::read_text(entry.path());
    for (const char* beside :
         {"SOURCE_DIR).parent_path()", "SOURCE_DIR \"/..", "SOURCE_DIR) / \"..", "tests/real_data.h"})
      EXPECT_EQ(text.find(beside), std::string::npos) << entry.path() << ": " << beside;
    ++read;
  }
  EXPECT_GT(read, 200);
  const fs::path log = test::fresh_folder("skipped") / "LastTest.log";
  const std::string program = (root / ".ci/skipped").string();
  test::write_text(log, "[       OK ] A.B (0 ms)\n[  PASSED  ] 1 test.\n");
  EXPECT_EQ(test::run_program(program, log.string()).status, 0);
  test::write_text(
      log, "[  SKIPPED ] A/B.C/0 (0 ms)\n[  PASSED  ] 0 tests.\n[  SKIPPED ] 1 test, listed below:\n");
  const test::Outcome outcome = test::run_program(program, log.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.output, "A/B.C/0\n");
}

TEST(Manners, OneThingIsSaidInTheSingular) {
  EXPECT_EQ(counted(0, "answer"), "0 answers");
  EXPECT_EQ(counted(1, "answer"), "1 answer");
  EXPECT_EQ(counted(std::size_t{2}, "answer"), "2 answers");
  EXPECT_EQ(counted(1, "person", "people"), "1 person");
  EXPECT_EQ(counted(-1, "person", "people"), "-1 people");
  EXPECT_EQ(counted(std::int64_t{1} << 40, "stimulus", "stimuli"), "1099511627776 stimuli");
  const study::online::ImportReport report{
      .files = 1,
      .messages = 59,
      .people = {{.code = "p01", .stored = 1, .answered = 26, .trials = 26, .completed = true}}};
  EXPECT_EQ(
      study::online::import_text(report, "log"),
      "log: 59 messages of 1 participant in 1 file: 1 new, 0 known, 0 left out; 1 participant complete, "
      "0 incomplete, 0 declined\np01  static  26 of 26 trials answered, complete; 1 message new, 0 "
      "known\n");
}

}  // namespace
}  // namespace seamline
