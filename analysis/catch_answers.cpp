#include "analysis/catch_answers.h"

namespace seamline {

std::vector<ReferenceAnswer> reference_answers(const LogContents& log) {
  std::vector<ReferenceAnswer> references;
  for (const CatchTrialAnswer& answer : log.catches)
    if (answer.kind == TrialKind::reference)
      references.push_back(
          {.participant = answer.participant, .chosen_index = answer.chosen_index, .rating = answer.rating});
  return references;
}

std::vector<CatchAnswer> attention_answers(const LogContents& log) {
  std::vector<CatchAnswer> answers;
  for (const CatchTrialAnswer& answer : log.catches)
    if (answer.kind == TrialKind::attention)
      answers.push_back({.participant = answer.participant, .right = answer.right()});
  return answers;
}

}  // namespace seamline
