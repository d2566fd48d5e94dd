#include "analysis/log_analysis/choice_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/log_analysis/people_choices.h"
#include "analysis/psychometric/intervals/fit_warnings.h"
#include "analysis/psychometric/likelihood/overdispersion.h"
#include "analysis/psychometric/likelihood/search.h"
#include "analysis/statistics/interval.h"
#include "study/placement/sigmoid_shape.h"
#include "study/placement/trial.h"
#include "support/arithmetic/random.h"
#include "support/running/parallel.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Keeps these draws apart from those of other bootstraps with the same seed.
constexpr std::uint64_t band_domain = 0x62616e6463757276ULL;
constexpr int band_points = 61;

std::vector<std::string> used_codes(const Analysis& analysis) {
  std::vector<std::string> codes;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) codes.push_back(person.record.code);
  return codes;
}

/// The sums over people drawn with replacement.
FitProblem resampled(const PooledChoices& choices, const FitProblem& problem, std::uint64_t seed,
                     int replicate) {
  const auto people = static_cast<std::uint64_t>(choices.correct.rows());
  Random random(seed ^ band_domain, replicate);
  Eigen::RowVectorXd times = Eigen::RowVectorXd::Zero(choices.correct.rows());
  for (std::uint64_t draw = 0; draw < people; ++draw)
    times[static_cast<Eigen::Index>(random.below(people))] += 1;
  const Eigen::RowVectorXd right = times * choices.correct, all = times * choices.trials;
  FitProblem drawn = problem;
  for (std::size_t i = 0; i < drawn.levels.size(); ++i) {
    drawn.levels[i].k = right[static_cast<Eigen::Index>(i)];
    drawn.levels[i].n = all[static_cast<Eigen::Index>(i)];
  }
  std::erase_if(drawn.levels, [](const UnitCounts& level) { return level.n <= 0; });
  drawn.rows = drawn.levels;
  return drawn;
}

Interval percentiles(std::vector<double> values) {
  const double low = quantile(values, 0.025);
  return {.low = low, .high = quantile(values, 0.975)};
}

void add_band(ChoiceCurve& curve, const PooledChoices& choices, const ResamplingRequest& request) {
  const PsychometricFit& fit = curve.pooled->fit;
  const FitProblem& problem = fit.search.problem;
  const Axis axis = fit.options.axis;
  const double first = axis_value(axis, choices.level.front()), last = axis_value(axis, choices.level.back());
  std::vector<double> places;
  for (int i = 0; i < band_points; ++i) {
    const double along = first + (last - first) * i / (band_points - 1);
    places.push_back(problem.to_unit(along));
    curve.band.push_back({.level = level_of(axis, along),
                          .fitted = probability_at(problem, fit.search.best.theta, places.back()).right});
  }
  curve.band_replicates = std::min(request.replicates, most_band_replicates);
  std::vector<std::vector<double>> shares(places.size());
  const double width_of_scale = study::scales_in_width(fit.options.sigmoid) * problem.range;
  std::vector<double> narrowest, widest, lapses;
  for (int r = 0; r < curve.band_replicates; ++r) {
    const FitProblem drawn = resampled(choices, problem, request.seed, r);
    const Refit refitted = refit_with_step(drawn, fit.search.best);
    const Theta& theta = refitted.maximum.theta;
    for (std::size_t i = 0; i < places.size(); ++i)
      shares[i].push_back(probability_at(drawn, theta, places[i]).right);
    // A step has no scale of its own: it is as narrow as nothing, and as wide as is still as likely.
    const double scale = std::exp(theta[parameter::log_scale]);
    narrowest.push_back(refitted.step ? 0 : scale * width_of_scale);
    widest.push_back((refitted.step ? std::exp(refitted.step->largest_log_scale) : scale) * width_of_scale);
    lapses.push_back(theta[parameter::lapse]);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Interval band = percentiles(shares[i]);
    curve.band[i].low = band.low;
    curve.band[i].high = band.high;
  }
  if (!has_threshold(curve)) return;
  curve.width_ci95 = {.low = percentiles(narrowest).low, .high = percentiles(widest).high};
  curve.lapse_ci95 = percentiles(lapses);
}

/// Takes a level that stands apart out of the choices.
std::optional<UnitCounts> take_apart(PooledChoices& choices, const LevelAxis& axis) {
  if (choices.level.empty() || !stands_apart(axis, choices.level.front())) return std::nullopt;
  const UnitCounts apart{.t = 0, .k = choices.correct.col(0).sum(), .n = choices.trials.col(0).sum()};
  choices.level.erase(choices.level.begin());
  choices.correct = choices.correct.rightCols(choices.correct.cols() - 1).eval();
  choices.trials = choices.trials.rightCols(choices.trials.cols() - 1).eval();
  return apart;
}

ChoiceCurve choice_curve(const Analysis& analysis, const std::vector<std::string>& codes,
                         const ArtifactScores& scores) {
  const LevelAxis& axis = analysis.data.axis;
  const std::string_view artifact = word(scores.artifact);
  const std::string of_condition = in_condition(scores.condition);
  ChoiceCurve curve;
  curve.artifact = scores.artifact;
  curve.condition = scores.condition;
  PooledChoices choices = pooled_choices(analysis.log, codes, scores.artifact, scores.condition);
  curve.apart = take_apart(choices, axis);
  curve.people = static_cast<int>(choices.people.size());
  if (curve.people < 2)
    curve.missing = fmt::format(
        "No psychometric function of '{}'{} is fitted: {} participant answered, and intervals over "
        "participants need at least two.",
        artifact, of_condition, curve.people == 0 ? "no" : "one");
  else if (choices.level.size() < 2)
    curve.missing = fmt::format("No psychometric function of '{}'{} is fitted: it was tested at one {} only.",
                                artifact, of_condition, level_word(axis));
  if (!curve.missing.empty()) return curve;
  const FitOptions options = options_of_choices(analysis);
  const std::string unit(facts(axis.quantity).unit);
  curve.pooled = fit_pooled_choices(choices, options, unit);
  const PsychometricFit& fit = curve.pooled->fit;
  curve.goodness = goodness_of_fit(fit);
  curve.deviance_p = curve.goodness.degrees_of_freedom > 0
                         ? deviance_p(fit, deviance_replicates, analysis.resampling.seed)
                         : nan;
  add_band(curve, choices, analysis.resampling);
  curve.warnings = warnings_on(fit,
                               {.verdict = curve.pooled->verdict,
                                .width_ci95 = curve.width_ci95,
                                .overdispersion = estimate_overdispersion(fit),
                                .goodness = curve.goodness,
                                .deviance_p = curve.deviance_p},
                               unit);
  return curve;
}

}  // namespace

bool has_threshold(const ChoiceCurve& curve) {
  return curve.pooled && curve.pooled->verdict.kind == Verdict::Kind::identified;
}

std::vector<ChoiceCurve> choice_curves(const Analysis& analysis) {
  const std::vector<std::string> codes = used_codes(analysis);
  std::vector<ChoiceCurve> curves(analysis.data.artifacts.size());
  run_parallel(static_cast<int>(curves.size()), analysis.resampling.threads, [&](int index) {
    const std::size_t i = index;
    const ArtifactScores& scores = analysis.data.artifacts[i];
    if (!analysis.adaptive) {
      curves[i] = choice_curve(analysis, codes, scores);
      return;
    }
    curves[i].artifact = scores.artifact;
    curves[i].condition = scores.condition;
    curves[i].missing = fmt::format(
        "No function of everybody's answers to '{}'{} is fitted: {}s were placed by the answers, so people "
        "differ from {} to {}. The thresholds of each participant's track are given instead.",
        word(scores.artifact), in_condition(scores.condition), level_word(scores.axis),
        level_word(scores.axis), level_word(scores.axis));
  });
  return curves;
}

}  // namespace seamline::analysis
