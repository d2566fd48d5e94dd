// QUEST+ in tasks other than the paper's: it learns from what was right, and knows the chance of the task.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "study/log/log.h"
#include "study/placement/placed_answer.h"
#include "study/running/quest_plus_results.h"
#include "study/running/simulation.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

std::string adaptive_task_text(const std::string& task, int objects = 3) {
  std::string text = study_text("tiny", paper_widths_px, objects);
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\nmax_shows_per_image = 40\nmax_trials = 60\n");
  return text + "[observer]\npeople_sd_octaves = 0\n" + task;
}

TEST(TaskQuestPlus, APlacedAnswerIsRightExactlyWhereTheAnswerIs) {
  for (int place = 1; place <= objects_per_stimulus; ++place)
    for (int right = 0; right <= 2; ++right)
      for (int chosen = 1; chosen <= 2; ++chosen) {
        const TrialAnswer placed = placed_answer({.chosen_index = chosen, .rating = 1}, right, place);
        EXPECT_EQ(placed.chosen_index == place, chosen == (right == 0 ? place : right));
      }
}

TEST(TaskQuestPlus, FindsWhatWasPlantedWhateverTheTask) {
  for (const auto& [task, objects] :
       std::vector<std::pair<const char*, int>>{{"[task]\nkind = \"pair\"\n", 3},
                                                {"[task]\nkind = \"interval\"\npictures = 3\n", 3},
                                                {"[catch]\nreference = 20\n[task]\nkind = \"yes_no\"\n", 3},
                                                {"[task]\nkind = \"object\"\nobjects = 2\n", 2},
                                                {"[task]\nkind = \"object\"\nobjects = 5\n", 5}}) {
    const TemporaryFolder folder;
    const RenderedSet set = write_set_of_text(folder / "set", adaptive_task_text(task, objects));
    run_simulated_study({.set_folder = folder / "set",
                         .log = folder / "log",
                         .observer = ObserverKind::threshold,
                         .count = objects == 2 ? 30 : 12,
                         .seed = 3});
    std::map<Artifact, double> sum;
    std::map<Artifact, int> tracks;
    for (const TrackEstimate& estimate : quest_plus_estimates(read_log(folder / "log"))) {
      sum[estimate.artifact] += std::log2(estimate.threshold);
      ++tracks[estimate.artifact];
    }
    ASSERT_EQ(sum.size(), 4U) << task;
    for (const auto& [artifact, total] : sum)
      EXPECT_NEAR(total / tracks[artifact], std::log2(set.study.observer.midpoint.at(artifact)), 0.35)
          << task << word(artifact);
  }
}

TEST(TaskQuestPlus, ASessionThatBreaksOffGoesOnWithTheSameTrials) {
  const TemporaryFolder folder;
  (void)write_set_of_text(folder / "set", adaptive_task_text("[task]\nkind = \"pair\"\n"));
  for (const char* name : {"whole", "again"})
    run_simulated_study({.set_folder = folder / "set",
                         .log = folder / name,
                         .observer = ObserverKind::threshold,
                         .count = 2,
                         .seed = 5});
  const LogContents whole = read_log(folder / "whole"), again = read_log(folder / "again");
  ASSERT_EQ(whole.answers.size(), again.answers.size());
  for (std::size_t i = 0; i < whole.answers.size(); ++i) {
    ASSERT_EQ(whole.answers[i].stimulus_id, again.answers[i].stimulus_id);
    ASSERT_EQ(whole.answers[i].right_index, again.answers[i].right_index);
  }
}

}  // namespace
}  // namespace seamline::study
