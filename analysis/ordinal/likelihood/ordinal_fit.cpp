#include "analysis/ordinal/likelihood/ordinal_fit.h"

#include <cmath>

#include "analysis/ordinal/likelihood/fit_steps.h"

namespace seamline::analysis {

namespace {

constexpr double z_975 = 1.959963984540054;

}  // namespace

std::string_view word(OrdinalVerdict verdict) {
  switch (verdict) {
    case OrdinalVerdict::estimated:
      return "estimated";
    case OrdinalVerdict::empty_scores:
      return "empty scores";
    case OrdinalVerdict::no_participant_variance:
      return "no participant variance";
    case OrdinalVerdict::constant_scores:
      return "constant scores";
    case OrdinalVerdict::one_participant:
      return "one participant";
    case OrdinalVerdict::singular_design:
      return "singular design";
    case OrdinalVerdict::separated:
      return "separated";
    case OrdinalVerdict::participants_separated:
      return "participants separated";
    case OrdinalVerdict::not_converged:
      return "not converged";
  }
  return {};
}

bool has_estimates(OrdinalVerdict verdict) {
  return verdict == OrdinalVerdict::estimated || verdict == OrdinalVerdict::empty_scores ||
         verdict == OrdinalVerdict::no_participant_variance;
}

std::optional<OrdinalFit::Range> OrdinalFit::participant_sd_ci95() const {
  const Eigen::Index fixed = cuts.size() + coefficients.size();
  if (!has_estimates(verdict) || covariance.rows() != fixed + 1) return std::nullopt;
  const double relative = z_975 * std::sqrt(covariance(fixed, fixed)) / participant_sd;
  return Range{.low = participant_sd * std::exp(-relative), .high = participant_sd * std::exp(relative)};
}

OrdinalFit fit_cumulative_link(const OrdinalData& data, const OrdinalRequest& request) {
  check_ordinal_data(data);
  const OrdinalProblem problem = prepare(data, false);
  OrdinalFit fit = begin_fit(data, problem, request);
  NewtonResult search;
  if (!can_be_fitted(data, problem, fit) || !maximise_fixed(data, problem, request, fit, search)) return fit;
  const Eigen::MatrixXd covariance = inverse_information(search.evaluation.hessian);
  if (covariance.size() == 0) {
    give_up(fit, OrdinalVerdict::not_converged, "The likelihood is flat at its maximum.");
    return fit;
  }
  write_estimates(problem, search.at, search.evaluation.value, static_cast<int>(search.at.size()), fit);
  fit.participant_sd = 0;
  fit.iterations = search.iterations;
  const Eigen::MatrixXd map = to_given_units(problem, false);
  fit.covariance = map * covariance * map.transpose();
  return fit;
}

}  // namespace seamline::analysis
