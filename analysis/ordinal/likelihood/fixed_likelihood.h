#pragma once
#include <Eigen/Core>

#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/newton.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"

namespace seamline::analysis {

/// Log-likelihood of the cumulative link model without participants, with exact gradient and Hessian in
/// (cuts, beta) (Agresti 2010, section 5.1):
///
///     log L = sum_i log( F(cut_{y_i} - x_i beta) - F(cut_{y_i - 1} - x_i beta) )
///
/// Concave in the parameters for both links (Pratt 1981). The same bits for any number of threads.
[[nodiscard]] Evaluation fixed_likelihood(const OrdinalProblem& problem, Link link,
                                          const Eigen::VectorXd& parameters, int threads);

/// Cuts that reproduce the shares of the scores, and slopes of 0: where every fit begins.
[[nodiscard]] Eigen::VectorXd null_parameters(const OrdinalProblem& problem, Link link);

}  // namespace seamline::analysis
