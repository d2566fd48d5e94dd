#include "analysis/psychometric/report/fit_quantities.h"

#include <fmt/format.h>

#include <cmath>

namespace seamline::analysis {

namespace {

FitQuantity threshold(const JudgedFit& report) {
  FitQuantity quantity{.name = "threshold",
                       .unit = report.request.unit,
                       .estimate = report.threshold,
                       .ci95 = report.threshold_ci95,
                       .bootstrap_ci95 = {},
                       .reason = {}};
  if (!report.threshold)
    quantity.reason = report.verdict.text;
  else if (report.verdict.kind == Verdict::Kind::between)
    quantity.reason = "a step: the middle of thresholds that are as likely";
  if (report.bootstrap) quantity.bootstrap_ci95 = report.bootstrap->threshold;
  return quantity;
}

FitQuantity width(const JudgedFit& report) {
  FitQuantity quantity{.name = "width",
                       .unit = report.fit.options.axis == study::Axis::log2 ? "octaves" : report.request.unit,
                       .estimate = {},
                       .ci95 = report.width_ci95,
                       .bootstrap_ci95 = {},
                       .reason = {}};
  const Interval& ci95 = report.width_ci95;
  const std::string bound = std::isfinite(ci95.high) ? fmt::format("at most {:.3g}", ci95.high)
                            : ci95.low > 0           ? fmt::format("above {:.3g}", ci95.low)
                                                     : "no width is excluded";
  if (!report.threshold)
    quantity.reason = report.verdict.text;
  else if (report.fit.is_step)
    quantity.reason = "a step: " + bound;
  else if (!std::isfinite(ci95.high))
    quantity.reason = "not identified: " + bound;
  else
    quantity.estimate = report.fit.width;
  if (report.bootstrap) quantity.bootstrap_ci95 = report.bootstrap->width;
  return quantity;
}

FitQuantity rate(const JudgedFit& report, const char* name, const Rate& rule, double value,
                 const Interval& ci95) {
  FitQuantity quantity{
      .name = name, .unit = {}, .estimate = value, .ci95 = ci95, .bootstrap_ci95 = {}, .reason = {}};
  if (!rule.is_free()) {
    quantity.estimate = rule.low;
    quantity.reason = "fixed";
  } else if (report.verdict.kind == Verdict::Kind::not_identified) {
    quantity.estimate.reset();
    quantity.reason = report.verdict.text;
  }
  return quantity;
}

}  // namespace

std::vector<FitQuantity> quantities(const JudgedFit& report) {
  const PsychometricFit& fit = report.fit;
  std::vector<FitQuantity> all = {
      threshold(report), width(report),
      rate(report, "lapse", fit.options.lapse, fit.function.lapse, report.lapse_ci95),
      rate(report, "guess", fit.options.guess, fit.function.guess, report.guess_ci95)};
  if (report.bootstrap && fit.options.lapse.is_free()) all[2].bootstrap_ci95 = report.bootstrap->lapse;
  all.push_back({.name = "overdispersion",
                 .unit = {},
                 .estimate = report.overdispersion.eta,
                 .ci95 = report.overdispersion.ci95,
                 .bootstrap_ci95 = {},
                 .reason = report.overdispersion.reason});
  return all;
}

std::vector<FitQuantity> percent_quantities(const JudgedFit& report) {
  std::vector<FitQuantity> all;
  for (const PercentLevel& level : report.percents) {
    FitQuantity quantity{.name = fmt::format("{:g}", level.percent),
                         .unit = report.request.unit,
                         .estimate = {},
                         .ci95 = level.level.ci95,
                         .bootstrap_ci95 = level.bootstrap_ci95,
                         .reason = {}};
    quantity.estimate = level.level.estimate;
    if (report.verdict.kind == Verdict::Kind::not_identified)
      quantity.reason = report.verdict.text;
    else if (!level.is_reached)
      quantity.reason = "never reached between the guess and the lapse rate";
    else if (!level.level.estimate)
      quantity.reason = "not identified: the interval is open";
    all.push_back(quantity);
  }
  return all;
}

const char* word(study::Direction direction) {
  return direction == study::Direction::increasing ? "increasing" : "decreasing";
}

const char* word(study::Axis axis) {
  return axis == study::Axis::log2 ? "log2" : "linear";
}

}  // namespace seamline::analysis
