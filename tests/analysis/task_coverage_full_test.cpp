// Planted thresholds are found again in every task: how often does the 95 % interval of detection hold the
// level that the simulated people see half of the time? 50 studies a task, or SEAMLINE_TRUE_STUDIES, of
// seeds from 1 or SEAMLINE_TRUE_FIRST_SEED on; prints the table of documentation/evidence/coverage.md.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/matching/match_thresholds.h"
#include "stimuli/definition/parts/task_definition.h"
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
  const char* first = "";  ///< keys before the first table
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
    {"8 objects, no rating", "[task]\nkind = \"object\"\nobjects = 8\nsecond_question = false\n", 20, 8},
    {"pair, staircases 3 down 1 up", "[task]\nkind = \"pair\"\n", 20, 3, "procedure = \"staircase\"\n"},
    {"match, 4 times", "[task]\nkind = \"match\"\nrepetitions = 4\n", 20}};

/// Tasks whose names hold this; all where it is not set.
bool is_wanted(const CoveredTask& task) {
  const char* wanted = std::getenv("SEAMLINE_TRUE_TASKS");
  return wanted == nullptr || std::string(task.name).find(wanted) != std::string::npos;
}

std::string text_of(const CoveredTask& task) {
  std::string text = study::study_text("covered", study::paper_widths_px, task.objects) + task.tables;
  return text.insert(text.find("seed = "), task.first);
}

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

/// In a match the threshold is a mean over people, with Student's interval.
void add_matches(TaskTally& tally, study::LogContents log, const ObserverDefinition& observer) {
  std::vector<ParticipantUse> people = select_participants(log, false);
  for (const CurveMatches& curve : analyze_matches(std::move(log), std::move(people)).curves) {
    const double planted = std::log2(observer.midpoint.at(curve.artifact));
    ++tally.curves;
    ++tally.numbers;
    if (curve.threshold.low <= planted && planted <= curve.threshold.high) ++tally.held;
    tally.squares += (curve.threshold.mean - planted) * (curve.threshold.mean - planted);
  }
}

TEST(TaskCoverage, IntervalsOfDetectionHoldWhatWasPlanted) {
  const char* given = std::getenv("SEAMLINE_TRUE_STUDIES");
  const int studies = given == nullptr ? 50 : std::atoi(given);
  const char* first_given = std::getenv("SEAMLINE_TRUE_FIRST_SEED");
  const int first = first_given == nullptr ? 1 : std::atoi(first_given);
  fmt::print("| task | people | curves | interval holds (%) | with a number (%) | error, octaves |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- |\n");
  for (const CoveredTask& task : covered_tasks) {
    if (!is_wanted(task)) continue;
    TaskTally tally;
    for (int seed = first; seed < first + studies; ++seed) {
      const TemporaryFolder folder;
      const study::RenderedSet set = study::write_set_of_text(folder / "set", text_of(task));
      study::run_simulated_study({.set_folder = folder / "set",
                                  .log = folder / "log",
                                  .observer = study::ObserverKind::threshold,
                                  .count = task.people,
                                  .seed = static_cast<std::uint64_t>(seed)});
      study::LogContents log = study::read_log(folder / "log");
      if (facts_of(log.task.get()).adjusts())
        add_matches(tally, std::move(log), set.study.observer);
      else
        add_study(tally, analyze(std::move(log), false, {.replicates = 20, .seed = 1}), set.study.observer);
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
