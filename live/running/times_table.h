#pragma once
#include <string>
#include <vector>

#include "live/frame/methods.h"
#include "live/frame/stage_times.h"
#include "support/text/csv.h"

namespace seamline::live {

/// What one frame cost, and by which methods.
struct TimedFrame {
  std::size_t frame_index = 0;
  double time_s = 0;  ///< of the recording
  Methods methods;
  StageTimes times;
  bool is_tracked = true;
};

/// A row for each frame. The stage `physics` has a column only where things fall.
[[nodiscard]] CsvTable times_table(const std::vector<TimedFrame>& frames, bool has_physics);

/// Medians over the frames for people: each stage's milliseconds and share, and frames per second.
[[nodiscard]] std::string times_text(const std::vector<TimedFrame>& frames);

/// The median of some numbers; not of none.
[[nodiscard]] double median_of(std::vector<double> values);

}  // namespace seamline::live
