#include "analysis/ordinal/contrasts/contrast_rows.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/ordinal/contrasts/max_t.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

ContrastTable empty_table(const ContrastFamily& family, Correction correction) {
  return {.question = family.question,
          .correction = correction,
          .degrees_of_freedom = family.degrees_of_freedom,
          .rows = {},
          .joint_p = {},
          .joint_contrasts = 0};
}

std::vector<ContrastRow> estimated_rows(const ContrastFamily& family, const Eigen::VectorXd& coefficients,
                                        const Eigen::MatrixXd& covariance) {
  const bool known =
      covariance.size() > 0 && covariance.rows() == coefficients.size() && family.degrees_of_freedom >= 1;
  std::vector<ContrastRow> rows;
  for (const Contrast& contrast : family.contrasts) {
    ContrastRow row{.name = contrast.name,
                    .estimate = nan,
                    .standard_error = nan,
                    .ci95_low = nan,
                    .ci95_high = nan,
                    .p = nan,
                    .adjusted_p = nan,
                    .verdict = ContrastVerdict::not_estimable,
                    .conclusion = "Not estimable."};
    const double variance = known ? contrast.weights.dot(covariance * contrast.weights) : nan;
    if (std::isfinite(variance) && variance > 0) {
      row.estimate = contrast.weights.dot(coefficients);
      row.standard_error = std::sqrt(variance);
      row.p = two_sided_tail(row.estimate / row.standard_error, family.degrees_of_freedom);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void conclude(const Contrast& contrast, bool odds_ratio, ContrastRow& row) {
  row.verdict = row.adjusted_p < significance ? ContrastVerdict::differs : ContrastVerdict::not_shown;
  const std::string& said = row.verdict == ContrastVerdict::not_shown ? contrast.undecided
                            : row.estimate > 0                        ? contrast.more
                                                                      : contrast.less;
  const std::string odds =
      odds_ratio ? fmt::format("odds ratio {:.3g}, 95 % {:.3g} to {:.3g}, ", std::exp(row.estimate),
                               std::exp(row.ci95_low), std::exp(row.ci95_high))
                 : "";
  row.conclusion = fmt::format("{} ({}adjusted {}).", said, odds, p_text(row.adjusted_p));
}

}  // namespace seamline::analysis
