// What documentation/how-to/exchange.md says of files and tells readers to type in Python is so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "exchange_examples.h"
#include "pages.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

class ExchangeExamples : public test::ExchangeTables {
 protected:
  [[nodiscard]] Outcome python() const {
    test::write_text(folder / "thresholds.py", test::example("python", 0));
    return in_folder("python3 thresholds.py");
  }
};

TEST_F(ExchangeExamples, PythonComputesTheSameThresholds) {
  const Outcome outcome = python();
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  expect_thresholds(outcome.output);
}

TEST_F(ExchangeExamples, PythonSaysWhatLiesBeyondTheWidthsAndKeepsCodesApart) {
  // 007 notices nothing, receivers least of all; 7, who is excluded, notices everything.
  test::write_text(folder / "tables/participants.csv",
                   "participant,completed,excluded,pilot\n007,1,0,0\n7,1,1,0\n");
  test::write_text(folder / "tables/answers.csv",
                   "participant,artifact,level,noticeability\n007,receiver,64,0\n007,receiver,256,0\n"
                   "7,receiver,64,4\n7,receiver,256,4\n007,shadow,64,4\n007,shadow,256,4\n"
                   "007,overlap,64,1\n007,overlap,256,0\n");
  const Outcome outcome = python();
  EXPECT_EQ(outcome.output, "overlap 128.0\nreceiver 0.0\nshadow inf\n");
}

TEST_F(ExchangeExamples, FilesOfEachLayoutAreThoseOfThePage) {
  std::set<std::string> named;
  for (const char* page : {"documentation/how-to/exchange.md", "documentation/reference/file_formats.md"})
    for (const std::string& span : test::code_spans(test::pages().at(page))) named.insert(span);
  const auto expect_named = [&](const std::string& layout) {
    ASSERT_EQ(in_folder(std::string(SEAMLINE_PROGRAM) + " export tables log.sqlite out" + layout +
                        " --layout " + layout)
                  .status,
              0);
    for (const auto& entry : fs::recursive_directory_iterator(folder / ("out" + layout))) {
      if (!entry.is_regular_file()) continue;
      // As the page has it: of many alike the first, of pairs the table, and of what differs in a word that
      // word.
      std::string name = fs::relative(entry.path(), folder / ("out" + layout)).string();
      name = std::regex_replace(name, std::regex("sub-[0-9]+"), "sub-001");
      name = std::regex_replace(name, std::regex("(study|task)-examples"), "$1-NAME");
      if (const std::size_t at = name.find("_description-"); at != std::string::npos) {
        name = std::regex_replace(name, std::regex("_data\\.json$"), "_data.csv");
        if (name.find("-answers_") == std::string::npos)
          name = std::regex_replace(name, std::regex("^.*_description(.*_)data.csv"), "...$1...");
      }
      if (name == "participants.json") name = ".json";
      EXPECT_TRUE(named.contains(name)) << layout << ": " << name;
    }
  };
  expect_named("csv");
  expect_named("psych-ds");
  expect_named("bids");
}

}  // namespace
}  // namespace seamline
