#include "analysis/report/text/order_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seamline::analysis {
namespace {

/// What the halves of the session say, with the change of all curves together and its interval.
std::string halves_text(const SessionHalves& halves, const LevelAxis& axis) {
  if (halves.shifts.rows.empty()) return halves.missing;
  const auto number = [](double value) {
    return fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value);
  };
  const ContrastRow& first = halves.shifts.rows.front();
  const auto differing =
      std::count_if(halves.shifts.rows.begin(), halves.shifts.rows.end(),
                    [](const ContrastRow& row) { return row.verdict == ContrastVerdict::differs; });
  return fmt::format(
      "Thresholds of the second half of each session were compared with those of the first by the joint model "
      "with two thresholds for each curve, adjusted by Holm's method: the change of {} is {} {} (95 % interval "
      "{} to {}); {} of {} changes {} shown.",
      first.name.substr(0, first.name.find(':')), number(first.estimate), length_unit(axis),
      number(first.ci95_low), number(first.ci95_high), differing, halves.shifts.rows.size(),
      differing == 1 ? "was" : "were");
}

}  // namespace

std::string order_text(const SessionOrder& order, const SessionHalves& halves, const LevelAxis& axis) {
  return "Order was looked at by least squares with participants and stimuli as fixed effects, intervals by "
         "leaving out each participant in turn. " +
         trend_sentence(order) + " " + halves_text(halves, axis);
}

}  // namespace seamline::analysis
