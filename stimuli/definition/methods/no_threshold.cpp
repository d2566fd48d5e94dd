#include "stimuli/definition/methods/no_threshold.h"

#include <algorithm>

namespace seamline::inline stimuli {
namespace {

struct ReasonWords {
  NoThreshold why = NoThreshold::any_level;
  std::string_view word = {}, sentence = {};
};

/// In the order of the enumeration.
constexpr std::array<ReasonWords, number_of_reasons> reasons = {{
    {NoThreshold::above_level, "above_level", "above {low}"},
    {NoThreshold::below_level, "below_level", "below {high}"},
    {NoThreshold::any_level, "any_level", "not determined: no {level} is excluded"},
    {NoThreshold::open_hardest, "open_hardest",
     "open where seams are hardest to see: add people, or levels there"},
    {NoThreshold::open_easiest, "open_easiest",
     "open where seams are easiest to see: add people, or levels there"},
    {NoThreshold::open_both, "open_both", "not determined: no level is excluded"},
    {NoThreshold::curve_above, "curve_above", "the curve lies above it at every {level}"},
    {NoThreshold::curve_below, "curve_below", "the curve lies below it at every {level}"},
    {NoThreshold::no_such_place, "no_such_place", "the curve has no such place"},
    {NoThreshold::guess_floor, "guess_floor", "not identified: the level lies in the guess floor"},
    {NoThreshold::step, "step",
     "a step between {steepest_low} and {steepest_high}: the {levels} tested do not say where"},
    {NoThreshold::straight, "straight", "not identified: the fit is all but a straight line"},
    {NoThreshold::steepest_below, "steepest_below", "steepest below {steepest_high}"},
    {NoThreshold::steepest_above, "steepest_above", "steepest above {steepest_low}"},
    {NoThreshold::not_falling, "not_falling", "not identified: noticeability does not {fall} {with_level}"},
    {NoThreshold::under_four_levels, "under_four_levels", "not identified: under four {levels}"},
    {NoThreshold::no_answers, "no_answers", "no answers"},
    {NoThreshold::one_participant, "one_participant", "one participant"},
    {NoThreshold::too_few_levels, "too_few_levels", "too few levels"},
    {NoThreshold::only_guesses, "only_guesses", "only guesses"},
    {NoThreshold::at_chance, "at_chance", "at chance"},
    {NoThreshold::never_wrong, "never_wrong", "never wrong"},
    {NoThreshold::separated, "separated", "separated"},
    {NoThreshold::not_converged, "not_converged", "not converged"},
    {NoThreshold::nobody_on_curve, "nobody_on_curve", "nobody on the curve"},
    {NoThreshold::nobody_answered, "nobody_answered", "nobody answered at every {level}"},
    {NoThreshold::no_level_shown, "no_level_shown", "no level on the axis was shown"},
    {NoThreshold::too_few_trials, "too_few_trials", "too few trials"},
    {NoThreshold::ratings_not_asked, "ratings_not_asked", "ratings were not asked"},
    {NoThreshold::placed_by_answers, "placed_by_answers", "{levels} were placed by the answers"},
    {NoThreshold::no_inflection, "no_inflection", "not given where levels were placed by the answers"},
}};

constexpr bool in_order() {
  for (std::size_t i = 0; i < reasons.size(); ++i)
    if (static_cast<std::size_t>(reasons[i].why) != i) return false;
  return true;
}
static_assert(in_order());

}  // namespace

std::string_view word(NoThreshold why) {
  return reasons[static_cast<std::size_t>(why)].word;
}

std::optional<NoThreshold> no_threshold_from_word(std::string_view text) {
  const auto* const found = std::find_if(reasons.begin(), reasons.end(),
                                         [&](const ReasonWords& reason) { return reason.word == text; });
  return found == reasons.end() ? std::nullopt : std::optional(found->why);
}

std::string_view sentence(NoThreshold why) {
  return reasons[static_cast<std::size_t>(why)].sentence;
}

}  // namespace seamline::inline stimuli
