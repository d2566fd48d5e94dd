#include "analysis/report/tables/late_text.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"

namespace seamline::analysis {
namespace {

/// What leaving the marked trials out changes most; empty where no threshold has a number both times.
std::string largest_change(const LateReport& late) {
  const LateThreshold* most = nullptr;
  const auto change = [](const LateThreshold& one) {
    return std::abs(*one.without.level_x - *one.with.level_x);
  };
  int lost = 0;
  for (const LateThreshold& one : late.thresholds) {
    if (one.with.level_x.has_value() != one.without.level_x.has_value()) ++lost;
    if (!one.with.level_x || !one.without.level_x) continue;
    if (most == nullptr || change(one) > change(*most)) most = &one;
  }
  std::string text;
  if (most != nullptr)
    text = fmt::format(" The threshold that differs most without them is {} of '{}'{}: {} with, {} without.",
                       most->quantity, word(most->artifact), in_condition(most->condition),
                       estimate_text(most->with, most->tested), estimate_text(most->without, most->tested));
  if (lost > 0)
    text += fmt::format(" {} threshold{} a number only with or only without them.", lost,
                        lost == 1 ? " has" : "s have");
  return text;
}

}  // namespace

std::string late_sentence(const LateReport& late) {
  const LateRow all = late.all();
  return fmt::format(
      "Of {} frames of clips that were due {} came late and {} never. In {} of {} trials that was "
      "more than {:g} %: they are {}.{}",
      all.due, all.late, all.dropped, all.marked, all.answers, 100 * late.rule.most_share,
      late.rule.trials == LateTrials::left_out ? "left out" : "marked and used all the same",
      late.not_compared.empty() ? "" : " " + late.not_compared);
}

std::string late_method(const LateReport& late) {
  return "Stimuli were clips. A frame counts as late where it came more than two refreshes of the screen after its "
         "time, and as dropped where the next one's time had come. " +
         late_sentence(late) + largest_change(late);
}

}  // namespace seamline::analysis
