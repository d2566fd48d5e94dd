#pragma once
#include <Eigen/Core>

#include "analysis/ordinal/likelihood/gauss_hermite.h"
#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"
#include "analysis/ordinal/likelihood/row_terms.h"

namespace seamline::analysis {

/// One participant's rows at one place of the parameters, as a function of the standard normal effect v:
/// h(v) = sum_i log P_i(v) - v^2 / 2.
class ParticipantIntegral {
 public:
  /// `x_beta` has an entry for each row of the problem. The arguments must outlive this object.
  ParticipantIntegral(const OrdinalProblem& problem, Link link, const Eigen::VectorXd& parameters,
                      const Eigen::VectorXd& x_beta, RowRange rows);

  [[nodiscard]] bool valid() const { return valid_; }  ///< false where cuts are out of order
  [[nodiscard]] double mode() const { return mode_; }

  /// log of the integral by adaptive quadrature, and its exact gradient in (cuts, beta, sd). With v_q = mode
  /// + sqrt(2) tau z_q and tau = (-h'')^(-1/2) at the mode:
  ///
  ///     value    = log tau - log(pi) / 2 + log sum_q w_q exp(z_q^2 + h(v_q))
  ///     gradient = d tau / tau + sum_q p_q [ h_theta(v_q) + h'(v_q) (d mode + sqrt(2) z_q d tau) ]
  [[nodiscard]] double value_and_gradient(const GaussHermite& rule, Eigen::VectorXd& gradient) const;

  /// Louis' identity on the nodes of the rule.
  [[nodiscard]] Eigen::MatrixXd hessian(const GaussHermite& rule) const;

 private:
  struct AtEffect;  ///< sums and per-row terms at one v
  struct Nodes;     ///< effects and posterior weights of the nodes

  [[nodiscard]] AtEffect at(double v) const;
  void find_mode();
  [[nodiscard]] Nodes nodes(const GaussHermite& rule) const;
  [[nodiscard]] Eigen::VectorXd score(const AtEffect& terms, double v) const;  ///< h_theta(v)

  const OrdinalProblem& problem_;
  Link link_;
  RowRange rows_;
  double sd_ = 0;
  Eigen::Index size_ = 0;      ///< of the parameters
  std::vector<RowEnds> ends_;  ///< without the effect
  bool valid_ = true;
  double mode_ = 0;
  double tau_ = 1;
};

}  // namespace seamline::analysis
