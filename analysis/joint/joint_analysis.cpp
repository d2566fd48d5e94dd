#include "analysis/joint/joint_analysis.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace seamline::analysis {

JointAnalysis analyze_jointly(const GuessTrials& trials, const NoticeabilityData& noticeability,
                              const Guessers& guessers, const JointRequest& request) {
  JointAnalysis analysis;
  analysis.axis = noticeability.axis;
  for (const ArtifactScores& scores : noticeability.artifacts)
    analysis.labels.push_back(
        {.artifact = std::string(word(scores.artifact)), .condition = scores.condition, .group = {}});
  analysis.data = joint_data(trials, noticeability.axis, guessers);
  SharedFit shared = fit_shared(analysis.data, request.sharing, request.sharing_tested);
  analysis.fit = std::move(shared.fit);
  analysis.sharing = std::move(shared.tests);
  analysis.refused_sharing = std::move(shared.refused);
  if (analysis.fit.estimated())
    analysis.left_out = leave_people_out(analysis.fit, analysis.data, request.goodness.threads);
  analysis.thresholds = joint_thresholds(analysis.fit, analysis.data, analysis.left_out);
  if (!analysis.fit.estimated()) return analysis;
  analysis.contrasts =
      joint_contrasts(analysis.fit, analysis.left_out, analysis.data, analysis.labels, noticeability.axis);
  analysis.people = joint_people(analysis.fit, analysis.data);
  analysis.goodness = joint_goodness(analysis.fit, analysis.data, analysis.people, request.goodness);
  return analysis;
}

const JointThreshold& threshold_of(const JointAnalysis& analysis, int curve, JointQuantity quantity) {
  // They stand curve by curve, each with every quantity in its order.
  const auto* in_order = std::find(every_joint_quantity.begin(), every_joint_quantity.end(), quantity);
  const std::size_t place =
      curve * every_joint_quantity.size() + static_cast<std::size_t>(in_order - every_joint_quantity.begin());
  if (curve >= 0 && place < analysis.thresholds.size()) {
    const JointThreshold& threshold = analysis.thresholds[place];
    if (threshold.curve == curve && threshold.quantity == quantity) return threshold;
  }
  throw std::logic_error("a threshold of a curve that the joint model does not have");
}

}  // namespace seamline::analysis
