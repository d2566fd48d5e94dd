#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace seamline::inline stimuli {

/// Why a curve has no threshold. Programs decide by it, people read its sentence; `thresholds.json` has both.
enum class NoThreshold {
  // The interval is open, by the paper's way and by the joint model
  above_level,   ///< it has a smallest level only
  below_level,   ///< it has a largest level only
  any_level,     ///< it has neither
  open_hardest,  ///< it has no end where seams are hardest to see
  open_easiest,  ///< it has no end where they are easiest to see
  open_both,
  // The curve has no such place
  curve_above,  ///< seams are more noticeable than that at every level
  curve_below,  ///< they are less noticeable at every level
  no_such_place,
  guess_floor,  ///< people who see nothing reach that noticeability by guessing
  // The logistic does not say where it is steepest
  step,
  straight,
  steepest_below,
  steepest_above,
  not_falling,
  under_four_levels,
  // The joint model has no numbers
  no_answers,
  one_participant,
  too_few_levels,
  only_guesses,
  at_chance,
  never_wrong,
  separated,
  not_converged,
  // Nothing of the kind was asked
  nobody_on_curve,
  nobody_answered,
  no_level_shown,
  too_few_trials,
  ratings_not_asked,
  placed_by_answers,
  no_inflection
};

inline constexpr std::size_t number_of_reasons = static_cast<std::size_t>(NoThreshold::no_inflection) + 1;

/// "curve_above": of the key `reason_word`.
[[nodiscard]] std::string_view word(NoThreshold why);
[[nodiscard]] std::optional<NoThreshold> no_threshold_from_word(std::string_view text);

/// What people read, with names in braces for what depends on the study (`reason_text` in analysis).
[[nodiscard]] std::string_view sentence(NoThreshold why);

}  // namespace seamline::inline stimuli
