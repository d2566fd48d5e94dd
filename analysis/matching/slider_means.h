#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/signal_detection.h"

namespace seamline::analysis {

/// Where people put the slider of a rating (`[task] scale = "slider"`) at a level: the mean over participants
/// of each one's mean place, 0 nothing seen to `study::slider_end`.
struct SliderMean {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  double level = 0;
  int people = 0, answers = 0;
  MeanOverPeople place = {};
};

/// Of each curve and level, in the order of the data; none where the study has no slider. Of the participants
/// whom the analysis uses.
[[nodiscard]] std::vector<SliderMean> slider_means(const Analysis& analysis);

}  // namespace seamline::analysis
