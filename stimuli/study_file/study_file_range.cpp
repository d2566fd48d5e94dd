#include "stimuli/study_file/study_file_range.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {
namespace {

constexpr int most_values = 1001;  // of one parameter
constexpr NumberRange weight_bounds = {0, 1e12};

void read_ends(const TomlTable& table, ParameterRange& range, const ParameterRange& fallback,
               NumberRange bounds) {
  range.least = table.number("least", fallback.least, bounds);
  range.most = table.number("most", fallback.most, bounds);
  range.count = table.integer("count", fallback.count, {1, most_values, "values"});
  const bool single = range.count == 1;
  if (single ? range.most != range.least : range.most <= range.least)
    throw table.complaint("most",
                          fmt::format("{} least ({}), with count = {}", single ? "the same as" : "more than",
                                      range.least, range.count),
                          fmt::format("{}", range.most));
}

void read_values(const TomlTable& table, ParameterRange& range, NumberRange bounds) {
  for (const char* key : {"least", "most", "count"})
    if (table.has(key)) throw table.complaint(key, "either values, or least, most and count", "both");
  range.values = table.numbers("values", bounds);
  if (range.values.size() > most_values)
    throw table.complaint("values", fmt::format("at most {} values", most_values),
                          fmt::format("{}", range.values.size()));
  const auto fall = std::adjacent_find(range.values.begin(), range.values.end(), std::greater_equal<>());
  if (fall != range.values.end())
    throw table.complaint("values", "values that rise", fmt::format("{} after {}", *(fall + 1), *fall));
  range.least = range.values.front();
  range.most = range.values.back();
  range.count = static_cast<int>(range.values.size());
}

void read_steps(const TomlTable& table, ParameterRange& range, Steps usual) {
  constexpr std::array<std::string_view, 2> words = {"equal", "ratios"};
  const Steps steps = !table.has("steps")                     ? usual
                      : read_word(table, "steps", words) == 0 ? Steps::equal
                                                              : Steps::ratios;
  if (steps == Steps::ratios && range.least <= 0)
    throw table.complaint("steps", "\"equal\" where a value is 0 or less", "\"ratios\"");
  if (steps != usual) range.steps = steps;
}

/// `first` and `second` of a prior, neither without the other.
std::pair<double, double> both(const TomlTable& prior, const char* first, NumberRange of_first,
                               const char* second, NumberRange of_second) {
  for (const auto& [key, other] : {std::pair(first, second), std::pair(second, first)})
    if (!prior.has(key)) throw prior.complaint(key, fmt::format("a number beside {}", other), "nothing");
  return {prior.number(first, 0, of_first), prior.number(second, 0, of_second)};
}

ParameterPrior read_prior(const TomlTable& table, const ParameterRange& range, const ParameterRule& rule) {
  const std::optional<TomlTable> prior = table.table("prior");
  if (!prior) return EvenMass{};
  const bool normal = prior->has("mean") || prior->has("sd"), listed = prior->has("weights");
  const bool beta = rule.is_rate && (prior->has("a") || prior->has("b"));
  ParameterPrior read = EvenMass{};
  const auto take = [&](const ParameterPrior& found) { read = found; };
  if (normal + listed + beta > 1)
    throw table.complaint(
        "prior", rule.is_rate ? "one of mean and sd, a and b, or weights" : "either mean and sd, or weights",
        "more than one");
  if (normal) {
    const auto [mean, sd] = both(*prior, "mean", rule.bounds, "sd", {1e-6, 1e9});
    if (range.steps.value_or(rule.usual) == Steps::ratios && mean <= 0)
      throw prior->complaint("mean", "a positive number where steps are ratios", fmt::format("{}", mean));
    take(NormalMass{.mean = mean, .sd = sd});
  } else if (beta) {
    const auto [a, b] = both(*prior, "a", {1, 1e6}, "b", {1, 1e6});
    take(BetaMass{.a = a, .b = b});
  } else if (listed) {
    const std::vector<double> weights = prior->numbers("weights", weight_bounds);
    if (weights.size() != static_cast<std::size_t>(range.count))
      throw prior->complaint("weights", fmt::format("{} numbers, one for each value", range.count),
                             fmt::format("{}", weights.size()));
    take(ListedMass{.weights = weights});
  }
  prior->finish();
  if (!normal && !beta && !listed)
    throw table.complaint(
        "prior", rule.is_rate ? "mean and sd, a and b, or weights" : "mean and sd, or weights", "nothing");
  return read;
}

}  // namespace

ParameterRange read_range(const TomlTable& settings, const char* key, const ParameterRange& fallback,
                          const ParameterRule& rule) {
  const std::optional<TomlTable> table = settings.table(key);
  if (!table) return fallback;
  ParameterRange range;
  if (table->has("values"))
    read_values(*table, range, rule.bounds);
  else
    read_ends(*table, range, fallback, rule.bounds);
  read_steps(*table, range, rule.usual);
  range.prior = read_prior(*table, range, rule);
  table->finish();
  const std::vector<double> log_mass = log_prior_of(range, rule.usual);
  if (!log_mass.empty() &&
      std::none_of(log_mass.begin(), log_mass.end(), [](double value) { return std::isfinite(value); }))
    throw table->complaint("prior", "a value that is possible", "none");
  return range;
}

}  // namespace seamline::inline stimuli
