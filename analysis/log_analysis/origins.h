#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/scores/participants.h"
#include "analysis/statistics/resampling.h"
#include "analysis/thresholds/thresholds.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// Where people took part.
struct OriginGroup {
  std::string name;      ///< "lab" (the window) or "web" (browsers, wherever they were hosted)
  int participants = 0;  ///< used
  std::vector<ArtifactThresholds> thresholds;  ///< of them alone
};

/// Whether a threshold of the web differs from the lab's.
struct OriginDifference {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  std::string quantity;   ///< "PT" or "SN"
  int lab = 0, web = 0;   ///< participants on the curve
  std::optional<double>
      difference;                ///< web less lab along the axis (octaves on log2 axes); none without both
  std::optional<double> p;       ///< of no difference; none with fewer than two participants in a group
  std::optional<double> p_holm;  ///< adjusted for all tests of the list (Holm)
};

struct OriginComparison {
  OriginGroup lab, web;
  std::vector<OriginDifference> differences;  ///< PT and SN of each artifact and condition
  int permutations = 0;
};

/// Lab and web, where the people used came by both; none where all came by one.
///
/// The test permutes participants between lab and web: its statistic is the distance of the thresholds of
/// both groups along the axis, a threshold beyond the levels tested counting as at their end; p is the share
/// of permutations, the observed one among them, whose distance is at least as large. `order` is that of the
/// study's conditions.
[[nodiscard]] std::optional<OriginComparison> compare_origins(const study::LogContents& log,
                                                              const std::vector<ParticipantUse>& people,
                                                              const ResamplingRequest& request,
                                                              const std::vector<std::string>& order = {});

}  // namespace seamline::analysis
