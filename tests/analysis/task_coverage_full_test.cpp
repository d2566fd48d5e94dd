// Planted thresholds are found again in every task: how often does the 95 % interval of detection hold the
// level that the simulated people see half of the time? 50 studies a task, or SEAMLINE_TRUE_STUDIES; prints
// the table of documentation/evidence/coverage.md.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "stimuli/study_file/study_file.h"
#include "study/running/simulation.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
namespace {

struct CoveredTask {
  const char* name;
  const char* tables;
  int people;
  int objects = 3;
};
const std::vector<CoveredTask> covered_tasks = {
    {"object, no rating", "[task]\nkind = \"object\"\nsecond_question = false\nrepetitions = 2\n", 20},
    {"pair", "[task]\nkind = \"pair\"\nrepetitions = 2\n", 20},
    {"pair, rated", "[task]\nkind = \"pair\"\nsecond_question = true\n", 20},
    {"interval of 2", "[task]\nkind = \"interval\"\nrepetitions = 2\n", 20},
    {"interval of 3", "[task]\nkind = \"interval\"\npictures = 3\nrepetitions = 2\n", 20},
    {"yes or no", "[catch]\nreference = 21\n[task]\nkind = \"yes_no\"\nrepetitions = 2\n", 20},
    {"rating", "[catch]\nreference = 21\n[task]\nkind = \"rating\"\n", 20},
    {"pair, 2 people", "[task]\nkind = \"pair\"\nrepetitions = 20\n", 2},
    {"2 objects, no rating",
     "[task]\nkind = \"object\"\nobjects = 2\nsecond_question = false\nrepetitions = 3\n", 20, 2},
    {"2 objects, rated", "[task]\nkind = \"object\"\nobjects = 2\n", 20, 2},
    {"5 objects, no rating", "[task]\nkind = \"object\"\nobjects = 5\nsecond_question = false\n", 20, 5},
    {"5 objects, rated", "[task]\nkind = \"object\"\nobjects = 5\n", 20, 5},
    {"8 objects, no rating", "[task]\nkind = \"object\"\nobjects = 8\nsecond_question = false\n", 20, 8}};

struct TaskTally {
  int curves = 0, numbers = 0, held = 0;
  double squares = 0;  ///< of errors, octaves
};

void add_study(TaskTally& tally, const Analysis& analysis, const ObserverDefinition& observer) {
  for (std::size_t c = 0; c < analysis.data.artifacts.size(); ++c) {
    const ArtifactScores& scores = analysis.data.artifacts[c];
    const JointThreshold& found =
        threshold_of(*analysis.joint, static_cast<int>(c), JointQuantity::detection);
    const double planted = x_of(analysis.data.axis, observer.midpoint.at(scores.artifact));
    ++tally.curves;
    if (found.here.ci95.low_x <= planted && planted <= found.here.ci95.high_x) ++tally.held;
    if (!found.here.level_x) continue;
    ++tally.numbers;
    tally.squares += (*found.here.level_x - planted) * (*found.here.level_x - planted);
  }
}

TEST(TaskCoverage, IntervalsOfDetectionHoldWhatWasPlanted) {
  const char* given = std::getenv("SEAMLINE_TRUE_STUDIES");
  const int studies = given == nullptr ? 50 : std::atoi(given);
  fmt::print("| task | people | curves | interval holds (%) | with a number (%) | error, octaves |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- |\n");
  for (const CoveredTask& task : covered_tasks) {
    TaskTally tally;
    for (int seed = 1; seed <= studies; ++seed) {
      const TemporaryFolder folder;
      const study::RenderedSet set = study::write_set_of_text(
          folder / "set", study::study_text("covered", study::paper_widths_px, task.objects) + task.tables);
      study::run_simulated_study({.set_folder = folder / "set",
                                  .log = folder / "log",
                                  .observer = study::ObserverKind::threshold,
                                  .count = task.people,
                                  .seed = static_cast<std::uint64_t>(seed)});
      add_study(tally, analyze(study::read_log(folder / "log"), false, {.replicates = 20, .seed = 1}),
                set.study.observer);
    }
    const double held = static_cast<double>(tally.held) / tally.curves;
    fmt::print("| {} | {} | {} | {:.1f} | {:.1f} | {:.2f} |\n", task.name, task.people, tally.curves,
               100 * held, 100.0 * tally.numbers / tally.curves,
               std::sqrt(tally.squares / std::max(1, tally.numbers)));
    // Curves of a study share their people, so that 50 studies and not 200 curves are independent.
    EXPECT_GT(held, 0.95 - 3.5 * std::sqrt(0.95 * 0.05 / studies)) << task.name;
  }
}

}  // namespace
}  // namespace seamline::analysis
