// `analyze --no-seam-at`: two one-sided tests, computed again from the answers.
#include "analysis/log_analysis/no_seam.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "study/log/log.h"
#include "study/running/simulation.h"
#include "support/text/error.h"
#include "tests/complaint.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
using namespace study;
namespace {

using testing::HasSubstr;

Analysis analysis_of_widths(const std::string& top) {
  const TemporaryFolder folder;
  std::string text = study_text("no_seam", paper_widths_px);
  text.insert(text.find("[session]"), top);
  (void)write_set_of_text(folder / "set", text);
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 20});
  return analyze(read_log(folder / "log"), false, {.replicates = 100, .threads = 1});
}

TEST(NoSeam, IsShownWhereNobodySeesOneAndNotWhereTheyDo) {
  const Analysis analysis = analysis_of_widths("");
  const std::vector<std::string> far = no_seam_sentences(analysis, 4096, 0.3),
                                 near = no_seam_sentences(analysis, 64, 0.3);
  ASSERT_EQ(far.size(), 4U);
  EXPECT_THAT(far[0], HasSubstr("No seam is seen in 'receiver' at 4096"));
  EXPECT_THAT(near[0], HasSubstr("That no seam is seen is not shown in 'receiver' at 64"));

  double ratings = 0, wrong = 0;
  for (const Answer& answer : analysis.log.answers)
    if (answer.chosen_index != answer.object_index) {
      ratings += answer.rating;
      ++wrong;
    }
  std::map<std::string, std::vector<double>> scores;
  for (const Answer& answer : analysis.log.answers)
    if (answer.artifact == Artifact::receiver && answer.level == 4096)
      scores[answer.participant].push_back(answer.chosen_index == answer.object_index ? answer.rating
                                                                                      : -ratings / wrong / 2);
  double mean = 0, squares = 0;
  const auto mean_of = [](const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value / static_cast<double>(values.size());
    return sum;
  };
  for (const auto& [person, values] : scores) mean += mean_of(values) / 20;
  for (const auto& [person, values] : scores) squares += std::pow(mean_of(values) - mean, 2);
  const double reach = 1.729132811521367 * std::sqrt(squares / 19 / 20);  // t of 19, 95 %
  EXPECT_THAT(far[0], HasSubstr(fmt::format("(90 % interval {:.2f} to {:.2f})", mean - reach, mean + reach)));
}

TEST(NoSeam, RefusesLevelsThatNobodyWasShown) {
  const Analysis analysis = analysis_of_widths("");
  EXPECT_THAT(test::complaint_of([&] { (void)no_seam_sentences(analysis, 100, 0.3); }),
              HasSubstr("no_seam_at"));
}

}  // namespace
}  // namespace seamline::analysis
