#include "analysis/ordinal/contrasts/contrasts.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/ordinal/contrasts/contrast_rows.h"
#include "analysis/ordinal/contrasts/contrasts_apart.h"
#include "analysis/ordinal/contrasts/max_t.h"
#include "analysis/statistics/distributions.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Eigenvalues of the correlation below this share of the largest are combinations of other contrasts.
constexpr double dependent_share = 1e-8;

/// Wald's test that all contrasts are 0. With t-like errors the statistic is Hotelling's T^2.
void write_joint_test(const Eigen::VectorXd& t, const Eigen::MatrixXd& correlation, ContrastTable& table) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlation);
  const Eigen::VectorXd& values = solver.eigenvalues();
  const double smallest = dependent_share * values[values.size() - 1];
  double statistic = 0;
  int rank = 0;
  for (Eigen::Index k = 0; k < values.size(); ++k) {
    if (values[k] <= smallest) continue;
    const double along = solver.eigenvectors().col(k).dot(t);
    statistic += along * along / values[k];
    ++rank;
  }
  table.joint_contrasts = rank;
  const double df = table.degrees_of_freedom;
  if (std::isinf(df)) {
    table.joint_p = chi_squared_above(rank, statistic);
  } else if (df - rank + 1 >= 1) {
    const double f = statistic * (df - rank + 1) / (df * rank);
    table.joint_p = fisher_above(rank, df - rank + 1, f);
  }
}

/// P of the adjusted value and the factor of the standard error, for those contrasts that have one.
void adjust(const Eigen::VectorXd& t, const Eigen::MatrixXd& correlation, std::vector<ContrastRow*>& rows,
            ContrastTable& table) {
  const double df = table.degrees_of_freedom;
  double factor = two_sided_critical(significance, df);
  switch (table.correction) {
    case Correction::single_step: {
      const MaxAbsT joint(correlation, df);
      for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i]->adjusted_p = joint.tail(std::abs(t[static_cast<Eigen::Index>(i)]));
      factor = joint.critical(significance);
      break;
    }
    case Correction::holm: {
      std::vector<double> p;
      for (const ContrastRow* row : rows) p.push_back(row->p);
      const std::vector<double> adjusted = holm_adjusted(p);
      for (std::size_t i = 0; i < rows.size(); ++i) rows[i]->adjusted_p = adjusted[i];
      break;
    }
  }
  for (ContrastRow* row : rows) {
    row->ci95_low = row->estimate - factor * row->standard_error;
    row->ci95_high = row->estimate + factor * row->standard_error;
  }
}

}  // namespace

std::string_view word(Correction correction) {
  switch (correction) {
    case Correction::single_step:
      return "single-step (multivariate t)";
    case Correction::holm:
      return "Holm";
  }
  return {};
}

std::string_view word(ContrastVerdict verdict) {
  switch (verdict) {
    case ContrastVerdict::differs:
      return "differs";
    case ContrastVerdict::not_shown:
      return "no difference shown";
    case ContrastVerdict::not_estimable:
      return "not estimable";
  }
  return {};
}

std::vector<double> holm_adjusted(const std::vector<double>& p) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!std::isnan(p[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size(), nan);
  double largest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(order.size() - rank) * p[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

std::string p_text(double p) {
  if (std::isnan(p)) return "p unknown";
  if (p < 0.001) return "p < 0.001";
  return fmt::format("p = {:.3f}", p);
}

ContrastTable test_contrasts(const ContrastFamily& family, const Eigen::VectorXd& coefficients,
                             const Eigen::MatrixXd& covariance, Correction correction) {
  if (family.contrasts.size() > static_cast<std::size_t>(most_joint_contrasts)) {
    const EstimatedContrasts all{.family = family, .coefficients = coefficients, .covariance = covariance};
    return test_contrasts_apart({&all, 1});
  }
  ContrastTable table = empty_table(family, correction);
  table.rows = estimated_rows(family, coefficients, covariance);
  std::vector<std::size_t> estimable;
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (!std::isnan(table.rows[i].standard_error)) estimable.push_back(i);
  if (estimable.empty()) return table;

  const auto count = static_cast<Eigen::Index>(estimable.size());
  Eigen::MatrixXd weights(count, coefficients.size());
  Eigen::VectorXd t(count);
  std::vector<ContrastRow*> rows;
  for (Eigen::Index i = 0; i < count; ++i) {
    ContrastRow& row = table.rows[estimable[i]];
    weights.row(i) = family.contrasts[estimable[i]].weights.transpose() / row.standard_error;
    t[i] = row.estimate / row.standard_error;
    rows.push_back(&row);
  }
  const Eigen::MatrixXd correlation = weights * covariance * weights.transpose();
  adjust(t, correlation, rows, table);
  write_joint_test(t, correlation, table);
  for (std::size_t i = 0; i < estimable.size(); ++i)
    conclude(family.contrasts[estimable[i]], family.odds_ratio, *rows[i]);
  return table;
}

}  // namespace seamline::analysis
