#pragma once
#include <algorithm>
#include <string>

#include "analysis/joint/joint_contrasts.h"
#include "analysis/joint/joint_sharing.h"
#include "analysis/joint/joint_thresholds.h"
#include "tests/analysis/true_sentences.h"

namespace seamline::test {

inline JointData joint_data_of(const TrueStudy& study) {
  const GuessTrials trials = guess_trials_of(study);
  const Guessers guessers = estimate_guessers(trials.answers.colwise().sum().transpose(),
                                              trials.references.colwise().sum().transpose());
  return joint_data(trials, LevelAxis{}, guessers);
}

/// What a fit says. Where its curve does not cross, the point is infinite on that side.
inline TrueReadings readings_of(const JointFit& fit, const JointData& data, double last_x) {
  TrueReadings readings;
  for (auto& curve : readings)
    for (TrueReading& reading : curve) reading.point_x = NAN;
  if (!fit.estimated()) return readings;
  for (const JointThreshold& threshold : joint_thresholds(fit, data, leave_people_out(fit, data, 1))) {
    const auto quantity = static_cast<std::size_t>(threshold.quantity);
    if (quantity >= 4) continue;
    TrueReading& reading = readings[static_cast<std::size_t>(threshold.curve)][quantity];
    reading.ci95 = threshold.here.ci95;
    reading.simultaneous = threshold.simultaneous;
    const auto place = place_of(fit.model, fit.theta, threshold.curve, threshold.quantity);
    const SoughtMean sought = *sought_mean(threshold.quantity);
    reading.point_x =
        place ? place->x
        : mean_at_x(fit.model, fit.theta, threshold.curve, sought.mean, last_x).value > sought.level
            ? INFINITY
            : -INFINITY;
  }
  return readings;
}

/// What the joint model says, with as much in common as the answers bear, as `analyze` has it.
inline TrueReadings read_by_joint_model(const TrueStudy& study) {
  const JointData data = joint_data_of(study);
  return readings_of(fit_shared(data, {}, true).fit, data, std::log2(study.width_px.back()));
}

/// The joint model's sentences: slopes of all curves, thresholds of all artifacts.
inline SaidDiffers said_by_joint_model(const TrueStudy& study) {
  std::vector<CurveLabel> labels;
  for (const Artifact artifact : paper_artifacts)
    labels.push_back({.artifact = std::string(word(artifact)), .condition = "", .group = ""});
  SaidDiffers said;
  for (const ContrastTable& table : joint_contrasts(joint_data_of(study), labels, {}, LevelAxis{}).tables)
    for (const ContrastRow& row : table.rows)
      if (row.verdict == ContrastVerdict::differs)
        (table.question.find("steep") != std::string::npos ||
                 table.question.find("slope") != std::string::npos
             ? said.slopes
             : said.levels) = true;
  return said;
}

}  // namespace seamline::test
