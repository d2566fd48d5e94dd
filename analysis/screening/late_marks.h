#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "stimuli/definition/methods/late_frames.h"
#include "study/exchange/clip_records.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// Which answers were given to clips that were not shown as they should be.
struct LateMarks {
  LateFrames rule;
  std::vector<std::optional<study::ClipCounts>> counts;  ///< one an answer of the log

  /// Never one whose frames nobody counted.
  [[nodiscard]] bool is_marked(std::size_t answer) const;
  [[nodiscard]] bool any() const;
};

/// None where the log's study has no clips, or no frame was counted (simulated people). Throws InputError as
/// `read_clip_counts`.
[[nodiscard]] std::optional<LateMarks> late_marks(const study::LogContents& log);

/// The log without the answers that are marked.
[[nodiscard]] study::LogContents without_marked(study::LogContents log, const LateMarks& marks);

}  // namespace seamline::analysis
