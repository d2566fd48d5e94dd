// What documentation/how-to/exchange.md tells readers to type in R gives what `analyze` gives; other people's
// programs read what `export` writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "exchange_examples.h"

namespace seamline {
namespace {

using test::example;
using test::Outcome;
using test::run_program;

class ExchangeExamples : public test::ExchangeTables {};

/// `bids-validator` of npm: the program that SEAMLINE_BIDS_VALIDATOR names, else one on the path.
std::string bids_validator() {
  const char* named = std::getenv("SEAMLINE_BIDS_VALIDATOR");
  return named != nullptr ? named : "bids-validator";
}

TEST_F(ExchangeExamples, RComputesTheSameThresholds) {
  if (in_folder("Rscript --version").status != 0) GTEST_SKIP() << "there is no R here";
  test::write_text(folder / "thresholds.R", example("r", 0));
  const Outcome outcome = in_folder("Rscript thresholds.R");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  expect_thresholds(outcome.output);
}

TEST_F(ExchangeExamples, ROrdinalFindsTheSameSlopes) {
  if (in_folder("Rscript -e 'library(ordinal)'").status != 0)
    GTEST_SKIP() << "there is no R with ordinal here";
  test::write_text(folder / "slopes.R", example("r", 0) + example("r", 1));
  const Outcome outcome = in_folder("Rscript slopes.R");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  std::istringstream words(outcome.output);  // two lines: names, numbers
  std::vector<std::string> names;
  std::map<std::string, double> slope;
  std::size_t next = 0;
  for (std::string word; words >> word;) {
    if (word.starts_with("artifact") && word.ends_with(":x")) {
      names.push_back(word.substr(8, word.size() - 10));
      continue;
    }
    if (next < names.size()) slope[names[next++]] = std::stod(word);
  }
  const std::string table = test::read_text(folder / "report/comparisons_coefficients.csv");
  ASSERT_EQ(slope.size(), 4U) << outcome.output;
  for (const auto& [artifact, value] : slope) {
    const std::string row = "\"" + artifact + ", per octave of width\",";
    const std::size_t at = table.find(row);
    ASSERT_NE(at, std::string::npos) << artifact;
    EXPECT_NEAR(value, std::stod(table.substr(at + row.size())), 1e-3) << artifact;
  }
}

TEST_F(ExchangeExamples, TheValidatorOfBidsFindsNoError) {
  if (run_program(bids_validator(), "--version").status != 0)
    GTEST_SKIP() << "bids-validator 1.15 of npm is neither on the path nor named by SEAMLINE_BIDS_VALIDATOR";
  for (const std::string how : {"", " --anonymise"}) {
    const std::string out = (folder / (how.empty() ? "bids" : "anonymous")).string();
    ASSERT_EQ(
        in_folder(std::string(SEAMLINE_PROGRAM) + " export tables log.sqlite " + out + " --layout bids" + how)
            .status,
        0);
    const Outcome judged = run_program(bids_validator(), out);
    EXPECT_EQ(judged.status, 0) << judged.output;
    EXPECT_THAT(judged.output, testing::AllOf(testing::HasSubstr("20 - Subjects"),
                                              testing::Not(testing::HasSubstr("[ERR]"))));
  }
}

}  // namespace
}  // namespace seamline
