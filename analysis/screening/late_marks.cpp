#include "analysis/screening/late_marks.h"

#include <algorithm>
#include <utility>

#include "stimuli/study_file/moving/study_file_late_frames.h"

namespace seamline::analysis {

bool LateMarks::is_marked(std::size_t answer) const {
  const std::optional<study::ClipCounts>& one = counts.at(answer);
  return one && one->late_share() > rule.most_share;
}

bool LateMarks::any() const {
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (is_marked(i)) return true;
  return false;
}

std::optional<LateMarks> late_marks(const study::LogContents& log) {
  LateMarks marks{.rule = {}, .counts = study::read_clip_counts(log)};
  if (std::none_of(marks.counts.begin(), marks.counts.end(), [](const auto& one) { return one.has_value(); }))
    return std::nullopt;
  marks.rule = read_late_frames_text(log.study_text, log.file).value_or(LateFrames{});
  return marks;
}

study::LogContents without_marked(study::LogContents log, const LateMarks& marks) {
  std::vector<study::Answer> kept;
  for (std::size_t i = 0; i < log.answers.size(); ++i)
    if (!marks.is_marked(i)) kept.push_back(std::move(log.answers[i]));
  log.answers = std::move(kept);
  return log;
}

}  // namespace seamline::analysis
