#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/ordinal/likelihood/link.h"
#include "analysis/ordinal/likelihood/ordinal_data.h"

namespace seamline::analysis {

/// What may be believed of a fit. After the first three nothing is estimated: a fit without a maximum has no
/// numbers.
enum class OrdinalVerdict {
  estimated,                ///< a unique maximum was found
  empty_scores,             ///< estimated, but some scores of the scale were never given
  no_participant_variance,  ///< estimated; the participants' standard deviation is at its bound 0
  constant_scores,          ///< every score is the same: nothing to explain
  one_participant,          ///< a standard deviation over participants needs two
  singular_design,          ///< predictors that cannot be told apart, or from the cuts
  separated,                ///< the likelihood rises for ever in some direction of the predictors
  participants_separated,   ///< the same once each participant has an effect of their own
  not_converged             ///< no maximum was found, and no reason
};

[[nodiscard]] std::string_view word(OrdinalVerdict verdict);

/// Whether there are numbers.
[[nodiscard]] bool has_estimates(OrdinalVerdict verdict);

struct OrdinalRequest {
  Link link = Link::logit;
  int nodes = 15;   ///< of the adaptive Gauss-Hermite rule, 1 to 100; 1 is the Laplace approximation
  int threads = 0;  ///< 0: as many as the machine has
};

/// A cumulative link model, P(Y <= k | x, u) = F(cut_k - x beta - u), u ~ Normal(0, sd^2) a participant. A
/// positive coefficient raises the score.
struct OrdinalFit {
  OrdinalVerdict verdict = OrdinalVerdict::not_converged;
  std::string explanation;  ///< a sentence for every verdict but `estimated`
  Link link = Link::logit;
  int nodes = 0;  ///< 0 when the model has no participants
  int observations = 0;
  int participants = 0;  ///< 0 when the model has none
  std::vector<int> used_scores, empty_scores;
  std::vector<std::string> cut_names;          ///< "0|1", ...
  std::vector<std::string> coefficient_names;  ///< of the predictors

  // Empty or NaN unless has_estimates(verdict):
  Eigen::VectorXd cuts;          ///< link units, rising
  Eigen::VectorXd coefficients;  ///< link units per unit of the predictor
  double participant_sd = 0;     ///< link units; 0 when the model has no participants
  double log_likelihood = 0;     ///< of the approximated integral
  double aic = 0;
  /// Of (cuts, coefficients, participant_sd) from the inverse Hessian; no row for the sd when the model has
  /// none or when it is 0.
  Eigen::MatrixXd covariance;
  /// Of (cuts, coefficients) by leaving out one participant at a time (mixed_fit.cpp); empty without
  /// participants or when the fit hangs on a single one.
  Eigen::MatrixXd robust_covariance;
  Eigen::VectorXd participant_effect;  ///< conditional mode in link units, in order of participant number
  int iterations = 0;

  /// 95 % interval of the sd, exp(log sd -+ 1.96 se / sd); nullopt when it is 0 or not in the model.
  struct Range {
    double low = 0, high = 0;
  };
  [[nodiscard]] std::optional<Range> participant_sd_ci95() const;
};

/// Maximum likelihood without participants (R: ordinal::clm). Throws InputError as check_ordinal_data.
[[nodiscard]] OrdinalFit fit_cumulative_link(const OrdinalData& data, const OrdinalRequest& request);

}  // namespace seamline::analysis
