#include "analysis/screening/catch_answers.h"

namespace seamline::analysis {

std::vector<ReferenceAnswer> reference_answers(const study::LogContents& log) {
  std::vector<ReferenceAnswer> references;
  for (const study::CatchTrialAnswer& answer : log.catches)
    if (answer.kind == study::TrialKind::reference)
      references.push_back(
          {.participant = answer.participant, .chosen_index = answer.chosen_index, .rating = answer.rating});
  return references;
}

std::vector<CatchAnswer> attention_answers(const study::LogContents& log) {
  std::vector<CatchAnswer> answers;
  for (const study::CatchTrialAnswer& answer : log.catches)
    if (answer.kind == study::TrialKind::attention)
      answers.push_back({.participant = answer.participant, .right = answer.right()});
  return answers;
}

}  // namespace seamline::analysis
