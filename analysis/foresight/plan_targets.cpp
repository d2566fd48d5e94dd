#include "analysis/foresight/plan_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace {

/// Whether a list names a word, or names nothing and means all.
bool asks_for(const std::vector<std::string>& list, std::string_view name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

void require_known(const std::string& option, const std::vector<std::string>& list,
                   const std::vector<std::string>& known) {
  for (const std::string& name : list)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw input_error(
          {.field = option, .wanted = fmt::format("{}", fmt::join(known, ", ")), .found = name});
}

std::vector<std::string> artifacts_of(const std::vector<PlannedCurve>& curves) {
  std::vector<std::string> names;
  for (const PlannedCurve& curve : curves)
    if (const std::string name(word(curve.artifact));
        std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

std::vector<std::string> conditions_of(const std::vector<PlannedCurve>& curves) {
  std::vector<std::string> names;
  for (const PlannedCurve& curve : curves)
    if (!curve.condition.empty() && std::find(names.begin(), names.end(), curve.condition) == names.end())
      names.push_back(curve.condition);
  return names;
}

/// What can be asked for in a task, and what is where nothing is said.
std::vector<std::string> quantities_of(const PlannedTask& task) {
  if (!task.facts.rates) return {"detection"};  // PT and SN are of ratings
  std::vector<std::string> quantities;
  for (const PlannedQuantity& quantity : every_planned_quantity) quantities.emplace_back(quantity.word);
  return quantities;
}

/// Whether guesses alone reach a quantity's level, so that no threshold does: PT of a pair.
bool lies_in_floor(const PlannedQuantity& quantity, const PlannedPopulation& population) {
  const double floor = population.task.chance() * (1 + population.assumed.high_guesses);
  return quantity.sought.mean == JointMean::as_counted && quantity.sought.level <= floor;
}

std::vector<std::string> quantities_asked(const WantedTargets& wanted, const PlannedPopulation& population) {
  const auto& [pt, sn, corrected_pt, corrected_sn, detection] = every_planned_quantity;
  if (!population.task.facts.rates) return {std::string(detection.word)};
  for (const std::string& asked : wanted.quantities)
    for (const PlannedQuantity& quantity : every_planned_quantity)
      if (asked == quantity.word && lies_in_floor(quantity, population))
        throw input_error({.field = request_name("quantities"),
                           .wanted = "a level that guesses alone do not reach, such as corrected-PT",
                           .found = asked});
  if (!wanted.quantities.empty()) return wanted.quantities;
  return {std::string(lies_in_floor(pt, population) ? corrected_pt.word : pt.word),
          std::string(lies_in_floor(sn, population) ? corrected_sn.word : sn.word)};
}

/// Where a quantity of a curve truly lies.
double truth_of(const PlannedPopulation& population, const PlannedCurve& curve,
                const PlannedQuantity& quantity) {
  return true_crossing(population, curve, quantity.sought.level, quantity.sought.mean);
}

/// Pairs of curves of which the second is compared with the first.
using CurvePairs = std::vector<std::pair<std::size_t, std::size_t>>;

CurvePairs pairs_of(const std::string& text, const WantedTargets& wanted,
                    const std::vector<PlannedCurve>& curves) {
  const std::size_t between = text.find(':');
  const std::string from = text.substr(0, between),
                    to = between == std::string::npos ? "" : text.substr(between + 1);
  CurvePairs pairs;
  for (std::size_t a = 0; a < curves.size(); ++a)
    for (std::size_t b = 0; b < curves.size(); ++b) {
      if (a == b) continue;
      const bool artifacts = curves[a].condition == curves[b].condition && word(curves[a].artifact) == from &&
                             word(curves[b].artifact) == to &&
                             asks_for(wanted.conditions, curves[a].condition);
      const bool conditions = curves[a].artifact == curves[b].artifact && curves[a].condition == from &&
                              curves[b].condition == to &&
                              asks_for(wanted.artifacts, word(curves[a].artifact));
      if (artifacts || conditions) pairs.emplace_back(a, b);
    }
  if (pairs.empty())
    throw input_error(
        {.field = request_name("difference"),
         .wanted = fmt::format("A:B, two of the study's artifacts ({}) or conditions ({})",
                               fmt::join(artifacts_of(curves), ", "), fmt::join(conditions_of(curves), ", ")),
         .found = text});
  return pairs;
}

void state_difference(double difference, const CurvePairs& pairs, const LevelAxis& axis,
                      std::vector<PlannedCurve>& curves) {
  const double difference_x = is_linear(axis) ? difference / axis.unit : difference;
  const double sign = axis.noticeability == Direction::increasing ? -1 : 1;
  for (const auto& [from, to] : pairs)
    curves[to].midpoint = level_at(axis, x_of(axis, curves[from].midpoint) + sign * difference_x);
}

}  // namespace

std::string name_of(const PlanTarget& target, const std::vector<PlannedCurve>& curves) {
  const std::string own = fmt::format("{} of {}", target.quantity.name, name_of(curves[target.curve]));
  return target.against ? own + " less that of " + name_of(curves[*target.against]) : own;
}

std::vector<PlanTarget> plan_targets(const WantedTargets& wanted, const PlannedPopulation& population,
                                     std::vector<PlannedCurve>& curves) {
  require_known(request_name("quantities"), wanted.quantities, quantities_of(population.task));
  require_known(request_name("artifacts"), wanted.artifacts, artifacts_of(curves));
  require_known(request_name("conditions"), wanted.conditions, conditions_of(curves));
  CurvePairs pairs;
  for (const std::string& text : wanted.differences)
    for (const auto& pair : pairs_of(text, wanted, curves)) pairs.push_back(pair);
  if (wanted.stated_difference) state_difference(*wanted.stated_difference, pairs, population.axis, curves);

  std::vector<PlanTarget> targets;
  const std::vector<std::string> asked = quantities_asked(wanted, population);
  for (std::size_t curve = 0; curve < curves.size(); ++curve)
    for (const PlannedQuantity& quantity : every_planned_quantity)
      if (!wanted.differences_alone && asks_for(asked, quantity.word) &&
          asks_for(wanted.artifacts, word(curves[curve].artifact)) &&
          asks_for(wanted.conditions, curves[curve].condition))
        targets.push_back(
            {.quantity = quantity, .curve = curve, .truth_x = truth_of(population, curves[curve], quantity)});
  for (const auto& [from, to] : pairs)
    for (const PlannedQuantity& quantity : every_planned_quantity)
      if (asks_for(asked, quantity.word))
        targets.push_back({.quantity = quantity,
                           .curve = to,
                           .against = from,
                           .truth_x = truth_of(population, curves[to], quantity) -
                                      truth_of(population, curves[from], quantity)});
  if (targets.empty())
    throw input_error({.field = request_name("artifacts"),
                       .wanted = "something to measure",
                       .found = "no curve that has this artifact in this condition"});
  return targets;
}

}  // namespace seamline::analysis
