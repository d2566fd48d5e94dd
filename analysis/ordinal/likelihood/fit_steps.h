#pragma once
#include <Eigen/Core>
#include <string>

#include "analysis/ordinal/likelihood/newton.h"
#include "analysis/ordinal/likelihood/ordinal_fit.h"

namespace seamline::analysis {

// The steps that fits with and without participants share.

constexpr int most_newton_iterations = 100;

/// A fit without numbers: what the data are.
[[nodiscard]] OrdinalFit begin_fit(const OrdinalData& data, const OrdinalProblem& problem,
                                   const OrdinalRequest& request);

void give_up(OrdinalFit& fit, OrdinalVerdict verdict, std::string explanation);

/// False, with a verdict, for data to which no model can be fitted.
[[nodiscard]] bool can_be_fitted(const OrdinalData& data, const OrdinalProblem& problem, OrdinalFit& fit);

/// The fixed effects' maximum in `search`; false, with a verdict, when there is none.
[[nodiscard]] bool maximise_fixed(const OrdinalData& data, const OrdinalProblem& problem,
                                  const OrdinalRequest& request, OrdinalFit& fit, NewtonResult& search);

/// Inverse of minus the Hessian; empty when it is not positive definite with room for rounding.
[[nodiscard]] Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& hessian);

/// Cuts, coefficients and likelihood in the units given, from (cuts, beta) of the problem's own.
void write_estimates(const OrdinalProblem& problem, const Eigen::VectorXd& fixed, double log_likelihood,
                     int parameters, OrdinalFit& fit);

}  // namespace seamline::analysis
