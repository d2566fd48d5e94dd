#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/scores/score_matrix.h"
#include "analysis/screening/correlation_screening.h"
#include "analysis/screening/kurtosis_screening.h"

namespace seamline::analysis {

/// The ways a participant can be named as one whose answers may not be about the pictures.
enum class ScreeningRule {
  attention,   ///< catch trials: an insertion that nobody who looks can miss
  kurtosis,    ///< ITU-R BT.500
  correlation  ///< with the mean of the others
};
inline constexpr std::array<ScreeningRule, 3> every_screening_rule = {
    ScreeningRule::attention, ScreeningRule::kurtosis, ScreeningRule::correlation};

[[nodiscard]] std::string_view word(ScreeningRule rule);
/// A sentence for a method section: the rule with its numbers.
[[nodiscard]] std::string_view rule_of(ScreeningRule rule);

/// An answer to a catch trial.
struct CatchAnswer {
  std::string participant;
  bool right = false;
};

struct AttentionCount {
  int shown = 0, right = 0;
  bool rejected = false;
};

/// Under this share of right catch trials a participant is named.
inline constexpr double least_attention_share = 0.75;

/// What each screen says of one participant.
struct ScreenedPerson {
  std::string code;
  AttentionCount attention;
  KurtosisCount kurtosis;
  CorrelationCheck correlation;

  [[nodiscard]] bool named_by(ScreeningRule rule) const;
  [[nodiscard]] bool named() const;  ///< by at least one
};

/// Every screen beside the others, for everybody. Names; excludes nobody.
struct Screening {
  std::vector<ScreenedPerson> people;  ///< in the order of the scores
  bool catch_trials = false;           ///< whether there were any

  [[nodiscard]] std::vector<std::string> named_by(ScreeningRule rule) const;
  [[nodiscard]] std::vector<std::string> named() const;
};

/// Screens the participants of `scores`. `catches` may be empty: then attention is not judged.
[[nodiscard]] Screening screen_participants(const ScoreMatrix& scores,
                                            const std::vector<CatchAnswer>& catches);

}  // namespace seamline::analysis
