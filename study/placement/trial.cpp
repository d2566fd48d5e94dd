#include "study/placement/trial.h"

namespace seamline::study {

std::string_view word(TrialKind kind) {
  switch (kind) {
    case TrialKind::stimulus:
      return "stimulus";
    case TrialKind::attention:
      return "attention";
    case TrialKind::mask:
      return "mask";
    case TrialKind::reference:
      return "reference";
  }
  return {};
}

std::optional<TrialKind> trial_kind_from_word(std::string_view text) {
  for (const TrialKind kind : every_trial_kind)
    if (word(kind) == text) return kind;
  return std::nullopt;
}

}  // namespace seamline::study
