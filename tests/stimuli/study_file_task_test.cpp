// `[task]` of a study file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/core.h>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "stimuli/definition/parts/staircase_definition.h"
#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/study_file/parts/study_file_task.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"
#include "tests/complaint.h"
#include "tests/stimuli/study_of_no_files.h"

namespace seamline {
namespace {

using testing::HasSubstr;

StudyDefinition study_with_task(const std::string& tables, const std::string& top = "") {
  return read_study_text(test::study_of_no_files(top, tables), "study.toml");
}

std::string complaint_of_task(const std::string& tables, const std::string& top = "") {
  return test::complaint_of([&] { (void)study_with_task(tables, top); });
}

TEST(StudyFileTask, AStudyThatNamesNoneAsksForOneOfThreeObjects) {
  const StudyDefinition study = study_with_task("");
  EXPECT_EQ(study.task, nullptr);
  const TaskFacts facts = facts_of(study.task.get());
  EXPECT_EQ(facts.alternatives, 3);
  EXPECT_EQ(facts.chance, 1.0 / 3);
  EXPECT_TRUE(facts.chooses && facts.rates && !facts.draws_right);
  EXPECT_THAT(canonical_text(study), testing::Not(HasSubstr("task")));
}

TEST(StudyFileTask, ChanceFollowsFromTheAlternatives) {
  for (const auto& [tables, chance] : std::vector<std::pair<std::string, double>>{
           {"[task]\nkind = \"pair\"\n", 0.5},
           {"[task]\nkind = \"interval\"\n", 0.5},
           {"[task]\nkind = \"interval\"\npictures = 3\n", 1.0 / 3}}) {
    const TaskFacts facts = facts_of(study_with_task(tables).task.get());
    EXPECT_EQ(facts.chance, chance) << tables;
    EXPECT_EQ(facts.chance * facts.alternatives, 1) << tables;
    EXPECT_TRUE(facts.draws_right);
    EXPECT_FALSE(facts.rates);
  }
}

TEST(StudyFileTask, EveryKeyIsPartOfTheHash) {
  std::set<std::string> hashes;
  std::vector<std::string> tasks = {"",
                                    "[task]\nkind = \"object\"\nrepetitions = 2\n",
                                    "[task]\nkind = \"pair\"\n",
                                    "[task]\nkind = \"pair\"\nsecond_question = true\n",
                                    "[task]\nkind = \"pair\"\nexposure_s = 1\n",
                                    "[task]\nkind = \"interval\"\n",
                                    "[task]\nkind = \"interval\"\ngap_s = 1\n",
                                    "[task]\nkind = \"interval\"\npictures = 3\n"};
  tasks.insert(tasks.end(), {"[task]\nkind = \"interval\"\nmask = \"noise\"\n",
                             "[task]\nkind = \"interval\"\nmask = \"scrambled\"\n",
                             "[task]\nkind = \"interval\"\nmask = \"noise\"\nmask_s = 0.2\n",
                             "[task]\nkind = \"rating\"\n[catch]\nreference = 9\n",
                             "[task]\nkind = \"rating\"\nscale = \"slider\"\n[catch]\nreference = 9\n"});
  for (const std::string& task : tasks) hashes.insert(study_hash(study_with_task(task)));
  const std::vector<std::string> stairs = {"", "[staircase]\ndown = 3\n", "[staircase]\nup = 2\n",
                                           "[staircase]\nstart = [64]\n", "[staircase]\nby_object = true\n"};
  for (const std::string& staircase : stairs)
    hashes.insert(study_hash(study_with_task(staircase, "procedure = \"staircase\"")));
  EXPECT_EQ(hashes.size(), tasks.size() + stairs.size());
}

StudyDefinition study_of_objects(int objects, const std::string& task) {
  return read_study_text(test::study_of_no_files("", task, objects), "study.toml");
}

TEST(StudyFileTask, AmongSoManyObjectsOneIsChosen) {
  for (const auto& [objects, question, hint, last] :
       std::vector<std::tuple<int, std::string, std::string, std::string>>{
           {2, "Which of the two objects", "press 1 or 2", "on the right"},
           {5, "Which of the five objects", "press 1 to 5", "fifth from the left"},
           {8, "Which of the eight objects", "press 1 to 8", "eighth from the left"}}) {
    const StudyDefinition study =
        study_of_objects(objects, fmt::format("[task]\nkind = \"object\"\nobjects = {}\n", objects));
    const TaskFacts facts = facts_of(study.task.get());
    EXPECT_EQ(facts.alternatives, objects);
    EXPECT_EQ(objects_of(study), objects);
    EXPECT_EQ(facts.chance, 1.0 / objects);
    EXPECT_TRUE(facts.rates && facts.chooses && !facts.draws_right && !facts.is_papers());
    EXPECT_THAT(study.session.question, HasSubstr(question));
    EXPECT_THAT(phrase_text(study.texts, Phrase::choice_hint), HasSubstr(hint));
    ASSERT_EQ(study.task->answers.size(), static_cast<std::size_t>(objects));
    EXPECT_EQ(study.task->answers.back(), last);
    EXPECT_EQ(list_stimuli(study).size(), static_cast<std::size_t>(2 * objects));
    const std::string named =
        fmt::format("[task]\nkind = \"object\"\nobjects = {}\nrepetitions = 1\n", objects);
    EXPECT_EQ(study_hash(study), study_hash(study_of_objects(objects, named)));
  }
  // Three are the usual ones, said or not.
  const StudyDefinition three = study_of_objects(3, "[task]\nkind = \"object\"\nobjects = 3\n");
  EXPECT_TRUE(three.task->answers.empty() && facts_of(three.task.get()).is_papers());
  EXPECT_EQ(study_hash(three), study_hash(study_of_objects(3, "[task]\nkind = \"object\"\n")));
  EXPECT_EQ(three.session.question, SessionDefinition{}.question);
  EXPECT_EQ(
      study_of_objects(4, "[task]\nkind = \"object\"\nobjects = 4\nanswers = [\"a\", \"b\", \"c\", \"d\"]\n")
          .task->answers[2],
      "c");
}

TEST(StudyFileTask, OtherTasksMayHaveOneObjectAScene) {
  const StudyDefinition pair = study_of_objects(1, "[task]\nkind = \"pair\"\nobjects = 1\n");
  EXPECT_EQ(facts_of(pair.task.get()).alternatives, 2);
  EXPECT_EQ(objects_of(pair), 1);
  EXPECT_EQ(list_stimuli(pair).size(), 2U);
}

TEST(StudyFileTask, RefusesOtherNumbersOfObjects) {
  const auto complaint = [](int objects, const std::string& task) {
    return test::complaint_of([&] { (void)study_of_objects(objects, task); });
  };
  EXPECT_THAT(complaint(2, ""), HasSubstr("wanted three objects: left, middle, right, found 2"));
  EXPECT_THAT(complaint(3, "[task]\nkind = \"object\"\nobjects = 5\n"),
              HasSubstr("wanted 5, as [task] says (objects), from left to right, found 3"));
  EXPECT_THAT(complaint(1, "[task]\nkind = \"object\"\nobjects = 1\n"), HasSubstr("task.objects"));
  EXPECT_THAT(complaint(9, "[task]\nkind = \"object\"\nobjects = 9\n"), HasSubstr("task.objects"));
  EXPECT_THAT(complaint(2, "[task]\nkind = \"object\"\nobjects = 2\nanswers = [\"a\"]\n"),
              HasSubstr("task.answers"));
}

TEST(StudyFileTask, TheTextOfAStudySaysItsTaskAlone) {
  const std::string text = test::study_of_no_files("", "[task]\nkind = \"interval\"\nrepetitions = 7\n");
  const auto task = read_task_text(text, "a log");
  ASSERT_NE(task, nullptr);
  EXPECT_EQ(canonical_text(task.get()),
            canonical_text(study_with_task("[task]\nkind = \"interval\"\nrepetitions = 7\n").task.get()));
  EXPECT_EQ(read_task_text(test::study_of_no_files("", ""), "a log"), nullptr);
}

TEST(StudyFileTask, ASliderHasTwoOrFiveLabelsAndSaysHowItIsMoved) {
  const std::string slider = "[catch]\nreference = 9\n[task]\nkind = \"rating\"\nscale = \"slider\"\n";
  const StudyDefinition five = study_with_task(slider);
  EXPECT_TRUE(facts_of(five.task.get()).slides);
  EXPECT_EQ(five.task->labels, impairment_labels());
  EXPECT_THAT(phrase_text(five.texts, Phrase::rating_hint), HasSubstr("arrow keys"));
  EXPECT_EQ(study_with_task(slider + "labels = [\"none\", \"all\"]\n").task->labels.size(), 2U);
  EXPECT_THAT(complaint_of_task(slider + "labels = [\"a\", \"b\", \"c\"]\n"), HasSubstr("two or five"));
}

TEST(StudyFileTask, TheStudysOwnWordsStay) {
  EXPECT_THAT(study_with_task("[task]\nkind = \"pair\"\n").session.question, HasSubstr("two pictures"));
  EXPECT_EQ(study_with_task("[task]\nkind = \"pair\"\n[session]\nquestion = \"Which?\"\n").session.question,
            "Which?");
  EXPECT_EQ(study_with_task("[task]\nkind = \"object\"\n").session.question, SessionDefinition{}.question);
}

TEST(StudyFileTask, RefusesWhatTheTaskCannotGive) {
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"shout\"\n"), HasSubstr("\"interval\" or \"yes_no\""));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\n[clip]\nframes = 24\nframes_per_s = 24\n"),
              HasSubstr("clip"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\nblocks = \"condition\"\n"),
              HasSubstr("task.blocks"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\nblocks = \"day\"\n"), HasSubstr("task.blocks"));
  EXPECT_THAT(complaint_of_task("[task]\npictures = 2\n"), HasSubstr("task.kind"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\npictures = 2\n"), HasSubstr("task.pictures"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"object\"\nexposure_s = 1\n"), HasSubstr("task.exposure_s"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"interval\"\nexposure_s = 0\n"),
              HasSubstr("task.exposure_s"));
  EXPECT_THAT(
      complaint_of_task("[task]\nkind = \"yes_no\"\nsecond_question = false\n[catch]\nreference = 9\n"),
      HasSubstr("task.second_question"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"yes_no\"\n"), HasSubstr("catch.reference"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\nmask = \"noise\"\n"), HasSubstr("exposure_s = 0"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"interval\"\nmask = \"noise\"\nmask_s = 0.6\n"),
              HasSubstr("at most gap_s"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"interval\"\nmask_s = 0.1\n"), HasSubstr("task.mask_s"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"object\"\nmask = \"noise\"\n"), HasSubstr("task.mask"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\nscale = \"slider\"\n"), HasSubstr("task.scale"));
  EXPECT_THAT(
      complaint_of_task("[task]\nkind = \"rating\"\nlabels = [\"a\", \"b\"]\n[catch]\nreference = 9\n"),
      HasSubstr("task.labels"));
  EXPECT_THAT(
      complaint_of_task("[task]\nkind = \"pair\"\nrepetitions = 2\n[quest_plus]\nmax_shows_per_image = 1\n",
                        "procedure = \"quest_plus\""),
      HasSubstr("task.repetitions"));
  EXPECT_THAT(complaint_of_task("[task]\nkind = \"pair\"\n[quest_plus]\nmax_shows_per_image = 1\n"
                                "outcome = \"joint\"\n",
                                "procedure = \"quest_plus\""),
              HasSubstr("quest_plus.outcome"));
}

/// The same study with four levels.
std::string complaint_of_match(const std::string& tables, const std::string& top = "") {
  std::string text = test::study_of_no_files(top, tables);
  const std::string two = "[64, 4096]";
  text.replace(text.find(two), two.size(), "[64, 256, 1024, 4096]");
  return test::complaint_of([&] { (void)read_study_text(text, "study.toml"); });
}

TEST(StudyFileTask, AMatchRefusesWhatNeedsARightAnswer) {
  const std::string match = "[task]\nkind = \"match\"\n";
  EXPECT_EQ(complaint_of_match(match), "no complaint");
  EXPECT_EQ(complaint_of_match(match + "repetitions = 4\nanswers = [\"a\", \"b\", \"c\"]\n"), "no complaint");
  EXPECT_THAT(complaint_of_task(match), HasSubstr("at least 3 levels"));
  EXPECT_THAT(complaint_of_match(match + "[catch]\nattention = 2\n"), HasSubstr("catch"));
  EXPECT_THAT(complaint_of_match(match + "[training]\ntrials = 2\n"), HasSubstr("training"));
  EXPECT_THAT(complaint_of_match(match + "exposure_s = 1\n"), HasSubstr("task.exposure_s"));
  EXPECT_THAT(complaint_of_match(match + "second_question = true\n"), HasSubstr("task.second_question"));
  EXPECT_THAT(
      complaint_of_match(match + "[quest_plus]\nmax_shows_per_image = 1\n", "procedure = \"quest_plus\""),
      HasSubstr("procedure"));
  EXPECT_THAT(complaint_of_match(match, "procedure = \"staircase\""), HasSubstr("procedure"));
}

TEST(StudyFileTask, StaircasesStandBesideForcedChoices) {
  const auto stairs = [](const std::string& tables) {
    return study_with_task(tables, "procedure = \"staircase\"").task;
  };
  const auto of_object = stairs("");
  ASSERT_TRUE(of_object && of_object->staircase);
  EXPECT_EQ(of_object->kind, TaskKind::object);
  EXPECT_EQ(*of_object->staircase, StaircaseDefinition{});
  const auto of_pair = stairs("[task]\nkind = \"pair\"\n[staircase]\ndown = 3\nstart = [64, 4096]\n");
  EXPECT_EQ(of_pair->kind, TaskKind::pair);
  EXPECT_EQ(of_pair->staircase->down, 3);
  EXPECT_EQ(of_pair->staircase->start, (std::vector<double>{64, 4096}));
  const auto refused = [](const std::string& tables, const std::string& top = "procedure = \"staircase\"") {
    return complaint_of_task(tables, top);
  };
  EXPECT_THAT(refused("[staircase]\ndown = 3\n", ""), HasSubstr("procedure"));
  EXPECT_THAT(refused("[staircase]\nstart = [65]\n"), HasSubstr("staircase.start"));
  EXPECT_THAT(refused("[staircase]\ndown = 0\n"), HasSubstr("staircase.down"));
  EXPECT_THAT(refused("[task]\nkind = \"pair\"\nrepetitions = 2\n"), HasSubstr("task.repetitions"));
  EXPECT_THAT(refused("[catch]\nreference = 9\n[task]\nkind = \"yes_no\"\n"), HasSubstr("procedure"));
}

TEST(StudyFileTask, QuestPlusKnowsTheChanceOfTheTask) {
  const auto guess_of = [](const std::string& tables, const std::string& more = "") {
    const StudyDefinition study = study_with_task(tables + "[quest_plus]\nmax_shows_per_image = 9\n" + more,
                                                  "procedure = \"quest_plus\"");
    return std::get<QuestPlusDefinition>(study.procedure).guess;
  };
  EXPECT_EQ(guess_of("").least, 1.0 / 3);
  EXPECT_EQ(guess_of("[task]\nkind = \"pair\"\n").least, 0.5);
  EXPECT_EQ(guess_of("[task]\nkind = \"pair\"\n").count, 1);
  EXPECT_EQ(guess_of("[task]\nkind = \"interval\"\npictures = 3\n").most, 1.0 / 3);
  EXPECT_EQ(guess_of("[task]\nkind = \"pair\"\n", "guess = { least = 0.4, most = 0.4, count = 1 }\n").least,
            0.4);
  // Where only reference trials tell how often people see something where nothing is, it is learnt.
  EXPECT_GT(guess_of("[catch]\nreference = 9\n[task]\nkind = \"yes_no\"\n").count, 1);
}

}  // namespace
}  // namespace seamline
