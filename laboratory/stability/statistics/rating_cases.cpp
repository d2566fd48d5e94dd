#include "laboratory/stability/statistics/rating_cases.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "analysis/ordinal/likelihood/ordinal_data.h"
#include "analysis/psychometric/intervals/pooled_fit.h"
#include "analysis/scores/opinion_score.h"
#include "analysis/screening/correlation_screening.h"
#include "analysis/screening/kurtosis_screening.h"
#include "analysis/thresholds/thresholds.h"
#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/worst.h"
#include "laboratory/stability/statistics/curve_fit_cases.h"
#include "laboratory/stability/statistics/study_widths.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

/// People who score three objects at seven widths by a cumulative logit model with a slope of -1.1 an octave;
/// predictors "octaves" (-3 to 3), "object2", "object3".
OrdinalData simulated_ordinal_scores(int people, std::uint64_t seed) {
  constexpr std::array<double, 4> cuts = {-2, -0.5, 0.7, 2};
  OrdinalData data;
  data.predictors.resize(people * 21, 3);
  data.predictor_names = {"octaves", "object2", "object3"};
  int row = 0;
  for (int p = 0; p < people; ++p) {
    Random random(seed, p);
    const double level = 0.8 * random.normal();
    for (int object = 1; object <= 3; ++object)
      for (int octaves = -3; octaves <= 3; ++octaves, ++row) {
        data.predictors.row(row) << octaves, object == 2, object == 3;
        const double eta = level - 1.1 * octaves + (object == 2 ? 0.3 : object == 3 ? -0.3 : 0);
        const double share = random.uniform();
        int score = 0;
        for (const double cut : cuts) score += share >= 1 / (1 + std::exp(eta - cut)) ? 1 : 0;
        data.score.push_back(score);
        data.participant.push_back(p);
      }
  }
  return data;
}

/// Scores as given, with the means that analysis makes of them.
ArtifactScores scores_of(const Eigen::MatrixXd& noticeability) {
  ArtifactScores scores;
  scores.artifact = Artifact::receiver;
  scores.level.assign(widths_px.begin(), widths_px.end());
  scores.noticeability = noticeability;
  for (Eigen::Index p = 0; p < noticeability.rows(); ++p) scores.people.push_back("p" + std::to_string(p));
  for (Eigen::Index w = 0; w < noticeability.cols(); ++w) {
    const Eigen::VectorXd column = noticeability.col(w);
    scores.cells.push_back(mean_over_participants({column.begin(), column.end()}));
    scores.cells.back().level = widths_px[w];
  }
  return scores;
}

bool is_open(const LevelInterval& interval) {
  return std::isinf(interval.low_x) && std::isinf(interval.high_x);
}

}  // namespace

ArtifactScores simulated_scores(int people, std::uint64_t seed) {
  Eigen::MatrixXd noticeability(people, static_cast<Eigen::Index>(widths_px.size()));
  for (int p = 0; p < people; ++p) {
    Random random(seed, p);
    const Observer observer = make_observer(ObserverKind::threshold, {}, random);
    for (std::size_t w = 0; w < widths_px.size(); ++w) {
      double sum = 0;
      for (int object = 1; object <= 3; ++object) {
        Stimulus stimulus;
        stimulus.artifact = Artifact::receiver;
        stimulus.object_index = object;
        stimulus.depth.width_px = widths_px[w];
        stimulus.level = widths_px[w];
        const Response response = respond(observer, stimulus, random);
        sum += response.chosen_index == object ? response.rating : 0;
      }
      noticeability(p, static_cast<Eigen::Index>(w)) = sum / 3;
    }
  }
  return scores_of(noticeability);
}

Finding try_one_participant() {
  const ArtifactScores scores = simulated_scores(1, 4);
  const ArtifactThresholds thresholds = estimate_thresholds(scores, {.replicates = 200, .threads = 1});
  int wrong = std::isnan(scores.cells.front().sem) ? 0 : 1;
  for (const ThresholdEstimate* estimate :
       {&thresholds.estimates.perceptual, &thresholds.estimates.slightly_noticeable,
        &thresholds.estimates.inflection, &thresholds.estimates.perceptual_logistic})
    wrong += is_open(estimate->ci95) ? 0 : 1;
  const OpinionScore opinion = opinion_scores(scores.noticeability).front();
  wrong += std::isnan(opinion.sd) && std::isnan(opinion.ci95_low) ? 0 : 1;
  const OrdinalFit mixed = fit_cumulative_link_mixed(simulated_ordinal_scores(1, 3), {.threads = 1});
  wrong += mixed.verdict == OrdinalVerdict::one_participant ? 0 : 1;
  return {static_cast<double>(wrong),
          fmt::format("{} wrong of 7; the mixed model says: {}", wrong, word(mixed.verdict))};
}

Finding try_ten_thousand_participants(int threads) {
  const ArtifactScores scores = simulated_scores(10'000, 2);
  const ThresholdEstimate found =
      estimate_thresholds(scores, {.replicates = 200, .threads = threads}).estimates.perceptual;
  std::vector<double> means;
  for (const int width_px : widths_px)
    means.push_back(expected_noticeability({}, Artifact::receiver, width_px));
  const double planted = thresholds_of_means(log2_widths(widths_px), means).perceptual.level_x.value();
  const double standard_error = length_x(found.ci95).value() / (2 * 1.96);
  return {std::abs(found.level_x.value() - planted) / standard_error,
          fmt::format("PT {:.2f} px, planted {:.2f} px, standard error {:.2g} octaves",
                      std::exp2(*found.level_x), std::exp2(planted), standard_error)};
}

Finding try_constant_ratings() {
  int wrong = 0;
  for (const double rating : {0.0, 2.0, 4.0}) {
    const ArtifactScores scores = scores_of(Eigen::MatrixXd::Constant(20, 7, rating));
    const ArtifactThresholds thresholds = estimate_thresholds(scores, {.replicates = 200, .threads = 1});
    for (const ThresholdEstimate* estimate :
         {&thresholds.estimates.perceptual, &thresholds.estimates.slightly_noticeable,
          &thresholds.estimates.inflection})
      wrong += !estimate->level_x && estimate->reason ? 0 : 1;
    const OpinionScore opinion = opinion_scores(scores.noticeability).front();
    wrong +=
        opinion.mean == rating && opinion.sd == 0 && opinion.ci95_low == rating && opinion.ci95_high == rating
            ? 0
            : 1;
    wrong += std::isinf(sos_parameter(scores.noticeability, {}).a) ? 1 : 0;
    for (const KurtosisCount& count : screen_by_kurtosis(scores.noticeability))
      wrong += count.rejected ? 1 : 0;
    for (const CorrelationCheck& check : screen_by_correlation(scores.noticeability, {0, 1, 2, 3, 4, 5, 6}))
      wrong += check.rejected ? 1 : 0;
  }
  return {static_cast<double>(wrong), fmt::format("{} wrong", wrong)};
}

OrdinalFit ordinal_as_product(const OrdinalData& data) {
  return fit_cumulative_link(data, {.threads = 1});
}

Finding try_separation(const OrdinalRule& rule) {
  OrdinalData complete = simulated_ordinal_scores(20, 1), quasi = complete, constant = complete,
              almost = complete;
  for (std::size_t i = 0; i < complete.score.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double octaves = complete.predictors(row, 0);
    complete.score[i] = octaves < -1 ? 4 : octaves < 0 ? 3 : octaves < 1 ? 2 : octaves < 2 ? 1 : 0;
    if (quasi.predictors(row, 1) == 1) quasi.score[i] = 4;
    if (almost.predictors(row, 1) == 1) almost.score[i] = i == 8 ? 3 : 4;
    constant.score[i] = 4;
  }
  int wrong = 0;
  for (const OrdinalData* data : {&complete, &quasi, &constant})
    wrong += has_estimates(rule(*data).verdict) ? 1 : 0;
  wrong += has_estimates(rule(almost).verdict) ? 0 : 1;
  return {static_cast<double>(wrong),
          fmt::format("{}; {}; {}; one answer less: {}", word(rule(complete).verdict),
                      word(rule(quasi).verdict), word(rule(constant).verdict), word(rule(almost).verdict))};
}

Finding try_singular_design(const OrdinalRule& rule) {
  OrdinalData data = simulated_ordinal_scores(20, 1);
  data.predictors.conservativeResize(data.predictors.rows(), 4);
  data.predictor_names.emplace_back("added");
  const Eigen::VectorXd copy = 1000 - 12.5 * data.predictors.col(0).array();
  const Eigen::VectorXd constant = Eigen::VectorXd::Constant(data.predictors.rows(), 7);
  const Eigen::VectorXd sum = 1 - data.predictors.col(1).array() - data.predictors.col(2).array();
  int wrong = 0;
  for (const Eigen::VectorXd* column : {&copy, &constant, &sum}) {
    data.predictors.col(3) = *column;
    wrong += rule(data).verdict == OrdinalVerdict::singular_design ? 0 : 1;
  }
  return {static_cast<double>(wrong), fmt::format("{} of 3 not found singular", wrong)};
}

Finding try_units(const OrdinalRule& rule) {
  OrdinalData data = simulated_ordinal_scores(20, 4);
  const OrdinalFit usual = rule(data);
  data.predictors.col(0) = 1e6 + 1e-4 * data.predictors.col(0).array();
  const OrdinalFit shifted = rule(data);
  if (!has_estimates(usual.verdict) || !has_estimates(shifted.verdict)) return {nan, shifted.explanation};
  const double error = relative_error(shifted.coefficients[0] * 1e-4, usual.coefficients[0]);
  return {error, fmt::format("{:.8g} and {:.8g}", usual.coefficients[0], shifted.coefficients[0] * 1e-4)};
}

Finding try_stiff_curves() {
  struct Wanted {
    std::vector<double> means;
    bool identified;
  };
  const std::vector<Wanted> curves = {
      {{2, 2, 2, 2, 2, 2, 2}, false},         {{0, 0, 0, 0, 0, 0, 0}, false},
      {{3.5, 3, 2.5, 2, 1.5, 1, 0.5}, false}, {{3, 3, 3, 0, 0, 0, 0}, false},
      {{0, 1, 2, 3, 3.5, 4, 4}, false},       {{3.6, 3.4, 2.8, 1.6, 0.6, 0.35, 0.3}, true}};
  int wrong = 0;
  std::string found;
  for (const Wanted& curve : curves) {
    const CurveThresholds thresholds = thresholds_of_means(log2_widths(widths_px), curve.means);
    const bool identified = thresholds.inflection.level_x.has_value();
    wrong += identified == curve.identified && (identified || thresholds.inflection.reason) ? 0 : 1;
    found += identified ? "+" : "-";
  }
  return {static_cast<double>(wrong), "identified: " + found};
}

Finding try_identical_people() {
  PooledChoices choices;
  choices.correct = choices.trials = Eigen::MatrixXd::Zero(12, 7);
  for (int p = 0; p < 12; ++p) choices.people.push_back("p" + std::to_string(p));
  const auto counts =
      counts_at_widths(9, [](double px) { return response_probability(planted_function(0.02), px); });
  for (std::size_t w = 0; w < counts.size(); ++w) {
    choices.level.push_back(counts[w].level);
    choices.correct.col(static_cast<Eigen::Index>(w)).setConstant(static_cast<double>(counts[w].correct));
    choices.trials.col(static_cast<Eigen::Index>(w)).setConstant(static_cast<double>(counts[w].trials));
  }
  const PooledFit fit = fit_pooled_choices(choices, falling_choice_of_three());
  const double estimate = fit.fit.function.threshold;
  const Interval& ci = fit.threshold_ci95;
  const int wrong =
      (ci.low < estimate && ci.high > estimate ? 0 : 1) + (std::isfinite(fit.design_effect) ? 0 : 1);
  return {static_cast<double>(wrong),
          fmt::format("threshold {:.4g} px, interval {:.4g} to {:.4g} px, design effect {:.2g}", estimate,
                      ci.low, ci.high, fit.design_effect)};
}

StabilityCases rating_cases() {
  return {
      counted_case("statistics", "one-participant", "one person's answers",
                   "means, but no standard error, open intervals, no model of differences between people",
                   try_one_participant),
      {.group = "statistics",
       .name = "10000-participants",
       .tried = "10,000 simulated people with a planted PT",
       .expected = "the planted PT",
       .unit = "standard errors",
       .tolerance = 4,
       .reason = "a right estimate is farther off with one seed in 16,000",
       .run = [](const StabilityOptions& options) { return try_ten_thousand_participants(options.threads); }},
      counted_case("statistics", "constant-ratings", "20 people who rate everything 0, 2 or 4",
                   "no threshold and a reason, spread 0, nobody screened", try_constant_ratings),
      counted_case(
          "statistics", "ordinal-separation",
          "scores that a predictor separates, wholly and in part; constant scores; one answer less than "
          "separated",
          "no numbers in the first three, numbers in the last", [] { return try_separation(); }),
      counted_case("statistics", "ordinal-singular-design",
                   "a predictor that is a copy, a constant, or a sum of others",
                   "called singular, no numbers", [] { return try_singular_design(); }),
      {.group = "statistics",
       .name = "ordinal-units",
       .tried = "a predictor given as 1e6 + 1e-4 x",
       .expected = "the coefficient of x, in its units",
       .unit = "relative",
       .tolerance = 1e-5,
       .reason = "x itself keeps 1e-4 / (1e6 x 1.1e-16) = 1e6 parts: 1e-6; ten times that",
       .run = [](const StabilityOptions&) { return try_units(); }},
      counted_case("statistics", "stiff-curves",
                   "mean curves that are constant (twice), straight, a step, rising; and an S",
                   "an inflection point in the last alone, and a reason", try_stiff_curves),
      counted_case("statistics", "identical-people",
                   "12 people who answer exactly alike, so that leaving one out changes nothing",
                   "an interval around the estimate", try_identical_people),
  };
}

}  // namespace seamline::stability
