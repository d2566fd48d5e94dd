#include "stimuli/definition/methods/parameter_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seamline::inline stimuli {
namespace {

std::vector<double> evenly(double least, double most, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(count == 1 ? least : least + (most - least) * i / (count - 1));
  return values;
}

/// p ln x, 0 where p is 0.
double times_log(double p, double x) {
  return p == 0 ? 0 : p * std::log(x);
}

/// ln of the density at a value, up to a constant.
double log_density(const NormalMass& prior, double value, Steps steps) {
  const double distance =
      steps == Steps::ratios ? std::log2(value) - std::log2(prior.mean) : value - prior.mean;
  return -0.5 * (distance / prior.sd) * (distance / prior.sd);
}

double log_density(const BetaMass& prior, double value, Steps) {
  return times_log(prior.a - 1, value) + times_log(prior.b - 1, 1 - value);
}

/// Shifted so that the masses sum to 1.
std::vector<double> normalised(std::vector<double> log_mass) {
  const double highest = *std::max_element(log_mass.begin(), log_mass.end());
  double sum = 0;
  for (const double value : log_mass) sum += std::exp(value - highest);
  for (double& value : log_mass) value -= highest + std::log(sum);
  return log_mass;
}

struct PriorText {
  std::string operator()(const EvenMass&) const { return ""; }
  std::string operator()(const NormalMass& prior) const {
    return fmt::format(" normal {} {}", prior.mean, prior.sd);
  }
  std::string operator()(const BetaMass& prior) const { return fmt::format(" beta {} {}", prior.a, prior.b); }
  std::string operator()(const ListedMass& prior) const {
    return fmt::format(" weights {}", fmt::join(prior.weights, " "));
  }
};

}  // namespace

std::vector<double> values_of(const ParameterRange& range, Steps usual, bool in_log2) {
  std::vector<double> values = range.values;
  if (values.empty() && range.steps.value_or(usual) == Steps::ratios) {
    values = evenly(std::log2(range.least), std::log2(range.most), range.count);
    if (!in_log2)
      for (double& value : values) value = std::exp2(value);
    return values;
  }
  if (values.empty()) values = evenly(range.least, range.most, range.count);
  if (in_log2)
    for (double& value : values) value = std::log2(value);
  return values;
}

std::vector<double> log_prior_of(const ParameterRange& range, Steps usual) {
  const Steps steps = range.steps.value_or(usual);
  std::vector<double> log_mass;
  const auto at_values = [&](const auto& prior) {
    for (const double value : values_of(range, usual)) log_mass.push_back(log_density(prior, value, steps));
  };
  if (const auto* normal = std::get_if<NormalMass>(&range.prior)) at_values(*normal);
  if (const auto* beta = std::get_if<BetaMass>(&range.prior)) at_values(*beta);
  if (const auto* listed = std::get_if<ListedMass>(&range.prior))
    for (const double weight : listed->weights) log_mass.push_back(std::log(weight));
  return log_mass.empty() ? log_mass : normalised(std::move(log_mass));
}

std::string canonical_text(const ParameterRange& range, const std::string& name) {
  std::string text;
  if (range.steps) text += *range.steps == Steps::equal ? " steps equal" : " steps ratios";
  if (!range.values.empty()) text += fmt::format(" values {}", fmt::join(range.values, " "));
  text += std::visit(PriorText{}, range.prior);
  return text.empty() ? text : name + text + "\n";
}

}  // namespace seamline::inline stimuli
