// Ten published data sets beside maximum-likelihood fits made with SciPy: six models each, see
// tests/data/README.md.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/intervals/fit_intervals.h"
#include "study/placement/sigmoid_shape.h"

namespace seamline::analysis {
using namespace study;
namespace {

using Json = nlohmann::json;

Sigmoid sigmoid_named(const std::string& name) {
  return name == "norm" ? Sigmoid::normal : name == "logistic" ? Sigmoid::logistic : Sigmoid::gumbel;
}

std::vector<LevelCounts> counts_of(const Json& set) {
  std::vector<LevelCounts> counts;
  for (std::size_t i = 0; i < set["x"].size(); ++i)
    counts.push_back({.level = set["x"][i], .correct = set["k"][i], .trials = set["n"][i]});
  return counts;
}

FitOptions options_of(const Json& set, const Json& scipy) {
  FitOptions options;
  options.sigmoid = sigmoid_named(scipy["sigmoid"]);
  options.axis = set["fit_axis"] == "log2" ? Axis::log2 : Axis::linear;
  options.direction = Direction::increasing;
  options.guess = fixed_rate(set["guess"]);
  options.lapse = scipy["lapse_mode"] == "fixed 0" ? fixed_rate(0) : free_rate(0.1);
  return options;
}

/// The place that SciPy calls m: F = 0.5, but 1 - 1/e for a Gumbel function.
double share_at_m(Sigmoid sigmoid) {
  return sigmoid == Sigmoid::gumbel ? 1 - std::exp(-1) : 0.5;
}

template <class Check>
void for_each_fit(const Check& check) {
  std::ifstream in(SEAMLINE_SOURCE_DIR "/tests/data/psychometric_fits.json");
  const Json file = Json::parse(in);
  for (const Json& set : file["cases"])
    for (const Json& scipy : set["ml"]) {
      const std::string name = set["id"].get<std::string>() + " " + scipy["sigmoid"].get<std::string>() +
                               " lapse " + scipy["lapse_mode"].get<std::string>();
      SCOPED_TRACE(name);
      check(set, scipy, fit_psychometric(counts_of(set), options_of(set, scipy)));
    }
}

TEST(PsychometricSciPy, NeverLessLikelyAndTheSameParametersWhereTheyAreDetermined) {
  int compared = 0, likelier = 0;
  for_each_fit([&](const Json& set, const Json& scipy, const PsychometricFit& fit) {
    EXPECT_TRUE(fit.converged);
    const double gain = fit.log_likelihood - scipy["loglik"].get<double>();
    EXPECT_GE(gain, -1e-6);
    if (scipy["compare"] == "loglik") return;
    if (fit.is_step) {
      // 100 levels of one trial: a step with 2.2 % lapses between two of them is the likeliest function of
      // all three sigmoids. SciPy found it for the normal one (its m and s are points of a plateau) and
      // stopped at a smooth local optimum for the other two.
      EXPECT_EQ(set["id"], "psig_matlab_noblock");
      EXPECT_EQ(scipy["lapse_mode"], "free[0,0.1]");
      ++likelier;
      const auto& step = *fit.search.step;
      const double m = fit.search.problem.to_unit(1.090058);
      EXPECT_TRUE(step.low_t < m && m < step.high_t);
      EXPECT_NEAR(fit.log_likelihood, -42.247640, 1e-6);
      // The smooth optimum is known too, and no worse than SciPy's.
      ASSERT_TRUE(fit.search.smooth);
      EXPECT_GE(fit.search.smooth->value, scipy["second_best_loglik"].get<double>() - 1e-6);
      return;
    }
    ++compared;
    const double axis_threshold = axis_value(fit.options.axis, fit.function.threshold);
    const double t50 = scipy["t50"], s = scipy["s"];
    EXPECT_NEAR(fit.function.scale, s, 1e-4 * s);
    EXPECT_NEAR(axis_threshold, t50, 1e-4 * std::abs(t50));
  });
  EXPECT_EQ(likelier, 3);
  EXPECT_EQ(compared, 52);  // and the three above
}

TEST(PsychometricSciPy, ProfileIntervalsWithinAHundredthOfTheirWidth) {
  int intervals = 0;
  for_each_fit([&](const Json& set, const Json& scipy, const PsychometricFit& fit) {
    if (scipy["ci95_profile_m"].is_null()) return;
    const double low = scipy["ci95_profile_m"][0], high = scipy["ci95_profile_m"][1];
    // Where our maximum is higher than SciPy's (the steps above), the interval below SciPy's maximum is
    // compared.
    const double gain = std::max(0.0, fit.log_likelihood - scipy["loglik"].get<double>());
    const LevelEstimate m =
        level_of_share(fit, share_at_m(fit.options.sigmoid), chi_squared_95 + (gain > 1e-6 ? 2 * gain : 0));
    const double found_low = axis_value(fit.options.axis, m.ci95.low),
                 found_high = axis_value(fit.options.axis, m.ci95.high);
    const double tolerance = 0.01 * (high - low);
    EXPECT_NEAR(found_low, low, tolerance) << set["id"];
    EXPECT_NEAR(found_high, high, tolerance) << set["id"];
    ++intervals;
  });
  EXPECT_EQ(intervals, 60);
}

}  // namespace
}  // namespace seamline::analysis
