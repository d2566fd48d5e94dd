#pragma once
#include <string>
#include <vector>

#include "analysis/screening/screening.h"
#include "analysis/statistics/resampling.h"
#include "analysis/thresholds/thresholds.h"

namespace seamline::analysis {

/// The thresholds of everybody, or of those whom a screen does not name.
struct ScreenedThresholds {
  std::string who;  ///< "everybody", "without those named by kurtosis", ..., "without anybody named"
  std::vector<std::string> left_out;           ///< codes of those named
  std::vector<ArtifactThresholds> thresholds;  ///< empty when nobody is left
};

/// The thresholds with everybody first, then without those whom each screen names (screens that name nobody
/// change nothing and have no entry), then, when more than one screen names somebody, without anybody named.
[[nodiscard]] std::vector<ScreenedThresholds> thresholds_with_and_without(
    const study::LogContents& log, const std::vector<ParticipantUse>& people, const Screening& screening,
    const ResamplingRequest& request, const std::vector<std::string>& order = {});

/// The participants with those of `codes` who are used marked `Use::screened`.
[[nodiscard]] std::vector<ParticipantUse> leave_out(std::vector<ParticipantUse> people,
                                                    const std::vector<std::string>& codes);

}  // namespace seamline::analysis
