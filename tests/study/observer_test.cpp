#include "study/observers/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/text/error.h"

namespace seamline::study {
namespace {

Stimulus stimulus_of(Artifact artifact, int width_px, int object_index = 2) {
  return {.scene = "room",
          .artifact = artifact,
          .object = "thing",
          .object_index = object_index,
          .level = 1.0 * width_px,
          .depth = {.width_px = width_px}};
}

int score(const Stimulus& stimulus, const Response& response) {
  return response.chosen_index == stimulus.object_index ? response.rating : 0;
}

struct Mean {
  double value = 0, standard_error = 0;
};

/// Mean score of many people of a kind, one answer each.
Mean mean_score(ObserverKind kind, const ObserverDefinition& definition, const Stimulus& stimulus,
                int people) {
  double sum = 0, squares = 0;
  for (int person = 0; person < people; ++person) {
    Random random(77, static_cast<std::uint64_t>(person));
    const Observer observer = make_observer(kind, definition, random);
    const double value = score(stimulus, respond(observer, stimulus, random));
    sum += value;
    squares += value * value;
  }
  const double mean = sum / people;
  return {mean, std::sqrt((squares / people - mean * mean) / people)};
}

/// The mean over people by brute force: Simpson's rule on a fine grid over +-9 sd, in the plain words of the
/// definition.
double noticeability_by_simpson(const ObserverDefinition& definition, Artifact artifact, double width_px) {
  const double midpoint = definition.midpoint.at(artifact), sd = definition.people_sd_octaves;
  constexpr int intervals = 100000;
  const double step = 18.0 / intervals;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double z = -9 + i * step;
    const double seen =
        1 / (1 + std::exp((std::log2(width_px) - std::log2(midpoint) - z * sd) / definition.scale_octaves));
    const double value = std::exp(-z * z / 2) * (seen * (1 + 3 * seen) + (1 - seen) / 3);
    sum += value * (i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2);
  }
  return sum * step / 3 / std::sqrt(2 * std::acos(-1.0));
}

TEST(Observer, KindsHaveWords) {
  for (const ObserverKind kind : every_observer_kind) EXPECT_EQ(observer_kind_from_word(word(kind)), kind);
  EXPECT_EQ(observer_kind_from_word("picture"), std::nullopt);
}

TEST(Observer, PerfectIsAlwaysRightAndRates4) {
  Random random(1);
  for (int object = 1; object <= 3; ++object) {
    const Response response = respond(PerfectObserver{}, stimulus_of(Artifact::none, 4096, object), random);
    EXPECT_EQ(response.chosen_index, object);
    EXPECT_EQ(response.rating, 4);
  }
}

TEST(Observer, GuesserChoosesUniformlyAndRates1) {
  Random random(2);
  int counts[4] = {};
  constexpr int draws = 90000;
  for (int draw = 0; draw < draws; ++draw) {
    const Response response = respond(GuessingObserver{}, stimulus_of(Artifact::receiver, 64), random);
    EXPECT_EQ(response.rating, 1);
    ++counts[response.chosen_index];
  }
  for (int object = 1; object <= 3; ++object)
    EXPECT_NEAR(counts[object], draws / 3.0, 4 * std::sqrt(draws * 2.0 / 9));
}

TEST(Observer, ThresholdMeansAreTheExpectedNoticeability) {
  const ObserverDefinition definition;
  for (const Artifact artifact : paper_artifacts)
    for (const int width_px : {64, 256, 1024, 4096}) {
      const Mean mean =
          mean_score(ObserverKind::threshold, definition, stimulus_of(artifact, width_px), 40000);
      EXPECT_NEAR(mean.value, expected_noticeability(definition, artifact, width_px), 4 * mean.standard_error)
          << word(artifact) << " " << width_px;
    }
}

/// Who notices more as maps grow finer is the mirror image, about the midpoint, of who notices less.
TEST(Observer, NoticeabilityMayRise) {
  const ObserverDefinition falling;
  ObserverDefinition rising;
  rising.direction = Direction::increasing;
  for (const Artifact artifact : paper_artifacts)
    for (const int width_px : {64, 256, 1024, 4096}) {
      const double midpoint = falling.midpoint.at(artifact);
      const double expected = expected_noticeability(rising, artifact, width_px);
      EXPECT_NEAR(expected, expected_noticeability(falling, artifact, midpoint * midpoint / width_px), 1e-12);
      const Mean mean = mean_score(ObserverKind::threshold, rising, stimulus_of(artifact, width_px), 20000);
      EXPECT_NEAR(mean.value, expected, 4 * mean.standard_error) << word(artifact) << " " << width_px;
    }
}

TEST(Observer, ExpectedNoticeabilityIsAccurateTo1e9) {
  for (const double scale : {0.01, 0.1, 0.5, 2.0, 20.0})
    for (const double sd : {0.05, 0.5, 0.5001, 3.0})
      for (const double width_px : {64.0, 290.0, 300.0, 1000.0}) {
        ObserverDefinition definition;
        definition.scale_octaves = scale;
        definition.people_sd_octaves = sd;
        EXPECT_NEAR(expected_noticeability(definition, Artifact::receiver, width_px),
                    noticeability_by_simpson(definition, Artifact::receiver, width_px), 1e-9)
            << scale << " " << sd << " " << width_px;
      }
}

TEST(Observer, ExpectedNoticeabilityAtItsLimits) {
  ObserverDefinition definition;
  const double far = 1e9;
  EXPECT_NEAR(expected_noticeability(definition, Artifact::receiver, 1 / far), 4, 1e-9);
  EXPECT_NEAR(expected_noticeability(definition, Artifact::receiver, far), 1.0 / 3, 1e-9);
  definition.people_sd_octaves = 0;  // everyone alike: P = 1/2 at the midpoint
  EXPECT_NEAR(expected_noticeability(definition, Artifact::receiver, 300), 0.5 * 2.5 + 0.5 / 3, 1e-12);
  definition.people_sd_octaves = 1e-6;
  EXPECT_NEAR(expected_noticeability(definition, Artifact::receiver, 300), 0.5 * 2.5 + 0.5 / 3, 1e-9);
  definition.people_sd_octaves = 0.5;  // a step: half of the people see it for certain, the others not at all
  definition.scale_octaves = 1e-6;
  EXPECT_NEAR(expected_noticeability(definition, Artifact::receiver, 300), 0.5 * 4 + 0.5 / 3, 1e-5);
}

TEST(Observer, PeopleDifferByTheStatedSd) {
  const ObserverDefinition definition{.people_sd_octaves = 0.8};
  double sum = 0, squares = 0;
  constexpr int people = 20000;
  for (int person = 0; person < people; ++person) {
    Random random(3, static_cast<std::uint64_t>(person));
    const Observer observer = make_observer(ObserverKind::threshold, definition, random);
    const double shift = std::get<ThresholdObserver>(observer).shift_octaves;
    sum += shift;
    squares += shift * shift;
  }
  EXPECT_NEAR(sum / people, 0, 4 * 0.8 / std::sqrt(people));
  EXPECT_NEAR(std::sqrt(squares / people), 0.8, 4 * 0.8 / std::sqrt(2.0 * people));
}

TEST(Observer, AnArtifactWithoutAMidpointIsWrongInput) {
  ObserverDefinition definition;
  definition.midpoint.erase(Artifact::shadow);
  EXPECT_THROW((void)expected_noticeability(definition, Artifact::shadow, 64), InputError);
}

}  // namespace
}  // namespace seamline::study
