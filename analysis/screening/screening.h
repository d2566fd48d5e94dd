#pragma once
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/scores/score_matrix.h"
#include "analysis/screening/correlation_screening.h"
#include "analysis/screening/honest_people.h"
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
  HonestNaming honest;                 ///< why the other two screens judge, or do not

  /// Whether a screen judges the people of this study. Attention needs catch trials. Kurtosis and correlation
  /// need that honest people would hardly be named (`most_honest_named`); else `rejected` is false of all.
  [[nodiscard]] bool judged(ScreeningRule rule) const;
  /// Correlations with the others that people of this study have to exceed: those of the persons with the
  /// fewest and with the most answers; (0, 0) without people.
  [[nodiscard]] std::pair<double, double> critical_correlations() const;
  [[nodiscard]] std::vector<std::string> named_by(ScreeningRule rule) const;
  [[nodiscard]] std::vector<std::string> named() const;
};

/// Share of honest people whom a screen of scores would name in a study; 1: not known. Not of attention.
[[nodiscard]] double honest_share(const HonestNaming& honest, ScreeningRule rule);

/// "0.08 %", "under 0.01 %": of honest people a screen of scores would name so many.
[[nodiscard]] std::string honest_share_text(const HonestNaming& honest, ScreeningRule rule);

/// "0.33", or "0.34 to 0.41" where participants answered different numbers of stimuli; the limit of the
/// correlation screen in this study.
[[nodiscard]] std::string limit_text(const Screening& screening);

/// Why a screen judges nobody: "no catch trials", "too little was visible: it would name 14 % of honest
/// people"; empty where it judges.
[[nodiscard]] std::string why_not_judged(const Screening& screening, ScreeningRule rule);

/// Screens the participants of `scores`. `catches` may be empty: then attention is not judged.
[[nodiscard]] Screening screen_participants(const ScoreMatrix& scores,
                                            const std::vector<CatchAnswer>& catches);

}  // namespace seamline::analysis
