#include "analysis/psychometric/report/fit_text.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/psychometric/report/fit_quantities.h"
#include "support/files/markdown_table.h"
#include "support/text/counted.h"

namespace seamline::analysis {

namespace {

std::string interval_text(const Interval& ci95) {
  const auto end = [](double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "open"; };
  return end(ci95.low) + " to " + end(ci95.high);
}

CsvTable quantities_table(const JudgedFit& report) {
  CsvTable table{.name = "fit",
                 .columns = {{"quantity", "", ""}, {"estimate", "", ""}, {"95 % interval", "", ""}},
                 .rows = {}};
  if (report.bootstrap) table.columns.push_back({"bootstrap (BCa)", "", ""});
  table.columns.push_back({"unit", "", ""});
  table.columns.push_back({"remark", "", ""});
  std::vector<FitQuantity> all = quantities(report);
  for (FitQuantity& quantity : percent_quantities(report)) {
    quantity.name += report.request.answers_are_yes ? " % yes" : " % correct";
    all.push_back(quantity);
  }
  for (const FitQuantity& quantity : all) {
    std::vector<CsvValue> row = {
        quantity.name, quantity.estimate ? CsvValue(*quantity.estimate) : CsvValue(std::monostate{}),
        interval_text(quantity.ci95)};
    if (report.bootstrap)
      row.push_back(quantity.bootstrap_ci95 ? CsvValue(interval_text(*quantity.bootstrap_ci95))
                                            : CsvValue(std::monostate{}));
    row.push_back(quantity.unit);
    row.push_back(quantity.reason);
    table.rows.push_back(row);
  }
  return table;
}

CsvTable levels_table(const Goodness& goodness, bool answers_are_yes) {
  CsvTable table{.name = "levels",
                 .columns = {{"level", "", ""},
                             {answers_are_yes ? "yes" : "correct", "", ""},
                             {"trials", "", ""},
                             {"share", "", ""},
                             {"fitted", "", ""},
                             {"residual", "", ""}},
                 .rows = {}};
  for (const LevelResidual& level : goodness.residuals) {
    const double residual = level.deviance_residual;
    table.rows.push_back({level.counts.level, level.counts.correct, level.counts.trials, level.counts.share(),
                          level.fitted, std::abs(residual) < 1e-6 ? 0.0 : residual});  // what rounding leaves
  }
  return table;
}

/// What p is of, or why there is none.
std::string deviance_text(const JudgedFit& report) {
  const Goodness& goodness = report.goodness;
  std::string text = fmt::format("deviance {:.3f}", goodness.deviance);
  if (goodness.degrees_of_freedom >= 0)
    text += fmt::format(" on {} of freedom", counted(goodness.degrees_of_freedom, "degree"));
  if (goodness.groups.size() < report.fit.levels.size())
    text += fmt::format(" ({} levels in {} groups of neighbours)", report.fit.levels.size(),
                        goodness.groups.size());
  if (!std::isnan(report.deviance_p)) return text + fmt::format(", p = {:.3g}", report.deviance_p);
  if (report.fit.options.overdispersed) return text + ", not tested: the fit is overdispersed";
  if (goodness.degrees_of_freedom <= 0)
    return text + fmt::format(", not tested: {} of answers for {}", counted(goodness.groups.size(), "group"),
                              counted(report.fit.free_parameters, "free parameter"));
  return text;
}

}  // namespace

std::string fit_text(const JudgedFit& report) {
  const PsychometricFit& fit = report.fit;
  std::string text = fmt::format("Threshold: {}\n\n", report.verdict.text);
  text += markdown_table(quantities_table(report), 5) + "\n";
  if (!fit.levels.empty()) {
    text += markdown_table(levels_table(report.goodness, report.request.answers_are_yes), 4) + "\n";
    text += fmt::format("{} {} function, {} axis. Log-likelihood {:.4f}, AIC {:.2f}, {}.\n",
                        word(fit.direction), word(fit.options.sigmoid), word(fit.options.axis),
                        fit.log_likelihood, report.goodness.aic, deviance_text(report));
  }
  for (const std::string& warning : report.warnings) text += "Warning: " + warning + ".\n";
  return text;
}

}  // namespace seamline::analysis
