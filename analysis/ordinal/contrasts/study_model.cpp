#include "analysis/ordinal/contrasts/study_model.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>

#include "analysis/ordinal/contrasts/condition_pairs.h"
#include "analysis/ordinal/contrasts/max_t.h"
#include "analysis/ordinal/contrasts/study_contrasts.h"
#include "analysis/ordinal/likelihood/mixed_fit.h"
#include "support/files/markdown_table.h"
#include "support/text/counted.h"
#include "support/text/csv.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// With fewer participants nobody should believe a standard error over participants.
constexpr int few_participants = 6;

/// Covariance of (cuts, coefficients) by the study's source of errors.
Eigen::MatrixXd covariance_of(const OrdinalStudy& study) {
  const Eigen::Index fixed = study.fit.cuts.size() + study.fit.coefficients.size();
  return study.errors == ErrorSource::participants ? study.fit.robust_covariance
                                                   : study.fit.covariance.topLeftCorner(fixed, fixed).eval();
}

std::vector<CoefficientRow> coefficient_rows(const OrdinalStudy& study, const Eigen::MatrixXd& covariance) {
  const OrdinalFit& fit = study.fit;
  const double df = study.errors == ErrorSource::participants ? study.design.participants - 1 : infinity;
  const double factor = two_sided_critical(0.05, df);
  std::vector<CoefficientRow> rows;
  const auto add = [&](const std::string& name, double estimate, double error, bool has_null) {
    rows.push_back({.name = name,
                    .estimate = estimate,
                    .standard_error = error,
                    .ci95_low = estimate - factor * error,
                    .ci95_high = estimate + factor * error,
                    .p = has_null ? two_sided_tail(estimate / error, df) : nan});
  };
  const Eigen::Index cuts = fit.cuts.size();
  for (Eigen::Index k = 0; k < cuts; ++k)
    add("cut " + fit.cut_names[k], fit.cuts[k], std::sqrt(covariance(k, k)), false);
  for (Eigen::Index j = 0; j < fit.coefficients.size(); ++j)
    add(fit.coefficient_names[j], fit.coefficients[j], std::sqrt(covariance(cuts + j, cuts + j)), true);
  CoefficientRow sd{.name = "SD of participants",
                    .estimate = fit.participant_sd,
                    .standard_error = nan,
                    .ci95_low = nan,
                    .ci95_high = nan,
                    .p = nan};
  if (const auto range = fit.participant_sd_ci95()) {
    sd.standard_error = std::sqrt(fit.covariance(fit.covariance.rows() - 1, fit.covariance.rows() - 1));
    sd.ci95_low = range->low;
    sd.ci95_high = range->high;
  }
  rows.push_back(sd);
  return rows;
}

OrdinalStudy fit_jointly(std::span<const study::Answer> answers, const ParticipantGroups& groups,
                         const OrdinalStudyRequest& request) {
  OrdinalStudy study{
      .design = study_design(answers, groups, request.reference_level, request.axis, request.conditions),
      .fit = {},
      .errors = ErrorSource::participants,
      .coefficients = {},
      .contrasts = {},
      .notes = {}};
  study.fit = fit_cumulative_link_mixed(study.design.data, request.fit);
  if (!study.fit.explanation.empty()) study.notes.push_back(study.fit.explanation);
  study.notes.insert(study.notes.end(), study.design.notes.begin(), study.design.notes.end());
  if (!has_estimates(study.fit.verdict)) return study;

  if (study.fit.robust_covariance.size() == 0) {
    study.errors = ErrorSource::model;
    study.notes.emplace_back(
        "Standard errors are the model's own: without one of the participants some effect cannot be "
        "estimated. They are too small when participants differ in more than their level.");
  }
  if (study.fit.participants < few_participants)
    study.notes.push_back(fmt::format(
        "{} participants are too few for errors over participants to be trusted.", study.fit.participants));
  const Eigen::MatrixXd covariance = covariance_of(study);
  study.coefficients = coefficient_rows(study, covariance);
  const Eigen::Index effects = study.fit.coefficients.size();
  for (ContrastFamily& family : study_contrasts(study.design, study.errors == ErrorSource::participants)) {
    family.odds_ratio = request.fit.link == Link::logit && family.differences;
    study.contrasts.push_back(test_contrasts(
        family, study.fit.coefficients, covariance.bottomRightCorner(effects, effects), request.correction));
  }
  return study;
}

/// Too many conditions for one model: artifacts over all conditions, conditions in pairs.
OrdinalStudy fit_in_pairs(std::span<const study::Answer> answers, const ParticipantGroups& groups,
                          const OrdinalStudyRequest& request, std::size_t cells) {
  std::vector<study::Answer> pooled(answers.begin(), answers.end());
  for (study::Answer& answer : pooled) answer.condition.clear();
  OrdinalStudyRequest of_artifacts = request;
  of_artifacts.conditions = {};
  OrdinalStudy study = fit_jointly(pooled, groups, of_artifacts);
  study.notes.push_back(fmt::format(
      "The study has {} artifacts in conditions, more than the {} that one model holds. So artifacts and "
      "objects are compared over all conditions together, and each condition with the first in a model of "
      "these two alone; p values of conditions are adjusted by Holm over all of them, and their intervals by "
      "Bonferroni.",
      cells, most_cells_of_a_model));
  ConditionPairs pairs = compare_condition_pairs(answers, groups, request, study.design.reference_level);
  std::move(pairs.tables.begin(), pairs.tables.end(), std::back_inserter(study.contrasts));
  std::move(pairs.notes.begin(), pairs.notes.end(), std::back_inserter(study.notes));
  return study;
}

}  // namespace

OrdinalStudy fit_ordinal_study(std::span<const study::Answer> answers, const ParticipantGroups& groups,
                               const OrdinalStudyRequest& request) {
  const std::size_t cells = count_cells(answers);
  return cells > most_cells_of_a_model ? fit_in_pairs(answers, groups, request, cells)
                                       : fit_jointly(answers, groups, request);
}

namespace {

CsvValue cell(double number) {
  return std::isnan(number) ? CsvValue{} : CsvValue{number};
}

/// Digits of a p value beyond the third are not known, whatever the arithmetic says.
CsvValue p_cell(double p) {
  if (std::isnan(p)) return {};
  return p < 0.001 ? std::string("< 0.001") : fmt::format("{:.3f}", p);
}

CsvTable coefficient_table(const OrdinalStudy& study) {
  CsvTable table{.name = "ordinal_coefficients",
                 .columns = {{"coefficient", "", ""},
                             {"estimate", "", ""},
                             {"SE", "", ""},
                             {"95 % from", "", ""},
                             {"to", "", ""},
                             {"p", "", ""}},
                 .rows = {}};
  for (const CoefficientRow& row : study.coefficients)
    table.rows.push_back({row.name, cell(row.estimate), cell(row.standard_error), cell(row.ci95_low),
                          cell(row.ci95_high), p_cell(row.p)});
  return table;
}

CsvTable contrast_table(const ContrastTable& contrasts) {
  CsvTable table{.name = "ordinal_contrasts",
                 .columns = {{"contrast", "", ""},
                             {"estimate", "", ""},
                             {"95 % from", "", ""},
                             {"to", "", ""},
                             {"p", "", ""},
                             {"adjusted p", "", ""},
                             {"verdict", "", ""}},
                 .rows = {}};
  for (const ContrastRow& row : contrasts.rows)
    table.rows.push_back({row.name, cell(row.estimate), cell(row.ci95_low), cell(row.ci95_high),
                          p_cell(row.p), p_cell(row.adjusted_p), std::string(word(row.verdict))});
  return table;
}

}  // namespace

std::string text_of(const OrdinalStudy& study) {
  const OrdinalFit& fit = study.fit;
  std::string text = fmt::format("Ordinal mixed model ({}, {}): {} of {}; {}.\n", word(fit.link),
                                 fit.nodes == 1 ? std::string("Laplace") : fmt::format("{} nodes", fit.nodes),
                                 counted(fit.observations, "answer"),
                                 counted(fit.participants, "participant"), word(fit.verdict));
  for (const std::string& note : study.notes) text += note + "\n";
  if (!has_estimates(fit.verdict)) return text;
  text +=
      fmt::format("log-likelihood {:.3f}, AIC {:.2f}; standard errors {}.\n\n", fit.log_likelihood, fit.aic,
                  study.errors == ErrorSource::participants ? "by leaving out each participant in turn"
                                                            : "from the curvature of the likelihood");
  text += markdown_table(coefficient_table(study));
  for (const ContrastTable& table : study.contrasts) {
    text += "\n" + table.question;
    if (table.joint_p && table.joint_contrasts > 1)
      text += fmt::format(" All {} independent contrasts together: {}.", table.joint_contrasts,
                          p_text(*table.joint_p));
    text += fmt::format(" Correction: {}.\n", word(table.correction)) + markdown_table(contrast_table(table));
    for (const ContrastRow& row : table.rows)
      if (row.verdict == ContrastVerdict::differs) text += row.conclusion + "\n";
  }
  return text;
}

}  // namespace seamline::analysis
