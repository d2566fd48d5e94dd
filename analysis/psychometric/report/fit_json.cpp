#include "analysis/psychometric/report/fit_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/report/fit_quantities.h"
#include "support/files/assets.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

Json quantity_json(const FitQuantity& quantity) {
  Json json;
  json["estimate"] = quantity.estimate ? number_or_null(*quantity.estimate) : Json(nullptr);
  json["ci95"] = ends_json(quantity.ci95);
  if (quantity.bootstrap_ci95) json["bootstrap_ci95"] = ends_json(*quantity.bootstrap_ci95);
  if (!quantity.unit.empty()) json["unit"] = quantity.unit;
  json["reason"] = quantity.reason.empty() ? Json(nullptr) : Json(quantity.reason);
  return json;
}

const char* kind_word(Verdict::Kind kind) {
  switch (kind) {
    case Verdict::Kind::identified:
      return "identified";
    case Verdict::Kind::below:
      return "below";
    case Verdict::Kind::above:
      return "above";
    case Verdict::Kind::between:
      return "between";
    case Verdict::Kind::not_identified:
      return "not_identified";
  }
  return "";
}

Json rate_json(const Rate& rate) {
  return rate.is_free() ? Json{{"free_to", rate.high}} : Json{{"fixed", rate.low}};
}

Json model_json(const JudgedFit& report) {
  const FitOptions& options = report.fit.options;
  return {
      {"sigmoid", word(options.sigmoid)},
      {"axis", word(options.axis)},
      {"direction", report.fit.levels.empty() ? Json(nullptr) : Json(word(report.fit.direction))},
      {"direction_given", options.direction.has_value()},
      {"guess", rate_json(options.guess)},
      {"lapse", rate_json(options.lapse)},
      {"overdispersed", options.overdispersed},
      {"maximum_a_posteriori", options.priors.threshold || options.priors.log2_width || options.priors.lapse},
      {"free_parameters", report.fit.free_parameters}};
}

Json levels_json(const Goodness& goodness) {
  Json levels = Json::array();
  for (const LevelResidual& level : goodness.residuals)
    levels.push_back({{"level", level.counts.level},
                      {"correct", level.counts.correct},
                      {"trials", level.counts.trials},
                      {"fitted", number_or_null(level.fitted)},
                      {"deviance_residual", number_or_null(level.deviance_residual)}});
  return levels;
}

Json groups_json(const Goodness& goodness) {
  Json groups = Json::array();
  for (const LevelGroup& group : goodness.groups)
    groups.push_back({{"low", number_or_null(group.low)},
                      {"high", number_or_null(group.high)},
                      {"correct", group.correct},
                      {"trials", group.trials},
                      {"expected", number_or_null(group.expected)},
                      {"deviance_residual", number_or_null(group.deviance_residual)}});
  return groups;
}

}  // namespace

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json ends_json(const Interval& ci95) {
  return Json::array({number_or_null(ci95.low), number_or_null(ci95.high)});
}

std::string fit_json(const JudgedFit& report) {
  Json json;
  json["format"] = "seamline psychometric fit";
  json["version"] = 1;
  json["program_version"] = program_version();
  json["model"] = model_json(report);
  json["verdict"] = report.verdict.text;
  json["verdict_kind"] = kind_word(report.verdict.kind);
  json["threshold_range"] = ends_json(report.verdict.range);
  for (const FitQuantity& quantity : quantities(report)) json[quantity.name] = quantity_json(quantity);
  if (!report.percents.empty()) {
    json["percent_correct"] = Json::array();
    for (const FitQuantity& quantity : percent_quantities(report)) {
      Json level = {{"percent", std::stod(quantity.name)}};
      level.update(quantity_json(quantity));
      json["percent_correct"].push_back(level);
    }
  }
  const bool empty = report.fit.levels.empty();
  json["log_likelihood"] = empty ? Json(nullptr) : number_or_null(report.fit.log_likelihood);
  json["deviance"] = empty ? Json(nullptr) : number_or_null(report.goodness.deviance);
  json["deviance_p"] = number_or_null(report.deviance_p);
  json["degrees_of_freedom"] = report.goodness.degrees_of_freedom;
  json["aic"] = empty ? Json(nullptr) : number_or_null(report.goodness.aic);
  json["levels"] = levels_json(report.goodness);
  json["deviance_groups"] = groups_json(report.goodness);
  json["warnings"] = report.warnings;
  json["converged"] = report.fit.converged;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace seamline::analysis
