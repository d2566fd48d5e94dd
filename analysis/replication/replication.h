#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/joint/joint_analysis.h"
#include "analysis/replication/published_thresholds.h"

namespace seamline::analysis {

/// What a study says of a published threshold.
enum class ReplicationVerdict {
  agrees,        ///< the 90 % interval of the difference lies within the margin (two one-sided tests at 5 %)
  differs,       ///< the 95 % interval of the difference excludes 0, and it is not within the margin
  undecided,     ///< neither: too few people to say
  no_estimate,   ///< this study has no number for it
  not_reported,  ///< the source gives no number
  not_tested     ///< this study did not test the curve
};

/// "agrees within the margin", "differs", "undecided", ...
[[nodiscard]] std::string_view word(ReplicationVerdict verdict);

/// A published threshold beside the study's own. Differences are this study's less the published one: along
/// the axis of levels, in octaves or the level's unit; positive where the study's level is the larger.
struct ReplicatedThreshold {
  PublishedThreshold published;
  ThresholdEstimate here;  ///< of the joint model, on the axis
  bool inside = false;     ///< whether the published value lies in the 95 % interval of the study
  std::optional<double> difference;
  std::optional<double> low95, high95;  ///< of the difference; none: open
  ReplicationVerdict verdict = ReplicationVerdict::not_tested;
};

/// Whether curves come in the published order of a quantity.
struct ReplicatedOrder {
  std::string quantity, condition;
  std::vector<std::string> artifacts;  ///< by rising published level; those with both numbers
  std::vector<std::string> found;      ///< the same by rising level of this study
  double probability = 0;  ///< that people drawn anew from those of the study have the published order
};

struct Replication {
  std::string name, sha256;  ///< of what was published
  double margin = 0;         ///< octaves, or the level's unit
  std::vector<ReplicatedThreshold> thresholds;
  std::vector<ReplicatedOrder> orders;  ///< of each quantity with two curves or more

  [[nodiscard]] int count(ReplicationVerdict verdict) const;
};

struct ReplicationRequest {
  PublishedThresholds published;
  double margin = 0.5;
  int replicates = 10000;  ///< of people, for orders
  std::uint64_t seed = 1;
};

/// Lays published thresholds beside those of the joint model.
///
/// The interval of a difference joins those of both sides (Zou and Donner 2008, MOVER): its lower end lies
/// sqrt((e - l)^2 + (U - p)^2) below the difference, where e is the estimate, l its lower end, p the
/// published value and U its upper end; likewise above. The 90 % interval is the 95 % interval shortened on
/// each side by the ratio of the quantiles of t with people - 1 degrees of freedom.
///
/// Orders: people are drawn with replacement from their pseudo-values n x - (n - 1) x_i, where x_i is the
/// threshold without person i; a draw's threshold is x plus the mean of the drawn deviations.
[[nodiscard]] Replication compare_with_published(const JointAnalysis& joint,
                                                 const ReplicationRequest& request);

}  // namespace seamline::analysis
