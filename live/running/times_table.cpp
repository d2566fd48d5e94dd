#include "live/running/times_table.h"

#include <fmt/core.h>

#include <algorithm>

namespace seamline::live {
namespace {

std::vector<FrameStage> listed_stages(bool has_physics) {
  std::vector<FrameStage> stages;
  for (std::size_t i = 0; i < stage_count; ++i)
    if (has_physics || static_cast<FrameStage>(i) != FrameStage::physics)
      stages.push_back(static_cast<FrameStage>(i));
  return stages;
}

}  // namespace

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

CsvTable times_table(const std::vector<TimedFrame>& frames, bool has_physics) {
  CsvTable table{.name = "times",
                 .columns = {{"frame", "", "number in the recording, from 0"},
                             {"time_s", "s", "of the recording"},
                             {"mapping_by", "", "how depth comes into the picture's pixels"},
                             {"occlusion_by", "", "who says what is in front"},
                             {"shadows_by", "", "how light is kept away"},
                             {"tracked", "", "1: the camera's pose was found in this frame"}},
                 .rows = {}};
  const std::vector<FrameStage> stages = listed_stages(has_physics);
  for (const FrameStage stage : stages)
    table.columns.push_back({std::string(word(stage)) + "_ms", "ms", "of this stage"});
  table.columns.push_back({"total_ms", "ms", "of all stages"});
  for (const TimedFrame& frame : frames) {
    std::vector<CsvValue> row = {
        static_cast<std::int64_t>(frame.frame_index), frame.time_s,
        std::string(word(frame.methods.mapping)),     std::string(word(frame.methods.occlusion)),
        std::string(word(frame.methods.shadows)),     std::int64_t{frame.is_tracked ? 1 : 0}};
    for (const FrameStage stage : stages) row.emplace_back(frame.times.of(stage));
    row.emplace_back(frame.times.total_ms());
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::string times_text(const std::vector<TimedFrame>& frames) {
  if (frames.empty()) return {};
  std::vector<double> totals_ms;
  for (const TimedFrame& frame : frames) totals_ms.push_back(frame.times.total_ms());
  const double total_ms = median_of(totals_ms);
  std::string text;
  for (std::size_t i = 0; i < stage_count; ++i) {
    std::vector<double> stage_ms;
    for (const TimedFrame& frame : frames) stage_ms.push_back(frame.times.ms[i]);
    const double ms = median_of(stage_ms);
    if (ms > 0)
      text += fmt::format("  {:<12}{:>8.2f} ms  {:5.1f} %\n", word(static_cast<FrameStage>(i)), ms,
                          100 * ms / total_ms);
  }
  return text + fmt::format("  {:<12}{:>8.2f} ms  {:.1f} frames a second\n  {}\n", "total", total_ms,
                            1000 / total_ms,
                            frames.size() == 1 ? std::string("of one frame")
                                               : fmt::format("medians of {} frames", frames.size()));
}

}  // namespace seamline::live
