#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::inline stimuli {

/// How a study wants its answers analysed (`[analysis]`). It shows people nothing, so it is no part of the
/// study's hash; `freeze` freezes it.
struct AnalysisDefinition {
  bool joint = true;  ///< thresholds of record are the joint model's; false: straight lines, the paper's way
  /// What the curves of the joint model share (documentation/explanation/joint_model.md).
  bool share_scale = true, share_criteria = true, share_lapse = true, share_guess_ratings = true;
  /// What is shared becomes each curve's own where a test refuses it; false: it stays shared.
  bool sharing_tested = true;
  std::vector<std::string> compare =
      {};  ///< what people are grouped by, where the command line names nothing

  bool operator==(const AnalysisDefinition&) const = default;
};

/// A block of parameters that curves share or have of their own.
struct SharedBlock {
  std::string_view word;  ///< in study files and on the command line
  std::string_view name;  ///< for readers
  bool AnalysisDefinition::*shared;
};
inline constexpr std::array<SharedBlock, 4> shared_blocks = {
    {{"scale", "scale", &AnalysisDefinition::share_scale},
     {"criteria", "rating criteria", &AnalysisDefinition::share_criteria},
     {"lapse", "lapse rate", &AnalysisDefinition::share_lapse},
     {"guess_ratings", "guess ratings", &AnalysisDefinition::share_guess_ratings}}};

/// The block of a word; null for any other word.
[[nodiscard]] const SharedBlock* shared_block(std::string_view word);

/// What is not as it is without `[analysis]`, a sentence each; what people are compared by is not said.
[[nodiscard]] std::vector<std::string> sentences_of(const AnalysisDefinition& analysis);

}  // namespace seamline::inline stimuli
