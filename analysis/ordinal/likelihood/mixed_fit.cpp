#include "analysis/ordinal/likelihood/mixed_fit.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "analysis/ordinal/likelihood/fit_steps.h"
#include "analysis/ordinal/likelihood/marginal_likelihood.h"
#include "support/text/error.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Below this (in link units) the participants' standard deviation is at its bound.
constexpr double smallest_sd = 1e-4;
/// Above this participants' effects decide every answer: odds differ by e^30 between people.
constexpr double largest_sd = 30;

/// Covariance of the parameters by the jackknife over participants, each left-out estimate by one Newton step
/// from the maximum (Bell and McCaffrey 2002: CR3, the cautious one of the cluster-robust estimators):
///
///     theta_(p) - theta = (H - H_p)^{-1} g_p,     V = (n - 1) / n sum_p (theta_(p) - mean)(...)'
///
/// g_p, H_p are the gradient and Hessian of participant p's part, H their sum. Unlike the inverse Hessian it
/// stays right when participants differ in more than their level (in the slope over width, in how much one
/// artifact disturbs them), or when the link is not quite right. Empty with fewer than three participants or
/// when H - H_p is not negative definite: the fit hangs on participant p.
Eigen::MatrixXd jackknife_covariance(const std::vector<ParticipantPart>& parts) {
  if (parts.size() < 3) return {};
  const Eigen::Index size = parts.front().part.gradient.size();
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
  for (const ParticipantPart& one : parts) hessian += one.part.hessian;
  Eigen::MatrixXd moved(size, static_cast<Eigen::Index>(parts.size()));
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Eigen::LLT<Eigen::MatrixXd> factor(parts[p].part.hessian - hessian);
    // A tiny pivot is rounding: the others say nothing about some direction.
    if (factor.info() != Eigen::Success ||
        factor.matrixLLT().diagonal().cwiseAbs2().minCoeff() < 1e-9 * -hessian.diagonal().maxCoeff())
      return {};
    moved.col(static_cast<Eigen::Index>(p)) = -factor.solve(parts[p].part.gradient);
  }
  const double n = parts.size();
  const Eigen::VectorXd mean = moved.rowwise().mean();
  moved.colwise() -= mean;
  return (n - 1) / n * (moved * moved.transpose());
}

/// Covariances and participants' effects at the maximum.
bool write_uncertainty(const OrdinalProblem& problem, const OrdinalRequest& request,
                       const Quadrature& quadrature, const NewtonResult& search, OrdinalFit& fit) {
  const bool at_bound = fit.participant_sd == 0;
  const Eigen::Index size = search.at.size() - (at_bound ? 1 : 0);
  const Eigen::MatrixXd covariance = inverse_information(search.evaluation.hessian.topLeftCorner(size, size));
  if (covariance.size() == 0) {
    give_up(fit, OrdinalVerdict::not_converged, "The likelihood is flat at its maximum.");
    return false;
  }
  const Eigen::MatrixXd map = to_given_units(problem, !at_bound);
  fit.covariance = map * covariance * map.transpose();

  std::vector<ParticipantPart> parts =
      participant_parts(problem, request.link, quadrature, search.at, request.threads);
  fit.participant_effect.resize(problem.participants());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    fit.participant_effect[static_cast<Eigen::Index>(p)] = search.at[search.at.size() - 1] * parts[p].mode;
    parts[p].part.gradient.conservativeResize(size);
    parts[p].part.hessian.conservativeResize(size, size);
  }
  const Eigen::MatrixXd robust = jackknife_covariance(parts);
  if (robust.size() == 0) return true;
  const Eigen::MatrixXd all = map * robust * map.transpose();
  const Eigen::Index fixed = search.at.size() - 1;
  fit.robust_covariance = all.topLeftCorner(fixed, fixed);
  return true;
}

/// The maximum with participants, or false with a verdict.
bool maximise_mixed(const OrdinalProblem& problem, const OrdinalRequest& request,
                    const Quadrature& quadrature, OrdinalFit& fit, NewtonResult& search) {
  Eigen::VectorXd start(search.at.size() + 1);
  start << search.at, request.link == Link::logit ? 0.7 : 0.4;
  const auto likelihood = [&](const Eigen::VectorXd& parameters) {
    Evaluation evaluation =
        marginal_likelihood(problem, request.link, quadrature, parameters, request.threads);
    if (std::abs(parameters[parameters.size() - 1]) > 4 * largest_sd) evaluation.value = -infinity;
    return evaluation;
  };
  search = maximise(likelihood, start, most_newton_iterations);
  double& sd = search.at[search.at.size() - 1];
  if (sd < 0) {  // the likelihood is even in the sd
    sd = -sd;
    search.evaluation = likelihood(search.at);
  }
  if (sd > largest_sd || (!search.converged && sd > largest_sd / 3)) {
    give_up(
        fit, OrdinalVerdict::participants_separated,
        "Within participants the scores are separated: the participants' standard deviation grows without "
        "end.");
    return false;
  }
  if (!search.converged) {
    give_up(fit, OrdinalVerdict::not_converged, "The likelihood's maximum was not found.");
    return false;
  }
  return true;
}

}  // namespace

OrdinalFit fit_cumulative_link_mixed(const OrdinalData& data, const OrdinalRequest& request) {
  check_ordinal_data(data);
  if (data.participant.empty())
    throw input_error({.field = "participants", .wanted = "a number for each score", .found = "none"});
  if (request.nodes < 1 || request.nodes > 100)
    throw input_error(
        {.field = "nodes", .wanted = "1 (Laplace) to 100", .found = std::to_string(request.nodes)});
  const OrdinalProblem problem = prepare(data, true);
  OrdinalFit fit = begin_fit(data, problem, request);
  fit.nodes = request.nodes;
  fit.participants = problem.participants();
  if (problem.participants() < 2) {
    give_up(fit, OrdinalVerdict::one_participant,
            "There is one participant: how much participants differ cannot be estimated.");
    return fit;
  }
  NewtonResult search;
  if (!can_be_fitted(data, problem, fit) || !maximise_fixed(data, problem, request, fit, search)) return fit;
  const Quadrature quadrature(request.nodes);
  if (!maximise_mixed(problem, request, quadrature, fit, search)) return fit;

  const Eigen::Index fixed = search.at.size() - 1;
  write_estimates(problem, search.at.head(fixed), search.evaluation.value, static_cast<int>(fixed) + 1, fit);
  fit.iterations = search.iterations;
  fit.participant_sd = std::abs(search.at[fixed]);
  if (fit.participant_sd < smallest_sd) {
    fit.participant_sd = 0;
    fit.verdict = OrdinalVerdict::no_participant_variance;
    fit.explanation += (fit.explanation.empty() ? "" : " ") +
                       std::string(
                           "Participants do not differ more than chance: their standard deviation is "
                           "0, its bound.");
  }
  if (!write_uncertainty(problem, request, quadrature, search, fit)) {
    fit.cuts = fit.coefficients = {};
    fit.participant_sd = fit.log_likelihood = fit.aic = nan;
    fit.participant_effect = {};
  }
  return fit;
}

}  // namespace seamline::analysis
