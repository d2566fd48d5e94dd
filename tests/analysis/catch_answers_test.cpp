// Catch trials and pilot data from a log to the analysis.
#include "analysis/screening/catch_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/log_analysis/analysis.h"
#include "analysis/report/json/thresholds_json.h"
#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/running/simulation.h"
#include "support/text/error.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
using namespace study;
namespace {

using ::testing::HasSubstr;

/// How somebody answers: by the observer, as a person or a pilot would be in the log.
void take_part(LogWriter& log, const RenderedSet& set, const Enrolment& who, ObserverKind kind,
               std::uint64_t seed) {
  Random random(seed);
  const Observer observer = make_observer(kind, set.study.observer, random);
  OpenSession place = enter_session(log, who, 0);
  TrialSequence trials = open_trials(make_trial_rules(set), log, place);
  while (const std::optional<Trial> due = current_trial(trials)) {
    const Stimulus& stimulus = set.manifest.stimuli[static_cast<std::size_t>(due->stimulus)].stimulus;
    const Response response = due->kind == TrialKind::stimulus ? respond(observer, stimulus, random)
                              : due->kind == TrialKind::attention
                                  ? respond_to_attention(observer, stimulus.object_index, random)
                                  : respond_to_reference(random);
    const TrialAnswer answer{
        .trial_index = place.answered, .chosen_index = response.chosen_index, .rating = response.rating};
    log.append_answer(place, answer);
    trials = after_answer(std::move(trials), answer);
  }
  log.complete(place);
}

class CatchAnswersTest : public ::testing::Test {
 protected:
  TemporaryFolder folder;
  static Analysis analyzed(const std::filesystem::path& log, bool include_pilot = false) {
    return analyze(read_log(log), include_pilot, {.replicates = 50, .seed = 1});
  }
};

TEST_F(CatchAnswersTest, AttentionScreensAndReferencesEstimateGuessers) {
  const RenderedSet set = write_set_of_text(
      folder / "set", study_text("tiny", paper_widths_px) + "[catch]\nattention = 8\nreference = 6\n");
  {
    LogWriter log(folder / "log", set);
    log.transaction([&] {
      for (std::uint64_t i = 0; i < 12; ++i)
        take_part(log, set, {.code = "see" + std::to_string(i)}, ObserverKind::threshold, i + 1);
      for (std::uint64_t i = 0; i < 4; ++i)
        take_part(log, set, {.code = "guess" + std::to_string(i)}, ObserverKind::guesser, i + 100);
    });
  }
  const Analysis analysis = analyzed(folder / "log");
  EXPECT_EQ(analysis.options.references.size(), 16U * 6);
  EXPECT_EQ(analysis.options.catches.size(), 16U * 8);
  EXPECT_TRUE(analysis.screening.catch_trials);
  for (const ScreenedPerson& person : analysis.screening.people) {
    EXPECT_EQ(person.attention.shown, 8);
    EXPECT_EQ(person.attention.rejected, person.code.starts_with("guess")) << person.code;
  }
  for (const ArtifactScores& scores : analysis.data.artifacts)
    EXPECT_EQ(scores.level.size(), 7U);  // a catch trial is on no curve
  EXPECT_EQ(analysis.log.answers.size(), 16U * 84);
  const GuessTrials trials = count_guess_trials(analysis.log, analysis.data, analysis.options.references);
  EXPECT_EQ(trials.references.sum(), 16 * 6);
}

/// The thresholds, cells and every other number of the same log without its pilot participants.
TEST_F(CatchAnswersTest, PilotDataAreAnalysedOnlyWhenAskedFor) {
  const RenderedSet set = write_set_of_text(
      folder / "set", study_text("tiny", paper_widths_px) + "[catch]\nattention = 2\nreference = 2\n");
  const auto write = [&](const std::string& name, bool with_pilot) {
    LogWriter log(folder / name, set);
    log.transaction([&] {
      for (std::uint64_t i = 0; i < 6; ++i) {
        take_part(log, set, {.code = "p" + std::to_string(i)}, ObserverKind::threshold, i + 1);
        if (with_pilot)
          take_part(log, set, {.code = "t" + std::to_string(i), .pilot = true}, ObserverKind::guesser,
                    i + 50);
      }
    });
  };
  write("people", false);
  write("both", true);
  const Analysis people = analyzed(folder / "people");
  const Analysis both = analyzed(folder / "both");
  EXPECT_EQ(both.counts.used, 6);
  EXPECT_EQ(both.counts.pilot, 6);
  EXPECT_EQ(both.scores.people, people.scores.people);
  EXPECT_EQ(both.scores.score, people.scores.score);
  EXPECT_EQ(both.screening.people.size(), 6U);
  EXPECT_EQ(both.guessing.floor, people.guessing.floor);
  EXPECT_EQ(both.guessing.guessers.position, people.guessing.guessers.position);
  ASSERT_EQ(both.thresholds.size(), people.thresholds.size());
  const auto without_counts = [](const Analysis& analysis) {
    std::string json = thresholds_json(analysis);
    return json.substr(json.find("\"cells\""));
  };
  EXPECT_EQ(without_counts(both), without_counts(people));

  const Analysis included = analyzed(folder / "both", true);
  EXPECT_EQ(included.counts.used, 12);
  EXPECT_EQ(included.screening.people.size(), 12U);
  EXPECT_NE(without_counts(included), without_counts(people));
}

TEST_F(CatchAnswersTest, ALogOfPilotsAloneNeedsTheFlag) {
  const RenderedSet set = write_set(folder / "set", paper_widths_px);
  {
    LogWriter log(folder / "log", set);
    log.transaction([&] { take_part(log, set, {.code = "t1", .pilot = true}, ObserverKind::threshold, 1); });
  }
  try {
    (void)analyzed(folder / "log");
    FAIL() << "pilot data were used";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("include_pilot"));
  }
  EXPECT_EQ(analyzed(folder / "log", true).counts.used, 1);
}

}  // namespace
}  // namespace seamline::analysis
