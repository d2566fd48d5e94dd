#include "analysis/report/text/depth_error_notes.h"

#include <fmt/core.h>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/report/text/threshold_text.h"
#include "stimuli/set/depth_errors.h"
#include "support/text/error.h"

namespace seamline::analysis {
namespace {

std::vector<LevelDepthError> errors_of_log(const study::LogContents& log) {
  try {
    if (log.set_folder.empty() || set_hash(log.set_folder) != log.set_hash) return {};
    return depth_errors_of_set(read_manifest(log.set_folder));
  } catch (const InputError&) {
    return {};  // `sample_stimuli` says so
  }
}

}  // namespace

std::vector<std::string> thresholds_as_depth_errors(const Analysis& analysis) {
  if (analysis.data.axis.quantity != Quantity::estimate_share) return {};
  const std::vector<LevelDepthError> errors = errors_of_log(analysis.log);
  std::vector<std::string> notes;
  const auto add = [&](Artifact artifact, const std::string& condition, const std::string& name,
                       const ThresholdEstimate& estimate, const LevelAxis& axis) {
    const std::optional<double> level = level_of(estimate, axis);
    if (!level) return;
    const auto error = depth_error_at(errors, condition, *level);
    if (error)
      notes.push_back(fmt::format("{}, {} at a share of {}: depth with {}, linear between the levels shown.",
                                  artifact_title(artifact, condition), name, estimated_text(axis, *level),
                                  depth_error_text(*error)));
  };
  if (analysis.joint)
    for (const HeadlineRow& row : headline_rows(analysis))
      add(row.artifact, row.condition, std::string(row.rule->name), row.here, row.tested.axis);
  else
    for (const ThresholdRow& row : threshold_rows(analysis))
      add(row.artifact, row.condition, row.quantity, row.here, row.tested.axis);
  return notes;
}

}  // namespace seamline::analysis
