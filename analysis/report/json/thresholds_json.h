#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/over_scenes/scene_thresholds.h"

namespace seamline::analysis {

inline constexpr const char* thresholds_format = "seamline thresholds";
inline constexpr int thresholds_version = 1;

/// The text of `REPORT/thresholds.json`. For each artifact `perceptual_threshold_px`,
/// `slightly_noticeable_px` and `inflection_px`, each {estimate or null, reason or null, ci95: [low, high]
/// with null for an open end, ci95_text}; the same in texels per degree (W / 360); the curve over objects
/// with its fits; and the cells behind it. NaN (a standard error of one participant) is null. `scenes` where
/// there are curves over scenes.
[[nodiscard]] std::string thresholds_json(const Analysis& analysis,
                                          const std::vector<CurveOverScenes>& over_scenes = {});

}  // namespace seamline::analysis
