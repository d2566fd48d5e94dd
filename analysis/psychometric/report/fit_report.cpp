#include "analysis/psychometric/report/fit_report.h"

#include <cmath>

#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/numbers.h"

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

std::vector<PercentLevel> percent_levels(const FitReport& report) {
  std::vector<PercentLevel> levels;
  for (double percent : report.request.percents) {
    if (!(percent > 0 && percent < 100))
      throw input_error({.field = "--percent", .wanted = "between 0 and 100", .found = number_text(percent)});
    PercentLevel level;
    level.percent = percent;
    level.level = level_of_correct(report.fit, percent / 100);
    level.is_reached = level.level.estimate.has_value();
    if (report.verdict.kind == Verdict::Kind::not_identified) level.level.ci95 = {};
    if (!is_closed(level.level.ci95)) level.level.estimate.reset();
    if (report.request.bootstrap_replicates > 0) {
      const BootstrapIntervals bootstrap =
          bootstrap_intervals(report.fit, {.replicates = report.request.bootstrap_replicates,
                                           .seed = report.request.seed,
                                           .correct = percent / 100});
      level.bootstrap_ci95 = open_as(*bootstrap.level_of_correct, level.level.ci95);
    }
    levels.push_back(level);
  }
  return levels;
}

}  // namespace

FitReport make_fit_report(const std::vector<LevelCounts>& counts, const FitOptions& options,
                          const FitRequest& request) {
  FitReport report;
  report.request = request;
  const auto tell = [&](double share, const char* now_doing) {
    if (request.progress) request.progress(share, now_doing);
  };
  tell(0, "looking for the likeliest function");
  report.fit = fit_psychometric(counts, options);
  tell(0.25, "the threshold's interval");
  const ThresholdFinding finding = judge_threshold(report.fit, threshold_interval(report.fit), request.unit);
  report.verdict = finding.verdict;
  report.threshold = finding.estimate;
  report.threshold_ci95 = finding.ci95;
  tell(0.4, "other intervals");
  report.width_ci95 = width_interval(report.fit);
  report.lapse_ci95 = lapse_interval(report.fit);
  report.guess_ci95 = guess_interval(report.fit);
  tell(0.6, "overdispersion and goodness of fit");
  report.overdispersion = estimate_overdispersion(report.fit);
  report.goodness = goodness_of_fit(report.fit);
  report.deviance_p = request.deviance_replicates > 0
                          ? deviance_p(report.fit, request.deviance_replicates, request.seed)
                          : nan;
  tell(0.75, request.bootstrap_replicates > 0 ? "the bootstrap" : "levels of percentages");
  report.percents = percent_levels(report);
  if (request.bootstrap_replicates > 0) {
    report.bootstrap = bootstrap_intervals(
        report.fit, {.replicates = request.bootstrap_replicates, .seed = request.seed, .correct = {}});
    report.bootstrap->threshold = open_as(report.bootstrap->threshold, report.threshold_ci95);
    report.bootstrap->width = open_as(report.bootstrap->width, report.width_ci95);
  }
  report.warnings = warnings_on(report.fit,
                                {.verdict = report.verdict,
                                 .width_ci95 = report.width_ci95,
                                 .overdispersion = report.overdispersion,
                                 .goodness = report.goodness,
                                 .deviance_p = report.deviance_p},
                                request.unit);
  tell(1, "");
  return report;
}

const char* word(study::Direction direction) {
  return direction == study::Direction::increasing ? "increasing" : "decreasing";
}

const char* word(study::Axis axis) {
  return axis == study::Axis::log2 ? "log2" : "linear";
}

}  // namespace seamline::analysis
