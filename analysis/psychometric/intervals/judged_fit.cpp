#include "analysis/psychometric/intervals/judged_fit.h"

#include <cmath>

#include "analysis/psychometric/intervals/fit_warnings.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/numbers.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

bool is_closed(const Interval& interval) {
  return std::isfinite(interval.low) && std::isfinite(interval.high);
}

/// The bootstrap knows functions near the estimate only; where the likelihood excludes nothing neither may
/// it.
Interval open_as(Interval interval, const Interval& likelihood) {
  if (!std::isfinite(likelihood.low)) interval.low = -infinity;
  if (!std::isfinite(likelihood.high)) interval.high = infinity;
  return interval;
}

std::vector<PercentLevel> percent_levels(const JudgedFit& judged) {
  std::vector<PercentLevel> levels;
  for (double percent : judged.request.percents) {
    if (!(percent > 0 && percent < 100))
      throw input_error(
          {.field = request_name("percent"), .wanted = "between 0 and 100", .found = number_text(percent)});
    PercentLevel level;
    level.percent = percent;
    level.level = level_of_correct(judged.fit, percent / 100);
    level.is_reached = level.level.estimate.has_value();
    if (judged.verdict.kind == Verdict::Kind::not_identified) level.level.ci95 = {};
    if (!is_closed(level.level.ci95)) level.level.estimate.reset();
    if (judged.request.bootstrap_replicates > 0) {
      const BootstrapIntervals bootstrap =
          bootstrap_intervals(judged.fit, {.replicates = judged.request.bootstrap_replicates,
                                           .seed = judged.request.seed,
                                           .correct = percent / 100});
      level.bootstrap_ci95 = open_as(*bootstrap.level_of_correct, level.level.ci95);
    }
    levels.push_back(level);
  }
  return levels;
}

}  // namespace

JudgedFit judge_fit(const std::vector<LevelCounts>& counts, const FitOptions& options,
                    const FitRequest& request) {
  JudgedFit judged;
  judged.request = request;
  const auto tell = [&](double share, const char* now_doing) {
    if (request.progress) request.progress(share, now_doing);
  };
  tell(0, "looking for the likeliest function");
  judged.fit = fit_psychometric(counts, options);
  tell(0.25, "the threshold's interval");
  const ThresholdFinding finding = judge_threshold(judged.fit, threshold_interval(judged.fit), request.unit);
  judged.verdict = finding.verdict;
  judged.threshold = finding.estimate;
  judged.threshold_ci95 = finding.ci95;
  tell(0.4, "other intervals");
  judged.width_ci95 = width_interval(judged.fit);
  judged.lapse_ci95 = lapse_interval(judged.fit);
  judged.guess_ci95 = guess_interval(judged.fit);
  tell(0.6, "overdispersion and goodness of fit");
  judged.overdispersion = estimate_overdispersion(judged.fit);
  judged.goodness = goodness_of_fit(judged.fit);
  judged.deviance_p = request.deviance_replicates > 0
                          ? deviance_p(judged.fit, request.deviance_replicates, request.seed)
                          : nan;
  tell(0.75, request.bootstrap_replicates > 0 ? "the bootstrap" : "levels of percentages");
  judged.percents = percent_levels(judged);
  if (request.bootstrap_replicates > 0) {
    judged.bootstrap = bootstrap_intervals(
        judged.fit, {.replicates = request.bootstrap_replicates, .seed = request.seed, .correct = {}});
    judged.bootstrap->threshold = open_as(judged.bootstrap->threshold, judged.threshold_ci95);
    judged.bootstrap->width = open_as(judged.bootstrap->width, judged.width_ci95);
  }
  judged.warnings = warnings_on(judged.fit,
                                {.verdict = judged.verdict,
                                 .width_ci95 = judged.width_ci95,
                                 .overdispersion = judged.overdispersion,
                                 .goodness = judged.goodness,
                                 .deviance_p = judged.deviance_p},
                                request.unit);
  tell(1, "");
  return judged;
}

}  // namespace seamline::analysis
