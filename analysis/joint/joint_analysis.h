#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/joint/joint_contrasts.h"
#include "analysis/joint/joint_goodness.h"
#include "analysis/joint/joint_people.h"
#include "analysis/joint/joint_sharing.h"
#include "analysis/joint/joint_thresholds.h"

namespace seamline::analysis {

struct JointRequest {
  JointSharing sharing = {};
  bool sharing_tested = true;  ///< see `fit_shared`
  JointGoodnessRequest goodness = {};
};

/// All that the joint model says of a log: what report, tables and JSON are written from.
struct JointAnalysis {
  LevelAxis axis;
  std::vector<CurveLabel> labels;  ///< one a curve, in the order of NoticeabilityData::artifacts
  JointData data;
  JointFit fit;             ///< `fit.verdict` and `fit.explanation` first: without numbers the rest is empty
  JointJackknife left_out;  ///< empty without numbers
  std::vector<JointThreshold> thresholds;  ///< of every curve, also those without numbers, with a reason
  JointContrasts contrasts;
  JointPeople people;
  std::optional<JointGoodness> goodness;
  std::vector<SharingTest> sharing;          ///< of the fit that shares all that was asked for
  std::vector<SharingTest> refused_sharing;  ///< what is each curve's own because of them
};

/// Fits and computes everything. `trials` and `guessers` are of `noticeability` (count_guess_trials,
/// estimate_guessers).
[[nodiscard]] JointAnalysis analyze_jointly(const GuessTrials& trials, const NoticeabilityData& noticeability,
                                            const Guessers& guessers, const JointRequest& request = {});

/// The threshold of a quantity of a curve.
[[nodiscard]] const JointThreshold& threshold_of(const JointAnalysis& analysis, int curve,
                                                 JointQuantity quantity);

}  // namespace seamline::analysis
