#include "analysis/ordinal/likelihood/fit_steps.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>

#include "analysis/ordinal/likelihood/fixed_likelihood.h"
#include "analysis/ordinal/likelihood/separation.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

constexpr double rank_tolerance = 1e-9;

std::string quoted(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "'" : ", '") + word + "'";
  return text;
}

/// Names of columns that are combinations of the others (a constant is a combination of the cuts).
std::vector<std::string> dependent_columns(const OrdinalData& data, const OrdinalProblem& problem) {
  std::vector<std::string> names;
  if (problem.x.cols() == 0) return names;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(problem.x.rows(), problem.x.cols());
  qr.setThreshold(rank_tolerance);
  qr.compute(problem.x);
  for (Eigen::Index j = qr.rank(); j < problem.x.cols(); ++j)
    names.push_back(data.predictor_names[qr.colsPermutation().indices()[j]]);
  return names;
}

}  // namespace

OrdinalFit begin_fit(const OrdinalData& data, const OrdinalProblem& problem, const OrdinalRequest& request) {
  OrdinalFit fit;
  fit.link = request.link;
  fit.observations = static_cast<int>(problem.rows());
  fit.used_scores = problem.used_scores;
  fit.empty_scores = problem.empty_scores;
  fit.cut_names = cut_names(problem);
  fit.coefficient_names = data.predictor_names;
  fit.participant_sd = fit.log_likelihood = fit.aic = nan;
  return fit;
}

void give_up(OrdinalFit& fit, OrdinalVerdict verdict, std::string explanation) {
  fit.verdict = verdict;
  fit.explanation = std::move(explanation);
}

bool can_be_fitted(const OrdinalData& data, const OrdinalProblem& problem, OrdinalFit& fit) {
  if (problem.categories() < 2) {
    give_up(fit, OrdinalVerdict::constant_scores,
            fmt::format("Every one of the {} scores is {}, so there is nothing to explain.", problem.rows(),
                        problem.used_scores.front()));
    return false;
  }
  if (const auto names = dependent_columns(data, problem); !names.empty()) {
    give_up(fit, OrdinalVerdict::singular_design,
            fmt::format("The effect of {} cannot be told apart from the other effects.", quoted(names)));
    return false;
  }
  return true;
}

bool maximise_fixed(const OrdinalData& data, const OrdinalProblem& problem, const OrdinalRequest& request,
                    OrdinalFit& fit, NewtonResult& search) {
  const auto likelihood = [&](const Eigen::VectorXd& parameters) {
    return fixed_likelihood(problem, request.link, parameters, request.threads);
  };
  search = maximise(likelihood, null_parameters(problem, request.link), most_newton_iterations);
  const Separation separation = look_for_separation(problem, request.link, search);
  if (separation.found) {
    std::vector<std::string> names;
    for (Eigen::Index j = 0; j < problem.x.cols(); ++j)
      if (std::abs(separation.direction[problem.cuts() + j]) > 0.05) names.push_back(data.predictor_names[j]);
    give_up(
        fit, OrdinalVerdict::separated,
        fmt::format("The scores are separated by {}: the likelihood rises without end, so the estimate is "
                    "infinite.",
                    names.empty() ? "the predictors" : quoted(names)));
    return false;
  }
  if (!search.converged) {
    give_up(fit, OrdinalVerdict::not_converged, "The likelihood's maximum was not found.");
    return false;
  }
  return true;
}

Eigen::MatrixXd inverse_information(const Eigen::MatrixXd& hessian) {
  const Eigen::VectorXd scale = (-hessian.diagonal()).cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return {};
  const Eigen::MatrixXd scaled = scale.asDiagonal() * (-hessian) * scale.asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> factor(scaled);
  if (factor.info() != Eigen::Success ||
      factor.matrixLLT().diagonal().minCoeff() < 1e-6)  // square root of a share of variance
    return {};
  const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols()));
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

void write_estimates(const OrdinalProblem& problem, const Eigen::VectorXd& fixed, double log_likelihood,
                     int parameters, OrdinalFit& fit) {
  const Eigen::VectorXd given = to_given_units(problem, false) * fixed;
  fit.cuts = given.head(problem.cuts());
  fit.coefficients = given.tail(problem.x.cols());
  fit.log_likelihood = log_likelihood;
  fit.aic = 2 * parameters - 2 * log_likelihood;
  fit.verdict = OrdinalVerdict::estimated;
  if (fit.empty_scores.empty()) return;
  std::string scores;
  for (const int score : fit.empty_scores) scores += (scores.empty() ? "" : ", ") + std::to_string(score);
  fit.verdict = OrdinalVerdict::empty_scores;
  fit.explanation = fmt::format(
      "Nobody gave the score {}: the cuts beside it are not known apart, and the scale is fitted without it.",
      scores);
}

}  // namespace seamline::analysis
