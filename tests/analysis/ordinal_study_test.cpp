// The paper's study as an ordinal mixed model: what was planted is concluded, and nothing else.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/log_analysis/report_numbers.h"
#include "support/text/error.h"
#include "tests/analysis/ordinal_study_people.h"

namespace seamline::analysis {
using namespace study;
namespace {

using test::simulate_answers;
using test::simulated_groups;
using test::StudyPopulation;
using ::testing::Contains;
using ::testing::HasSubstr;

const ContrastRow& row_named(const OrdinalStudy& study, const std::string& name) {
  for (const ContrastTable& table : study.contrasts)
    for (const ContrastRow& row : table.rows)
      if (row.name == name) return row;
  throw std::runtime_error("no contrast " + name);
}

TEST(OrdinalStudy, ConcludesWhatWasPlanted) {
  StudyPopulation population;
  population.level = {{Artifact::occlusion, 1.5}, {Artifact::shadow, 0.1}};
  population.slope = {{Artifact::overlap, -1.4}};
  population.object = {{1, -0.6}, {2, 0.0}, {3, 0.6}};
  population.group = -1.5;
  const OrdinalStudy study = fit_ordinal_study(simulate_answers(population, 24, 2), simulated_groups(24), {});
  ASSERT_EQ(study.fit.verdict, OrdinalVerdict::estimated) << study.fit.explanation;
  EXPECT_EQ(study.errors, ErrorSource::participants);
  EXPECT_TRUE(study.notes.empty()) << study.notes.front();
  EXPECT_EQ(study.design.reference_level, 512);
  EXPECT_EQ(study.fit.observations, 24 * 84);
  EXPECT_EQ(study.coefficients.size(), 4u + 3 + 4 + 8 + 1 + 1);
  ASSERT_EQ(study.contrasts.size(), 5u);
  EXPECT_EQ(study.contrasts[1].rows.size(), 6u);
  EXPECT_EQ(study.contrasts[1].joint_contrasts, 3);
  EXPECT_EQ(study.contrasts[3].rows.size(), 12u);
  EXPECT_EQ(study.contrasts[4].degrees_of_freedom, 22);

  const ContrastRow& occlusion = row_named(study, "occlusion - receiver at 512 px");
  EXPECT_THAT(occlusion.conclusion,
              HasSubstr("occlusion is noticed more than receiver at 512 px (odds ratio"));
  EXPECT_THAT(occlusion.conclusion, HasSubstr("adjusted p < 0.001"));
  EXPECT_LT(occlusion.ci95_low, 1.5);
  EXPECT_GT(occlusion.ci95_high, 1.5);
  EXPECT_EQ(row_named(study, "shadow - receiver at 512 px").verdict, ContrastVerdict::not_shown);
  EXPECT_THAT(row_named(study, "overlap - receiver, per octave of width").conclusion,
              HasSubstr("overlap falls more steeply with width than receiver"));
  EXPECT_EQ(row_named(study, "shadow - receiver, per octave of width").verdict, ContrastVerdict::not_shown);
  EXPECT_THAT(row_named(study, "receiver, per octave of width").conclusion, HasSubstr("noticed less"));
  const ContrastRow& objects = row_named(study, "receiver: object3 - object1");
  EXPECT_EQ(objects.verdict, ContrastVerdict::differs);
  EXPECT_LT(objects.ci95_low, 1.2);
  EXPECT_GT(objects.ci95_high, 1.2);
  const ContrastRow& group = row_named(study, "technical - other");
  EXPECT_THAT(group.conclusion, HasSubstr("Group 'technical' notices artifacts more than 'other'"));

  const std::string text = text_of(study);
  EXPECT_THAT(text, HasSubstr("| occlusion - receiver at 512 px"));
  EXPECT_THAT(text, HasSubstr("Correction: single-step (multivariate t)."));
  EXPECT_THAT(text, HasSubstr("SD of participants"));
}

/// 26 conditions of four artifacts, more than one model holds; in one of them everything is noticed more.
std::vector<Answer> answers_of_many_conditions(int people) {
  std::vector<Answer> answers;
  for (int c = 0; c < 26; ++c) {
    StudyPopulation population;
    if (c == 7)
      for (const Artifact artifact : paper_artifacts) population.level[artifact] = 3.5;
    for (Answer& answer : simulate_answers(population, people, static_cast<std::uint64_t>(40 + c)))
      if (answer.level == 64 || answer.level == 512 || answer.level == 4096) {
        answer.condition = fmt::format("c{:02}", c);
        answers.push_back(std::move(answer));
      }
  }
  return answers;
}

TEST(OrdinalStudy, ManyConditionsAreComparedInPairsAndAdjustedTogether) {
  const std::vector<Answer> answers = answers_of_many_conditions(12);
  const OrdinalStudy study = fit_ordinal_study(answers, {}, {});
  ASSERT_EQ(study.fit.verdict, OrdinalVerdict::estimated) << study.fit.explanation;
  EXPECT_THAT(study.notes, Contains(HasSubstr("The study has 104 artifacts in conditions")));
  EXPECT_EQ(study.fit.observations, static_cast<int>(answers.size()));  // artifacts: of all conditions
  ASSERT_EQ(study.contrasts.size(), 6u);
  const ContrastTable &levels = study.contrasts[4], &slopes = study.contrasts[5];
  EXPECT_EQ(levels.question, "Do conditions differ within an artifact, at 512 px?");
  ASSERT_EQ(levels.rows.size(), 100u);
  ASSERT_EQ(slopes.rows.size(), 100u);
  for (const ContrastRow& row : levels.rows)
    EXPECT_EQ(row.verdict == ContrastVerdict::differs, row.name.find("(c07)") != std::string::npos)
        << row.name << " " << row.estimate << " " << row.adjusted_p;

  // Each pair is what the study's own model says of these two conditions alone.
  std::vector<Answer> two;
  for (const Answer& answer : answers)
    if (answer.condition == "c00" || answer.condition == "c07") two.push_back(answer);
  const OrdinalStudy of_two = fit_ordinal_study(two, {}, {});
  for (const char* name :
       {"receiver (c07) - receiver (c00) at 512 px", "overlap (c07) - overlap (c00), per octave of width"}) {
    EXPECT_EQ(row_named(of_two, name).estimate, row_named(study, name).estimate);
    EXPECT_EQ(row_named(of_two, name).standard_error, row_named(study, name).standard_error);
    EXPECT_EQ(row_named(of_two, name).p, row_named(study, name).p);
    EXPECT_GE(row_named(study, name).adjusted_p, row_named(study, name).p);
  }
}

TEST(OrdinalStudy, ManyConditionsGiveTheSameBitsForAnyNumberOfThreads) {
  const std::vector<Answer> answers = answers_of_many_conditions(4);
  OrdinalStudyRequest one, three;
  one.fit.threads = 1;
  three.fit.threads = 3;
  EXPECT_EQ(text_of(fit_ordinal_study(answers, {}, one)), text_of(fit_ordinal_study(answers, {}, three)));
}

TEST(OrdinalStudy, ContrastsDoNotDependOnTheReferenceOrOnTheFirstArtifact) {
  StudyPopulation population;
  population.slope = {{Artifact::overlap, -1.4}};
  const std::vector<Answer> answers = simulate_answers(population, 12, 5);
  const OrdinalStudy at512 = fit_ordinal_study(answers, {}, {});
  const OrdinalStudy at64 = fit_ordinal_study(answers, {}, {.reference_level = 64});
  EXPECT_NEAR(at64.fit.log_likelihood, at512.fit.log_likelihood, 1e-6);
  const double slope = row_named(at512, "overlap - shadow, per octave of width").estimate;
  EXPECT_NEAR(row_named(at64, "overlap - shadow, per octave of width").estimate, slope, 1e-5);
  EXPECT_NEAR(row_named(at64, "overlap - shadow at 64 px").estimate,
              row_named(at512, "overlap - shadow at 512 px").estimate - 3 * slope, 1e-5);
  // Swapping the names of the first two artifacts swaps the sign of their difference.
  std::vector<Answer> swapped = answers;
  for (Answer& answer : swapped)
    if (answer.artifact == Artifact::receiver)
      answer.artifact = Artifact::shadow;
    else if (answer.artifact == Artifact::shadow)
      answer.artifact = Artifact::receiver;
  const OrdinalStudy other = fit_ordinal_study(swapped, {}, {});
  const ContrastRow& mine = row_named(at512, "shadow - receiver at 512 px");
  const ContrastRow& theirs = row_named(other, "shadow - receiver at 512 px");
  EXPECT_NEAR(mine.estimate, -theirs.estimate, 1e-6);
  EXPECT_NEAR(mine.standard_error, theirs.standard_error, 1e-6);
}

TEST(OrdinalStudy, GroupsAreSkippedWithAReason) {
  const std::vector<Answer> answers = simulate_answers({}, 8, 3);
  ParticipantGroups groups = simulated_groups(8);
  groups.erase("p7");
  EXPECT_THAT(fit_ordinal_study(answers, groups, {}).notes,
              Contains("Groups are not compared: 1 of 8 participants have none."));
  for (auto& [code, group] : groups = simulated_groups(8)) group = "technical";
  EXPECT_THAT(fit_ordinal_study(answers, groups, {}).notes,
              Contains("Groups are not compared: all participants are 'technical'."));
  groups["p0"] = "other";
  const OrdinalStudy study = fit_ordinal_study(answers, groups, {});
  EXPECT_THAT(study.notes, Contains("Groups are not compared: 'other' has one participant."));
  EXPECT_EQ(study.contrasts.size(), 4u);
}

TEST(OrdinalStudy, DegenerateLogsHaveVerdictsAndNoContrasts) {
  const auto expect = [](const std::vector<Answer>& answers, OrdinalVerdict verdict) {
    const OrdinalStudy study = fit_ordinal_study(answers, {}, {});
    EXPECT_EQ(word(study.fit.verdict), word(verdict));
    EXPECT_TRUE(study.contrasts.empty());
    EXPECT_TRUE(study.coefficients.empty());
    ASSERT_FALSE(study.notes.empty());
    EXPECT_THAT(text_of(study), HasSubstr(study.fit.explanation));
  };
  const std::vector<Answer> answers = simulate_answers({}, 10, 4);
  expect({answers.begin(), answers.begin() + 84}, OrdinalVerdict::one_participant);
  std::vector<Answer> changed = answers;
  for (Answer& answer : changed) {
    answer.chosen_index = answer.object_index;
    answer.rating = 4;
  }
  expect(changed, OrdinalVerdict::constant_scores);
  changed = answers;
  for (Answer& answer : changed)
    if (answer.artifact == Artifact::shadow) {
      answer.chosen_index = answer.object_index;
      answer.rating = 4;
    }
  expect(changed, OrdinalVerdict::separated);
  changed.clear();
  for (const Answer& answer : answers)
    if (answer.artifact != Artifact::overlap || answer.depth_width_px == 256) changed.push_back(answer);
  expect(changed, OrdinalVerdict::singular_design);
  EXPECT_THROW((void)fit_ordinal_study({}, {}, {}), InputError);
}

TEST(OrdinalStudy, SmallStudiesAreFitted) {
  std::vector<Answer> answers;
  for (const Answer& answer : simulate_answers({}, 10, 4))
    if (answer.artifact == Artifact::receiver && answer.object_index == 1 && answer.depth_width_px == 512)
      answers.push_back(answer);
  OrdinalStudy study = fit_ordinal_study(answers, {}, {});  // one image: only cuts are left
  EXPECT_THAT(study.notes, Contains("Only 512 px was tested: there are no slopes over width."));
  EXPECT_TRUE(study.contrasts.empty());
  answers.clear();
  for (const Answer& answer : simulate_answers({}, 10, 4))
    if (answer.artifact == Artifact::receiver) answers.push_back(answer);
  study = fit_ordinal_study(answers, {}, {});
  ASSERT_TRUE(has_estimates(study.fit.verdict));
  EXPECT_EQ(study.contrasts.size(), 2u);  // width, objects
}

TEST(OrdinalStudy, ObjectsOfOneNameAreToldApart) {
  std::vector<Answer> answers = simulate_answers({}, 6, 8);
  for (Answer& answer : answers) answer.object = "teapot";
  const StudyDesign design = study_design(answers, {}, 0);
  EXPECT_EQ(design.artifacts.front().objects,
            (std::vector<std::string>{"teapot (left)", "teapot (middle)", "teapot (right)"}));
}

TEST(OrdinalStudy, OfALogUsesTheUsedParticipantsOnly) {
  LogContents log = test::simulate_log(12, 3);
  log.participants[2].excluded = true;
  const Analysis analysis = analyze(log, false, {.replicates = 50});
  EXPECT_EQ(used_answers(analysis.log, analysis.people).size(), 11u * 84);
  const OrdinalStudy study = ordinal_study(analysis, {}, {});
  EXPECT_EQ(study.fit.participants, 11);
  ASSERT_TRUE(has_estimates(study.fit.verdict)) << study.fit.explanation;
  for (const ContrastRow& row : study.contrasts.front().rows)
    EXPECT_THAT(row.conclusion, HasSubstr("noticed less with every doubling"));
}

TEST(OrdinalStudy, SameBitsForAnyNumberOfThreads) {
  const std::vector<Answer> answers = simulate_answers({}, 20, 6);
  const std::string one = text_of(fit_ordinal_study(answers, {}, {.fit = {.threads = 1}}));
  EXPECT_EQ(text_of(fit_ordinal_study(answers, {}, {.fit = {.threads = 2}})), one);
  EXPECT_EQ(text_of(fit_ordinal_study(answers, {}, {.fit = {.threads = 7}})), one);
}

}  // namespace
}  // namespace seamline::analysis
