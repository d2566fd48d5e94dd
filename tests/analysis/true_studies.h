#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/interval.h"
#include "analysis/thresholds/closed_estimates.h"
#include "analysis/thresholds/guess_correction.h"
#include "analysis/thresholds/thresholds.h"
#include "tests/analysis/threshold_people.h"
#include "tests/analysis/true_people.h"

namespace seamline::test {

/// A study answered by people of whom the truth is known: the paper's four artifacts with three objects each.
struct TrueStudy {
  std::vector<int> width_px;                   ///< rising
  std::vector<std::vector<TrueTrial>> people;  ///< all trials of each
};

/// Its first `count` people.
inline TrueStudy first_people(const TrueStudy& study, int count) {
  return {.width_px = study.width_px, .people = {study.people.begin(), study.people.begin() + count}};
}

/// What one way of analysis says of one threshold.
struct TrueReading {
  double point_x = 0;  ///< infinite where the curve does not cross; NaN where there is none
  LevelInterval ci95 = {};
  LevelInterval simultaneous = {};  ///< over the four curves; open where the way has none
};

/// Of the four curves: PT, SN and both corrected for guessing, as in `true_crossings_x`.
using TrueReadings = std::array<std::array<TrueReading, 4>, true_curves>;

/// The means over objects of each person, as `average_answers` makes them of a log.
inline NoticeabilityData noticeability_of(const TrueStudy& study) {
  NoticeabilityData data{.axis = {}, .conditions = {""}, .artifacts = {}, .objects = {}};
  const auto people = static_cast<Eigen::Index>(study.people.size());
  const auto levels = static_cast<Eigen::Index>(study.width_px.size());
  for (const Artifact artifact : paper_artifacts) {
    ArtifactScores scores;
    scores.artifact = artifact;
    scores.level.assign(study.width_px.begin(), study.width_px.end());
    scores.noticeability = Eigen::MatrixXd::Zero(people, levels);
    data.artifacts.push_back(scores);
  }
  for (Eigen::Index p = 0; p < people; ++p)
    for (const TrueTrial& trial : study.people[static_cast<std::size_t>(p)])
      data.artifacts[static_cast<std::size_t>(trial.curve)].noticeability(p, trial.level) +=
          static_cast<double>(trial.score()) / true_objects;
  for (ArtifactScores& scores : data.artifacts) {
    for (Eigen::Index p = 0; p < people; ++p) scores.people.push_back("p" + std::to_string(p));
    for (Eigen::Index w = 0; w < levels; ++w) {
      const Eigen::VectorXd column = scores.noticeability.col(w);
      scores.cells.push_back(mean_over_participants({column.begin(), column.end()}));
      scores.cells.back().level = study.width_px[static_cast<std::size_t>(w)];
    }
  }
  return data;
}

/// How often each answer was given, as `count_guess_trials` counts a log.
inline GuessTrials guess_trials_of(const TrueStudy& study) {
  GuessTrials trials;
  for (const Artifact artifact : paper_artifacts)
    for (const int width_px : study.width_px)
      trials.cells.push_back({.artifact = artifact, .condition = "", .level = static_cast<double>(width_px)});
  const auto people = static_cast<Eigen::Index>(study.people.size());
  trials.answers =
      Eigen::MatrixXd::Zero(people, static_cast<Eigen::Index>(trials.cells.size()) * CellShape{}.of_cell());
  trials.references = Eigen::MatrixXd::Zero(people, CellShape{}.of_trial());
  for (Eigen::Index p = 0; p < people; ++p) {
    trials.people.push_back("p" + std::to_string(p));
    for (const TrueTrial& trial : study.people[static_cast<std::size_t>(p)]) {
      const std::size_t cell = static_cast<std::size_t>(trial.curve) * study.width_px.size() +
                               static_cast<std::size_t>(trial.level);
      trials.answers(p, static_cast<Eigen::Index>(cell) * CellShape{}.of_cell() +
                            CellShape{}.place(trial.object + 1, trial.chosen + 1, trial.rating)) += 1;
    }
  }
  return trials;
}

/// The same answers as a log holds them.
inline std::vector<Answer> answers_of(const TrueStudy& study) {
  std::vector<Answer> answers;
  for (std::size_t p = 0; p < study.people.size(); ++p)
    for (const TrueTrial& trial : study.people[p]) {
      answers.push_back(answer("p" + std::to_string(p), study.width_px[static_cast<std::size_t>(trial.level)],
                               trial.object + 1, trial.chosen + 1, trial.rating));
      answers.back().artifact = paper_artifacts[static_cast<std::size_t>(trial.curve)];
      answers.back().scene = "scene-" + std::string(word(answers.back().artifact));
    }
  return answers;
}

/// The isotonic reading of one level, as `estimate_thresholds` has it (without what is read off a logistic,
/// which takes nine tenths of its time).
inline TrueReading read_level(double level, const std::vector<double>& level_x,
                              const ArtifactScores& scores) {
  const MeanVector means = mean_and_covariance(scores.noticeability);
  const std::vector<double> mean(means.mean.begin(), means.mean.end());
  const double x = largest_x_at(level, level_x, fit_non_increasing(mean).value);
  ThresholdEstimate estimate{.level_x = x, .reason = {}, .ci95 = {}};
  estimate.ci95 = level_interval(level, level_x, means, means.fewest);
  keep_closed(estimate, {.low_x = x, .high_x = x}, scores.axis);
  return {.point_x = x, .ci95 = estimate.ci95};
}

/// The paper's way: thresholds read off straight lines between the widths tested, intervals by the score
/// tests of documentation/evidence/coverage.md.
inline TrueReadings read_by_lines(const TrueStudy& study) {
  const std::vector<double> level_x = log2_widths(study.width_px);
  const NoticeabilityData data = noticeability_of(study);
  const GuessCorrection corrected = correct_for_guessing(guess_trials_of(study), data, {.replicates = 0});
  TrueReadings readings;
  for (std::size_t c = 0; c < readings.size(); ++c) {
    const CurveThresholds& without_guesses = corrected.curves[c].estimates;
    const auto reading = [&](double level, const ThresholdEstimate& estimate) {
      return TrueReading{.point_x = largest_x_at(level, level_x, without_guesses.isotonic.value),
                         .ci95 = estimate.ci95};
    };
    readings[c] = {read_level(perceptual_level, level_x, data.artifacts[c]),
                   read_level(slight_level, level_x, data.artifacts[c]),
                   reading(perceptual_level, without_guesses.perceptual),
                   reading(slight_level, without_guesses.slightly_noticeable)};
  }
  return readings;
}

}  // namespace seamline::test
