#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace seamline::inline stimuli {

/// How the values of a parameter lie between the least and the most.
enum class Steps {
  equal,   ///< equal differences
  ratios,  ///< equal ratios, which are equal differences of log2
};

/// Every value has the same mass.
struct EvenMass {};

/// A normal density at each value: exp(-z^2 / 2), z = (value - mean) / sd where steps are equal, and z =
/// (log2 value - log2 mean) / sd, sd in octaves, where they are ratios.
struct NormalMass {
  double mean = 0;  ///< in the parameter's unit
  double sd = 1;
};

/// The beta density of a rate at each value: v^(a - 1) (1 - v)^(b - 1).
struct BetaMass {
  double a = 1, b = 1;  ///< at least 1
};

/// A mass for each value, at least 0 and not all 0; they need not sum to 1. 0 rules a value out for good.
struct ListedMass {
  std::vector<double> weights;
};

/// What is believed about one parameter before the first answer.
using ParameterPrior = std::variant<EvenMass, NormalMass, BetaMass, ListedMass>;

/// The values that a parameter of a psychometric function may have: `count` of them from `least` to `most`,
/// both included.
struct ParameterRange {
  double least = 0;
  double most = 0;
  int count = 1;                    ///< 1: the parameter is known, least == most
  std::optional<Steps> steps = {};  ///< none: those that are usual for the parameter
  std::vector<double> values = {};  ///< where not empty: these, rising, instead of steps
  ParameterPrior prior = EvenMass{};
};

/// The values, rising, in the parameter's unit, or, when `in_log2`, their log2, of which equal ratios are
/// made without rounding twice. Precondition: positive values where a log2 is needed.
[[nodiscard]] std::vector<double> values_of(const ParameterRange& range, Steps usual, bool in_log2 = false);

/// ln of the prior mass of each value; the masses sum to 1. Empty for an even prior. A mass of 0 is
/// -infinity.
[[nodiscard]] std::vector<double> log_prior_of(const ParameterRange& range, Steps usual);

/// Where steps, values and prior differ from what they are unless the study file says more: their meaning as
/// text for the study's hash, a line that begins with `name`. Empty where they do not.
[[nodiscard]] std::string canonical_text(const ParameterRange& range, const std::string& name);

}  // namespace seamline::inline stimuli
