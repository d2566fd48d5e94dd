// Plans of studies that ask another question than the paper's.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/foresight/plan_text.h"
#include "study/observers/observer.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"

namespace seamline::analysis {
namespace {

struct TaskPlan {
  std::string name, tables;
  std::string chance;      ///< as the plan says it
  bool rated = false;      ///< PT and SN are wanted, else detection
  int trials_a_level = 3;  ///< of a participant
  int objects = 3;
};
const std::vector<TaskPlan> task_plans = {
    {"object", "[task]\nkind = \"object\"\nsecond_question = false\nrepetitions = 4\n", "Chance is 1/3.",
     false, 12},
    {"pair", "[task]\nkind = \"pair\"\nrepetitions = 4\n", "Chance is 1/2.", false, 12},
    {"pair, rated", "[task]\nkind = \"pair\"\nsecond_question = true\n", "Chance is 1/2.", true, 3},
    {"interval", "[task]\nkind = \"interval\"\npictures = 3\nrepetitions = 4\n", "Chance is 1/3.", false, 12},
    {"yes_no", "[catch]\nreference = 20\n[task]\nkind = \"yes_no\"\nrepetitions = 4\n",
     "Chance is the share of false alarms, 10 %, taken from 20 reference trials of each person.", false, 12},
    {"rating", "[catch]\nreference = 20\n[task]\nkind = \"rating\"\n",
     "Chance is the share of false alarms, 0 %, taken from 20 reference trials of each person.", true, 3},
    {"2 objects", "[task]\nkind = \"object\"\nobjects = 2\nsecond_question = false\nrepetitions = 6\n",
     "Chance is 1/2.", false, 12, 2},
    {"5 objects", "[task]\nkind = \"object\"\nobjects = 5\n", "Chance is 1/5.", true, 5, 5}};

constexpr const char* planned_widths = "depth_width_px = [64, 128, 256, 512, 1024, 2048]\n";

class PlanTasks : public testing::Test {
 protected:
  PlanRequest request(const std::string& tables, const std::string& head = planned_widths, int objects = 3) {
    std::string text = "format = \"seamline study 1\"\nname = \"plan\"\n" + head +
                       "[[scene]]\nname = \"room\"\nfile = \"none.glb\"\nartifacts = [\"receiver\"]\n";
    for (int object = 0; object < objects; ++object)
      text += std::string("[[scene.object]]\nname = \"") + static_cast<char>('a' + object) +
              "\"\nfile = \"none.glb\"\n";
    write_file_atomically(folder_ / "study.toml", text + tables);
    PlanRequest request;
    request.study_file = folder_ / "study.toml";
    request.participants = {8, 24};
    request.studies = 12;
    return request;
  }

  std::string complaint(const PlanRequest& wish) {
    return test::complaint_of([&] { (void)plan_study(wish); });
  }

  const TemporaryFolder folder_;
};

/// Detection lies where the assumed people see half; the estimates approach the truth, intervals shorten with
/// more people and hold the truth, whatever is asked.
TEST_F(PlanTasks, EveryTaskHasItsChanceItsQuantityAndLittleBias) {
  for (const TaskPlan& task : task_plans) {
    const StudyPlan plan = plan_study(request(task.tables, planned_widths, task.objects));
    ASSERT_EQ(plan.targets.size(), task.rated ? 2U : 1U) << task.name;
    EXPECT_EQ(plan.trials_a_level, task.trials_a_level) << task.name;
    if (!task.rated) {
      EXPECT_EQ(plan.targets[0].quantity.word, "detection") << task.name;
      EXPECT_NEAR(plan.targets[0].truth_x, std::log2(300), 1e-6) << task.name;
    }
    for (std::size_t target = 0; target < plan.targets.size(); ++target) {
      EXPECT_LT(std::abs(plan.bias_x[target][0].value()), 0.1) << task.name << target;
      const std::size_t first = target * plan.level_sets.size() * 2;  // of the study's own levels
      const PlannedInterval &few = plan.rows[first].interval, &many = plan.rows[first + 1].interval;
      EXPECT_LT(many.median_length.value(), few.median_length.value_or(infinity)) << task.name << target;
      EXPECT_GE(many.holds_share, 0.7) << task.name << target;
    }
    EXPECT_NE(plan_text(plan).find(task.chance), std::string::npos) << plan.assumptions;
  }
}

/// The people of a plan answer as those of `study --observer threshold` do, draw for draw.
TEST_F(PlanTasks, PeopleAnswerAsSimulatedParticipantsDo) {
  const std::vector<double> levels = {64, 300, 2048};
  const PlannedCurve receiver{.artifact = Artifact::receiver, .condition = "", .objects = 3, .midpoint = 300};
  for (const TaskFacts& facts :
       {TaskFacts{.kind = TaskKind::pair, .alternatives = 2, .chance = 0.5, .draws_right = true},
        TaskFacts{
            .kind = TaskKind::pair, .alternatives = 2, .chance = 0.5, .draws_right = true, .rates = false},
        TaskFacts{
            .kind = TaskKind::yes_no, .alternatives = 2, .chance = 0, .right_is_yes = true, .rates = false},
        TaskFacts{.kind = TaskKind::rating,
        .alternatives = 2,
        .chance = 0,
        .right_is_yes = true,
        .chooses = false}}) {
    PlannedPopulation population;
    population.task = {.facts = facts,
                       .repetitions = 2,
                       .references = facts.right_is_yes ? 5 : 0,
                       .false_alarms = facts.chooses ? study::simulated_false_alarms : 0};
    const SimulatedAnswers answers = simulate_answers(population, {receiver}, levels, 10, 3, 5);
    for (int p = 0; p < 10; ++p) {
      Random random(3, 5 + static_cast<std::uint64_t>(p));
      const study::Observer person =
          study::make_observer(study::ObserverKind::threshold, population.observer, random);
      for (std::size_t level = 0; level < levels.size(); ++level) {
        double sum = 0;
        for (int shown = 0; shown < 6; ++shown) {
          Stimulus stimulus;
          stimulus.artifact = Artifact::receiver;
          stimulus.level = levels[level];
          const int right = facts.right_is_yes ? 1 : 1 + shown % 2;
          const study::Response response = study::respond(
              person, stimulus, study::alternatives_of(facts, {.right_index = right}, 1), random);
          if (response.chosen_index == right) sum += facts.rates ? response.rating : 1;
        }
        EXPECT_EQ(scores_of(answers, 0, 10, {})(p, static_cast<Eigen::Index>(level)), sum / 6);
      }
      int alarms = 0;
      for (int trial = 0; trial < population.task.references; ++trial)
        alarms +=
            study::respond_to_reference(
                study::alternatives_of(facts, {.kind = study::TrialKind::reference, .right_index = 2}, 1),
                random)
                        .chosen_index == 1
                ? 1
                : 0;
      if (facts.right_is_yes) {
        EXPECT_EQ(answers.false_alarms[p], alarms);
        EXPECT_EQ(answers.references.row(p).sum(), 5);
      }
    }
  }
}

/// More false alarms leave less to see, and less to guess tells more.
TEST_F(PlanTasks, AHigherChanceNeedsMoreAnswers) {
  PlanRequest few = request(task_plans[4].tables);
  few.participants = {24};
  PlanRequest many = few;
  few.assumed.false_alarms = 0.02;
  many.assumed.false_alarms = 0.5;
  EXPECT_LT(plan_study(few).rows[0].interval.median_length.value(),
            plan_study(many).rows[0].interval.median_length.value_or(infinity));
}

TEST_F(PlanTasks, DetectionCanBeAskedOfTheRatedOnesToo) {
  PlanRequest wish = request("");
  wish.wanted.quantities = {"detection", "SN"};
  wish.studies = 2;
  const StudyPlan plan = plan_study(wish);
  ASSERT_EQ(plan.targets.size(), 2U);
  EXPECT_EQ(plan.targets[1].quantity.word, "detection");
  EXPECT_NEAR(plan.targets[1].truth_x, std::log2(300), 1e-6);
  wish.estimator = PlanEstimator::straight_lines;
  EXPECT_NE(complaint(wish).find("detection beside estimator joint"), std::string::npos) << complaint(wish);
}

/// One guess in two is right and rated 1, which is PT's level.
TEST_F(PlanTasks, WhatGuessesReachIsNoThreshold) {
  PlanRequest wish = request(task_plans[2].tables);
  wish.studies = 1;
  EXPECT_EQ(plan_study(wish).targets[1].quantity.word, "corrected-PT");
  wish.wanted.quantities = {"PT"};
  EXPECT_NE(complaint(wish).find("guesses alone"), std::string::npos) << complaint(wish);
}

TEST_F(PlanTasks, WhatHasNoMeaningIsRefusedByName) {
  const std::string pair = task_plans[1].tables;
  PlanRequest wish = request(pair);
  wish.wanted.quantities = {"PT"};
  EXPECT_NE(complaint(wish).find("quantities: wanted"), std::string::npos) << complaint(wish);
  wish = request(pair);
  wish.assumed.criteria_sd = 0.5;
  EXPECT_NE(complaint(wish).find("criteria_sd: wanted"), std::string::npos) << complaint(wish);
  wish = request(pair);
  wish.assumed.high_guesses = 0.5;
  EXPECT_NE(complaint(wish).find("high_guesses: wanted"), std::string::npos) << complaint(wish);
  wish = request(pair);
  wish.assumed.false_alarms = 0.1;
  EXPECT_NE(complaint(wish).find("false_alarms: wanted"), std::string::npos) << complaint(wish);
  wish = request(pair);
  wish.estimator = PlanEstimator::straight_lines;
  EXPECT_NE(complaint(wish).find("estimator: wanted"), std::string::npos) << complaint(wish);
  EXPECT_NE(complaint(request("[task]\nkind = \"match\"\n")).find("where people match"), std::string::npos);
  const std::string stairs = "depth_width_px = [64, 128, 256]\nprocedure = \"staircase\"\n";
  EXPECT_NE(complaint(request("[task]\nkind = \"pair\"\n", stairs)).find("staircase"), std::string::npos);
}

}  // namespace
}  // namespace seamline::analysis
