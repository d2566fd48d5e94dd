#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/definition/procedure_definition.h"
#include "study/placement/quest_plus.h"

namespace seamline::study {

/// The parameters of a psychometric function, in the order in which a grid nests them (the last is
/// innermost).
enum class Parameter { threshold, scale, lapse, guess, rating_step, first_rating, guess_rating };
inline constexpr std::array every_parameter = {
    Parameter::threshold,   Parameter::scale,        Parameter::lapse,       Parameter::guess,
    Parameter::rating_step, Parameter::first_rating, Parameter::guess_rating};
[[nodiscard]] std::string_view word(Parameter parameter);

/// Every combination of the parameters' values is a point.
struct QuestPlusGrid {
  /// Rising. As made from a study: thresholds on its axis (log2 of the level, or the level), scales and
  /// rating steps in its unit (octaves or the level's), rates as shares. What an outcome
  /// does not have is 0, or empty.
  std::array<std::vector<double>, every_parameter.size()> values;
  /// ln of the prior mass of each value, -infinity for none; empty where all have the same. The prior of a
  /// point is their product.
  std::array<std::vector<double>, every_parameter.size()> log_prior = {};

  [[nodiscard]] const std::vector<double>& of(Parameter parameter) const {
    return values[static_cast<std::size_t>(parameter)];
  }
  [[nodiscard]] int points() const;
  [[nodiscard]] int index(Parameter parameter, int point) const;  ///< into `of(parameter)`
  [[nodiscard]] double value(Parameter parameter, int point) const {
    return of(parameter).empty() ? 0 : of(parameter)[static_cast<std::size_t>(index(parameter, point))];
  }
};

[[nodiscard]] QuestPlusGrid make_grid(const QuestPlusDefinition& definition);

/// What is believed before the first answer.
[[nodiscard]] QuestPlusPosterior prior_posterior(const QuestPlusGrid& grid);

/// The prior mass of one value of a parameter.
[[nodiscard]] double prior_mass(const QuestPlusGrid& grid, Parameter parameter, std::size_t value);

/// The posterior of one parameter alone: a mass for each of its values.
[[nodiscard]] std::vector<double> marginal(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior,
                                           Parameter parameter);

struct Moments {
  double mean = 0, sd = 0;
};
[[nodiscard]] Moments moments(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior,
                              Parameter parameter);

struct CredibleInterval {
  double low = 0, high = 0;
};
/// The equal-tailed 95 % interval of a parameter. Each value's mass is spread evenly over the half steps to
/// its neighbours, so that the interval moves smoothly; the outermost values have their inner half only.
[[nodiscard]] CredibleInterval interval95(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior,
                                          Parameter parameter);

/// The posterior leans on an end of the grid: the truth may lie beyond, and the estimate cannot follow.
struct EdgeAlarm {
  Parameter parameter = Parameter::threshold;
  bool highest = false;  ///< at the highest value, else at the lowest
  double mass = 0;       ///< of the outermost value
};

/// An alarm for each end whose outermost value holds more than `edge_share` of the posterior, and more than
/// twice its share of the prior. A lapse or guess of 0 is the end of what there is, not of the grid, and
/// parameters with fewer than three values have no inside to be in.
[[nodiscard]] std::vector<EdgeAlarm> edge_alarms(const QuestPlusGrid& grid,
                                                 const QuestPlusPosterior& posterior, double edge_share);

/// "threshold at the grid's highest value (0.31 of the posterior)".
[[nodiscard]] std::string text(const EdgeAlarm& alarm);

}  // namespace seamline::study
