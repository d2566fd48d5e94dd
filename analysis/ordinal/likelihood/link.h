#pragma once
#include <string_view>

namespace seamline::analysis {

/// The distribution F of the latent variable: P(Y <= k) = F(cut_k - eta).
enum class Link { logit, probit };

[[nodiscard]] std::string_view word(Link link);

/// F of the link.
[[nodiscard]] double cumulative(Link link, double x);

/// log P with P = F(upper) - F(lower), and its derivatives with respect to the two ends. `s` is the common
/// shift by the linear predictor: d upper / ds = d lower / ds = -1.
struct IntervalTerms {
  double log_p = 0;
  double u = 0, l = 0;            ///< d/d upper (> 0) and d/d lower (< 0); 0 at an infinite end
  double uu = 0, ul = 0, ll = 0;  ///< second derivatives
  double ssu = 0, ssl = 0;        ///< d3 / ds2 d upper, d3 / ds2 d lower
  double s() const { return -(u + l); }
  double ss() const { return uu + 2 * ul + ll; }  ///< never positive: log P is concave for both links
  double su() const { return -(uu + ul); }
  double sl() const { return -(ul + ll); }
  double sss() const { return -(ssu + ssl); }
};

/// Terms of the interval (lower, upper); lower may be -infinity and upper +infinity. Without cancellation
/// also where P is below the smallest double (probit: ends beyond 38). log_p is -infinity when upper <=
/// lower.
[[nodiscard]] IntervalTerms interval_terms(Link link, double upper, double lower);

}  // namespace seamline::analysis
