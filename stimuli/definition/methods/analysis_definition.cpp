#include "stimuli/definition/methods/analysis_definition.h"

#include <fmt/format.h>

namespace seamline::inline stimuli {

std::vector<std::string> sentences_of(const AnalysisDefinition& analysis) {
  if (!analysis.joint)
    return {
        "Thresholds of record are those of straight lines between the tested levels, the paper's way; no joint "
        "model is fitted."};
  std::string own;
  const auto add = [&](bool shared, const char* what) {
    if (!shared) own += (own.empty() ? "" : ", ") + std::string(what);
  };
  add(analysis.share_scale, "scale");
  add(analysis.share_criteria, "rating criteria");
  add(analysis.share_lapse, "lapse rate");
  add(analysis.share_guess_ratings, "guess ratings");
  if (own.empty()) return {};
  return {fmt::format("Each curve of the joint model has its own {}.", own)};
}

}  // namespace seamline::inline stimuli
