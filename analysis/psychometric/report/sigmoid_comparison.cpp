#include "analysis/psychometric/report/sigmoid_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/report/fit_json.h"
#include "analysis/psychometric/report/fit_text.h"
#include "support/files/markdown_table.h"

namespace seamline::analysis {

namespace {

double aic_difference(const SigmoidComparison& comparison, const JudgedFit& fit) {
  return fit.goodness.aic - comparison.fits.front().goodness.aic;
}

double akaike_weight(const SigmoidComparison& comparison, const JudgedFit& fit) {
  double sum = 0;
  for (const JudgedFit& one : comparison.fits) sum += std::exp(-aic_difference(comparison, one) / 2);
  return std::exp(-aic_difference(comparison, fit) / 2) / sum;
}

bool has_width(const JudgedFit& fit) {
  return fit.threshold && !fit.fit.is_step && std::isfinite(fit.width_ci95.high);
}

}  // namespace

SigmoidComparison compare_sigmoids(const std::vector<LevelCounts>& counts, const FitOptions& options,
                                   const FitRequest& request) {
  SigmoidComparison comparison;
  FitRequest plain = request;
  plain.bootstrap_replicates = 0;
  FitOptions with = options;
  for (const Sigmoid sigmoid : every_sigmoid) {
    with.sigmoid = sigmoid;
    comparison.fits.push_back(judge_fit(counts, with, plain));
  }
  std::stable_sort(comparison.fits.begin(), comparison.fits.end(),
                   [](const JudgedFit& a, const JudgedFit& b) { return a.goodness.aic < b.goodness.aic; });
  if (request.bootstrap_replicates > 0)
    comparison.fits.front() = judge_fit(counts, comparison.fits.front().fit.options, request);
  return comparison;
}

std::string comparison_text(const SigmoidComparison& comparison) {
  CsvTable table{.name = "sigmoids", .columns = {}, .rows = {}};
  for (const char* column : {"sigmoid", "AIC", "difference", "weight", "deviance p", "threshold",
                             "95 % interval", "width", "verdict"})
    table.columns.push_back({column, "", ""});
  const auto or_empty = [](bool is, double value) {
    return is && std::isfinite(value) ? CsvValue(fmt::format("{:.4g}", value)) : CsvValue(std::monostate{});
  };
  const auto end = [](double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "open"; };
  for (const JudgedFit& fit : comparison.fits) {
    if (fit.fit.levels.empty()) return fit_text(fit);
    table.rows.push_back({std::string(word(fit.fit.options.sigmoid)), fmt::format("{:.2f}", fit.goodness.aic),
                          fmt::format("{:.2f}", aic_difference(comparison, fit)),
                          fmt::format("{:.2f}", akaike_weight(comparison, fit)),
                          or_empty(true, fit.deviance_p),
                          or_empty(fit.threshold.has_value(), fit.threshold.value_or(0)),
                          end(fit.threshold_ci95.low) + " to " + end(fit.threshold_ci95.high),
                          or_empty(has_width(fit), fit.fit.width), fit.verdict.text});
  }
  return "Sigmoids, lowest AIC first; the weight is the share of belief that AIC gives to each of these "
         "three:\n\n" +
         markdown_table(table, 5) + "\nThe first of them:\n\n" + fit_text(comparison.fits.front());
}

std::string comparison_json(const SigmoidComparison& comparison) {
  using SigmoidJson = nlohmann::ordered_json;
  const auto or_null = [](bool is, double value) {
    return is && std::isfinite(value) ? SigmoidJson(value) : SigmoidJson(nullptr);
  };
  SigmoidJson json = SigmoidJson::parse(fit_json(comparison.fits.front()));
  json["sigmoids"] = SigmoidJson::array();
  for (const JudgedFit& fit : comparison.fits) {
    if (fit.fit.levels.empty()) break;
    json["sigmoids"].push_back(
        {{"sigmoid", word(fit.fit.options.sigmoid)},
         {"log_likelihood", fit.fit.log_likelihood},
         {"aic", fit.goodness.aic},
         {"aic_difference", aic_difference(comparison, fit)},
         {"weight", akaike_weight(comparison, fit)},
         {"deviance_p", or_null(true, fit.deviance_p)},
         {"threshold", or_null(fit.threshold.has_value(), fit.threshold.value_or(0))},
         {"threshold_ci95", {or_null(true, fit.threshold_ci95.low), or_null(true, fit.threshold_ci95.high)}},
         {"width", or_null(has_width(fit), fit.fit.width)},
         {"verdict", fit.verdict.text}});
  }
  return json.dump(2, ' ', false, SigmoidJson::error_handler_t::replace) + "\n";
}

}  // namespace seamline::analysis
