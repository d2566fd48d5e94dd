#include "stimuli/definition/methods/analysis_definition.h"

#include <fmt/format.h>

namespace seamline::inline stimuli {

const SharedBlock* shared_block(std::string_view word) {
  for (const SharedBlock& block : shared_blocks)
    if (block.word == word) return &block;
  return nullptr;
}

std::vector<std::string> sentences_of(const AnalysisDefinition& analysis) {
  if (!analysis.joint)
    return {
        "Thresholds of record are those of straight lines between the tested levels, the paper's way; no joint "
        "model is fitted."};
  std::string own;
  for (const SharedBlock& block : shared_blocks)
    if (!(analysis.*block.shared)) own += (own.empty() ? "" : ", ") + std::string(block.name);
  std::vector<std::string> sentences;
  if (!own.empty()) sentences.push_back(fmt::format("Each curve of the joint model has its own {}.", own));
  if (!analysis.sharing_tested)
    sentences.push_back("What curves share was decided before the study, whatever the tests say of it.");
  return sentences;
}

}  // namespace seamline::inline stimuli
