#include "study/placement/quest_plus_grid.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace seamline::study {
namespace {

/// With them intervals were seen to hold the truth of unlike people
/// (documentation/how-to/adaptive_placement.md).
const std::vector<double> joint_first_ratings = {-2, -1.2, -0.4, 0.4, 1.2, 2},
                          joint_guess_ratings = {0.05, 0.2};

/// The value below which `share` of the mass lies.
double quantile(const std::vector<double>& values, const std::vector<double>& mass, double share) {
  double below = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double low = i == 0 ? values[i] : (values[i - 1] + values[i]) / 2;
    const double high = i + 1 == values.size() ? values[i] : (values[i] + values[i + 1]) / 2;
    if (mass[i] > 0 && below + mass[i] >= share)
      return low + (high - low) * std::clamp((share - below) / mass[i], 0.0, 1.0);
    below += mass[i];
  }
  return values.back();
}

/// Whether nothing lies beyond the grid's lowest value because nothing can.
bool is_natural_end(Parameter parameter, double lowest) {
  return (parameter == Parameter::lapse || parameter == Parameter::guess) && lowest == 0;
}

}  // namespace

std::string_view word(Parameter parameter) {
  switch (parameter) {
    case Parameter::threshold:
      return "threshold";
    case Parameter::scale:
      return "scale";
    case Parameter::lapse:
      return "lapse";
    case Parameter::guess:
      return "guess";
    case Parameter::rating_step:
      return "rating step";
    case Parameter::first_rating:
      return "first rating";
    case Parameter::guess_rating:
      return "guess rating";
  }
  return {};
}

int QuestPlusGrid::points() const {
  std::size_t points = 1;
  for (const std::vector<double>& axis : values) points *= std::max<std::size_t>(1, axis.size());
  return static_cast<int>(points);
}

int QuestPlusGrid::index(Parameter parameter, int point) const {
  auto remainder = static_cast<std::size_t>(point);
  for (std::size_t axis = values.size() - 1; axis > static_cast<std::size_t>(parameter); --axis)
    remainder /= std::max<std::size_t>(1, values[axis].size());
  return static_cast<int>(remainder % std::max<std::size_t>(1, of(parameter).size()));
}

QuestPlusGrid make_grid(const QuestPlusDefinition& definition) {
  QuestPlusGrid grid;
  grid.values.fill({0});
  const auto set = [&](Parameter parameter, const ParameterRange& range, Steps usual, bool in_log2) {
    const auto axis = static_cast<std::size_t>(parameter);
    grid.values[axis] = values_of(range, usual, in_log2);
    grid.log_prior[axis] = log_prior_of(range, usual);
  };
  const bool log2 = definition.axis == Axis::log2;
  set(Parameter::threshold, definition.threshold, log2 ? Steps::ratios : Steps::equal, log2);
  set(Parameter::scale, definition.scale, Steps::ratios, false);
  set(Parameter::lapse, definition.lapse, Steps::equal, false);
  set(Parameter::guess, definition.guess, Steps::equal, false);
  if (definition.outcome == PlacementOutcome::correct) return grid;
  set(Parameter::rating_step, definition.rating_step, Steps::ratios, false);
  if (definition.outcome == PlacementOutcome::noticeability) return grid;
  grid.values[static_cast<std::size_t>(Parameter::first_rating)] = joint_first_ratings;
  grid.values[static_cast<std::size_t>(Parameter::guess_rating)] = joint_guess_ratings;
  return grid;
}

double prior_mass(const QuestPlusGrid& grid, Parameter parameter, std::size_t value) {
  const std::vector<double>& log_prior = grid.log_prior[static_cast<std::size_t>(parameter)];
  if (grid.of(parameter).empty()) return 1;
  return log_prior.empty() ? 1.0 / grid.of(parameter).size() : std::exp(log_prior[value]);
}

QuestPlusPosterior prior_posterior(const QuestPlusGrid& grid) {
  QuestPlusPosterior prior = uniform_posterior(grid.points());
  if (std::all_of(grid.log_prior.begin(), grid.log_prior.end(),
                  [](const auto& axis) { return axis.empty(); }))
    return prior;
  for (int point = 0; point < grid.points(); ++point) {
    double log_mass = 0;
    for (const Parameter parameter : every_parameter) {
      const std::vector<double>& log_prior = grid.log_prior[static_cast<std::size_t>(parameter)];
      log_mass += log_prior.empty() ? -std::log(static_cast<double>(grid.of(parameter).size()))
                                    : log_prior[static_cast<std::size_t>(grid.index(parameter, point))];
    }
    prior.log_mass[point] = log_mass;
  }
  normalise(prior);
  return prior;
}

std::vector<double> marginal(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior,
                             Parameter parameter) {
  std::vector<double> mass(grid.of(parameter).size(), 0.0);
  if (mass.empty()) return mass;
  for (int point = 0; point < grid.points(); ++point)
    mass[static_cast<std::size_t>(grid.index(parameter, point))] += posterior.mass[point];
  return mass;
}

Moments moments(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior, Parameter parameter) {
  const std::vector<double>& values = grid.of(parameter);
  const std::vector<double> mass = marginal(grid, posterior, parameter);
  Moments result;
  for (std::size_t i = 0; i < values.size(); ++i) result.mean += mass[i] * values[i];
  double variance = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    variance += mass[i] * (values[i] - result.mean) * (values[i] - result.mean);
  result.sd = std::sqrt(variance);
  return result;
}

CredibleInterval interval95(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior,
                            Parameter parameter) {
  const std::vector<double>& values = grid.of(parameter);
  const std::vector<double> mass = marginal(grid, posterior, parameter);
  return {.low = quantile(values, mass, 0.025), .high = quantile(values, mass, 0.975)};
}

std::vector<EdgeAlarm> edge_alarms(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior,
                                   double edge_share) {
  std::vector<EdgeAlarm> alarms;
  for (const Parameter parameter : every_parameter) {
    const std::vector<double>& values = grid.of(parameter);
    if (values.size() < 3) continue;
    const std::vector<double> mass = marginal(grid, posterior, parameter);
    const auto leans_on = [&](std::size_t end) {
      return mass[end] > std::max(edge_share, 2 * prior_mass(grid, parameter, end));
    };
    if (leans_on(0) && !is_natural_end(parameter, values.front()))
      alarms.push_back({.parameter = parameter, .highest = false, .mass = mass.front()});
    if (leans_on(values.size() - 1))
      alarms.push_back({.parameter = parameter, .highest = true, .mass = mass.back()});
  }
  return alarms;
}

std::string text(const EdgeAlarm& alarm) {
  return fmt::format("{} at the grid's {} value ({:.2f} of the posterior)", word(alarm.parameter),
                     alarm.highest ? "highest" : "lowest", alarm.mass);
}

}  // namespace seamline::study
