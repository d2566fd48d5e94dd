#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/text/numbers.h"

namespace seamline::analysis {

/// How p values are adjusted for the number of contrasts in a family. Both hold the chance of any false
/// "differs" in the family at 5 %.
enum class Correction {
  single_step,  ///< by the contrasts' joint distribution, multivariate t; has simultaneous intervals
  holm          ///< Holm (1979); needs no joint distribution, has no simultaneous intervals
};

[[nodiscard]] std::string_view word(Correction correction);

/// A difference of interest: weights on the coefficients.
struct Contrast {
  std::string name;  ///< "occlusion - receiver at 512 px"
  Eigen::VectorXd weights;
  std::string more;  ///< what is concluded when the estimate is positive
  std::string less;  ///< when it is negative
  std::string undecided;
};

/// The contrasts that one question is answered by, corrected together.
struct ContrastFamily {
  std::string question;  ///< "Do artifacts differ at 512 px?"
  std::vector<Contrast> contrasts;
  double degrees_of_freedom = infinity;
  bool differences = false;  ///< of levels, not of slopes
  bool odds_ratio = false;   ///< conclusions give exp(estimate): the odds of a higher score
};

enum class ContrastVerdict {
  differs,        ///< adjusted p < 0.05
  not_shown,      ///< no difference was shown, which is not the same as none
  not_estimable,  ///< no estimate, or no variance for it
};

[[nodiscard]] std::string_view word(ContrastVerdict verdict);

struct ContrastRow {
  std::string name;
  double estimate = 0;  ///< link units (logit: log odds ratio)
  double standard_error = 0;
  double ci95_low = 0,
         ci95_high = 0;  ///< simultaneous over the family for `single_step`, else of this one alone
  double p = 0;          ///< two-sided, of this contrast alone
  double adjusted_p = 0;
  ContrastVerdict verdict = ContrastVerdict::not_estimable;
  std::string conclusion;  ///< a sentence
};

struct ContrastTable {
  std::string question;
  Correction correction = Correction::single_step;
  double degrees_of_freedom = infinity;
  std::vector<ContrastRow> rows;
  /// All contrasts at once: P of the Wald statistic, F_{q, df - q + 1} after Hotelling. None when the degrees
  /// of freedom do not reach for q.
  std::optional<double> joint_p;
  int joint_contrasts = 0;  ///< q, the number of independent contrasts
};

/// Estimates, intervals, p values and verdicts. `covariance` belongs to `coefficients`; when it is empty all
/// contrasts are not estimable.
[[nodiscard]] ContrastTable test_contrasts(const ContrastFamily& family, const Eigen::VectorXd& coefficients,
                                           const Eigen::MatrixXd& covariance, Correction correction);

/// Holm's step-down adjustment. NaN stays NaN and does not count.
[[nodiscard]] std::vector<double> holm_adjusted(const std::vector<double>& p);

/// "p < 0.001", "p = 0.023".
[[nodiscard]] std::string p_text(double p);

}  // namespace seamline::analysis
