#pragma once
#include <Eigen/Core>
#include <vector>

#include "analysis/ordinal/likelihood/gauss_hermite.h"
#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/newton.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"

namespace seamline::analysis {

/// A participant's part of the marginal log-likelihood.
struct ParticipantPart {
  Evaluation part;
  double mode = 0;  ///< of the standard normal effect v given the data; the participant's effect is sd v
};

/// How the integral over a participant's effect is taken. Both rules are adaptive: centred at the
/// participant's mode and scaled by the curvature there (Pinheiro and Chao 2006).
struct Quadrature {
  GaussHermite likelihood;  ///< one node is the Laplace approximation
  GaussHermite hessian;     ///< of more nodes, because a Hessian needs the spread between nodes
  explicit Quadrature(int nodes);
};

/// The marginal log-likelihood of the cumulative link model with a random intercept, in (cuts, beta, sd):
///
///     log L = sum_p log integral phi(v) prod_i P(y_i | eta_i = x_i beta + sd v) dv
///
/// `gradient` is the exact gradient of the approximated value, with the motion of the nodes. `hessian` is by
/// Louis' identity (1982), E[d2 log P] + Var[d log P] over v given the data, on the nodes of
/// `quadrature.hessian`: the Hessian of the integral itself. The sign of sd does not matter. The same bits
/// for any number of threads.
[[nodiscard]] Evaluation marginal_likelihood(const OrdinalProblem& problem, Link link,
                                             const Quadrature& quadrature, const Eigen::VectorXd& parameters,
                                             int threads);

/// The same, each participant's part on its own.
[[nodiscard]] std::vector<ParticipantPart> participant_parts(const OrdinalProblem& problem, Link link,
                                                             const Quadrature& quadrature,
                                                             const Eigen::VectorXd& parameters, int threads);

}  // namespace seamline::analysis
