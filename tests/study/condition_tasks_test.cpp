// Conditions with tasks of their own: the study file, the order of trials, and what simulated people answer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/people/language_definition.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "stimuli/study_file/study_file.h"
#include "study/log/log.h"
#include "study/running/simulation.h"
#include "study/trials/participant_trials.h"
#include "study/visit/visit_script.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

using testing::HasSubstr;

constexpr const char* three_tasks = R"toml(
[catch]
reference = 8
attention = 4
[[condition]]
name = "object"
[[condition]]
name = "interval"
  [condition.task]
  kind = "interval"
  pictures = 3
  repetitions = 2
[[condition]]
name = "seen"
  [condition.task]
  kind = "yes_no"
  question = "Is anything wrong here?"
)toml";

class ConditionTasks : public testing::Test {
 protected:
  TemporaryFolder folder;

  RenderedSet set_with(const std::string& tables) {
    return write_set_of_text(folder / fmt::format("set-{}", made_++),
                             study_text("asked", "64, 512") + tables);
  }
  LogContents simulate(const RenderedSet& set, ObserverKind observer, int count) {
    const std::filesystem::path log = folder / fmt::format("log-{}", made_++);
    run_simulated_study(
        {.set_folder = set.folder, .log = log, .observer = observer, .count = count, .seed = 4});
    return read_log(log);
  }
  std::string complaint(const std::string& tables, const std::string& first = "") {
    std::string text = study_text("asked", "64, 512") + tables;
    text.insert(text.find("seed = "), first);
    return test::complaint_of([&] { (void)read_study_text(text, "study.toml", IdleSettings::refused); });
  }

 private:
  int made_ = 0;
};

TEST_F(ConditionTasks, AConditionAsksItsOwnQuestionInItsOwnWords) {
  const StudyDefinition study = set_with(three_tasks).study;
  EXPECT_EQ(facts_of(task_of(study, "object").get()).kind, TaskKind::object);
  EXPECT_EQ(facts_of(task_of(study, "interval").get()).pictures, 3);
  EXPECT_EQ(asked_texts(study, task_of(study, "object").get()).question, study.session.question);
  EXPECT_EQ(asked_texts(study, task_of(study, "seen").get()).question, "Is anything wrong here?");
  EXPECT_EQ(study.instructions.size(), default_instructions().size() + 2);  // those of each task
  ASSERT_EQ(task_groups(study).size(), 3U);
  EXPECT_EQ(task_groups(study)[1].conditions, std::vector<std::string>{"interval"});
  const StudyDefinition part = study_of_group(study, task_groups(study)[2]);
  EXPECT_EQ(part.conditions.size(), 1U);
  EXPECT_EQ(facts_of(part.task.get()).kind, TaskKind::yes_no);
  EXPECT_NE(canonical_text(study), canonical_text(part));
}

TEST_F(ConditionTasks, WhatCannotStandBesideItIsRefused) {
  const std::string two = "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\n";
  EXPECT_THAT(complaint(two + "[condition.task]\nkind = \"match\"\n"), HasSubstr("right answers"));
  EXPECT_THAT(complaint(two + "[condition.task]\nkind = \"yes_no\"\n"), HasSubstr("catch.reference"));
  EXPECT_THAT(complaint(two + "[condition.task]\nkind = \"pair\"\nobjects = 2\n"), HasSubstr("objects"));
  EXPECT_THAT(complaint(two + "[condition.task]\nkind = \"pair\"\nblocks = \"condition\"\n"),
              HasSubstr("always in blocks"));
  EXPECT_THAT(complaint(two + "[condition.task]\nkind = \"object\"\n"), HasSubstr("no other condition has"));
  EXPECT_THAT(complaint(two + "[condition.task]\nkind = \"pair\"\n", "procedure = \"staircase\"\n"),
              HasSubstr("\"constant\" beside a [condition.task]"));
  EXPECT_THAT(complaint("[[condition]]\nname = \"a\"\n[condition.task]\nkind = \"pair\"\n"),
              HasSubstr("one condition"));
  EXPECT_THAT(complaint("[[condition]]\nname = \"a\"\ninstructions = \"Now look twice.\"\n"),
              HasSubstr("task.blocks"));
}

TEST_F(ConditionTasks, InAnotherLanguageEachConditionAsksInItsWords) {
  std::string tables = three_tasks;
  const std::string seen = "name = \"seen\"\n";
  tables.insert(tables.find(seen) + seen.size(), "instructions = \"Say what you see.\"\n");
  const StudyDefinition study =
      set_with(tables + "[[language]]\ntag = \"de\"\ntexts = \"builtin:de\"\n").study;
  const StudyTexts german = read_study_texts(study, study.languages->languages.front());
  const StudyDefinition read = in_language(study, german);
  const auto asked = [&](const std::string& condition) {
    return asked_texts(read, task_of(read, condition).get());
  };
  EXPECT_THAT(asked("object").question, HasSubstr("drei Objekte"));
  EXPECT_THAT(asked("object").hint, HasSubstr("drücken Sie"));
  EXPECT_EQ(task_of(read, "seen")->answers, (std::vector<std::string>{"Ja", "Nein"}));
  EXPECT_THAT(asked("seen").hint, HasSubstr("drücken Sie 1 oder 2"));
  EXPECT_EQ(asked("seen").question, "Is anything wrong here?");  // the study's own words
  const std::vector<std::string> missing = missing_texts(study, german);
  for (const char* key :
       {"condition.seen.question", "condition.seen.instructions", "condition.interval.hint"})
    EXPECT_THAT(missing, testing::Contains(key));  // three pictures: no draft says so
  EXPECT_THAT(missing, testing::Not(testing::Contains("condition.seen.answers")));
  const std::string printed = texts_to_translate(study, german);
  EXPECT_THAT(printed, HasSubstr("[[condition]]\nname = \"seen\"\n# to translate\ninstructions = \"Say what "
                                 "you see.\"\n# to translate\nquestion = \"Is anything wrong here?\"\n"));
}

TEST_F(ConditionTasks, ConditionsStandInBlocksAndCatchTrialsAskWhatStandsAroundThem) {
  const RenderedSet set = set_with(three_tasks);
  const TrialRules rules = make_trial_rules(set);
  std::set<std::string> first;
  for (int slot = 0; slot < 6; ++slot) {
    const std::vector<Trial> trials = decided_trials(rules, slot, {});
    ASSERT_EQ(trials.size(), 24U * 4 + 12);  // the interval twice
    std::vector<std::string> blocks;
    for (const Trial& trial : trials) {
      const std::string& condition = rules.stimuli[static_cast<std::size_t>(trial.stimulus)].condition;
      if (blocks.empty() || blocks.back() != condition) blocks.push_back(condition);
      const int alternatives = rules.task_of(trial).alternatives;
      EXPECT_LE(trial.right_index, alternatives);
      if (condition == "seen") {
        EXPECT_EQ(trial.right_index, trial.kind == TrialKind::reference ? 2 : 1);
      }
      if (condition == "object") {
        EXPECT_EQ(trial.right_index, 0);
      }
    }
    EXPECT_EQ(blocks.size(), 3U) << "slot " << slot;
    first.insert(blocks.front());
    EXPECT_EQ(trials, decided_trials(rules, slot, trials));
  }
  EXPECT_EQ(first.size(), 3U);  // of a Latin square
}

TEST_F(ConditionTasks, PracticeAsksEveryQuestion) {
  const RenderedSet set = set_with(std::string(three_tasks) + "[training]\ntrials = 6\n");
  std::map<std::string, int> practised;
  for (const Trial& trial : make_visit_script(set).training)
    ++practised[set.manifest.stimuli[static_cast<std::size_t>(trial.stimulus)].stimulus.condition];
  EXPECT_EQ(practised, (std::map<std::string, int>{{"interval", 2}, {"object", 2}, {"seen", 2}}));
}

TEST_F(ConditionTasks, WhoSeesNothingIsRightByTheChanceOfTheCondition) {
  const RenderedSet set = set_with(three_tasks);
  const LogContents seen = simulate(set, ObserverKind::perfect, 2);
  for (const Answer& answer : seen.answers) EXPECT_TRUE(answer.correct()) << answer.condition;
  const LogContents log = simulate(set, ObserverKind::guesser, 60);
  ASSERT_EQ(log.own_tasks.size(), 2U);
  EXPECT_EQ(facts_of(task_of(log, "interval").get()).alternatives, 3);
  std::map<std::string, std::pair<int, int>> right;
  for (const Answer& answer : log.answers) {
    right[answer.condition].first += answer.correct() ? 1 : 0;
    ++right[answer.condition].second;
  }
  for (const auto& [condition, chance] : std::map<std::string, double>{
           {"object", 1.0 / 3}, {"interval", 1.0 / 3}, {"seen", simulated_false_alarms}}) {
    const auto [correct, all] = right.at(condition);
    EXPECT_NEAR(static_cast<double>(correct) / all, chance, 4 * std::sqrt(chance * (1 - chance) / all))
        << condition;
  }
  int references = 0, yes = 0;
  for (const CatchTrialAnswer& answer : log.catches)
    if (answer.condition == "seen" && answer.kind == TrialKind::reference) {
      ++references;
      yes += answer.chosen_index == 1 ? 1 : 0;
    }
  ASSERT_GT(references, 60);
  EXPECT_NEAR(static_cast<double>(yes) / references, simulated_false_alarms,
              4 * std::sqrt(simulated_false_alarms * (1 - simulated_false_alarms) / references));
}

}  // namespace
}  // namespace seamline::study
