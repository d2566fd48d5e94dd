#pragma once
#include <optional>

#include "analysis/psychometric/likelihood/monotone_bound.h"
#include "analysis/psychometric/likelihood/profile_height.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

/// Ends of an interval; infinite: open on that side, nothing tried was excluded.
struct Interval {
  double low = -infinity;
  double high = infinity;
};

/// 0.95 quantile of chi-squared with 1 degree of freedom.
inline constexpr double chi_squared_95 = 3.841458820694124;

/// Intervals by the profile likelihood: all values whose profile, the maximum over everything else, is within
/// cut / 2 of the global maximum. `cut` is `chi_squared_95` for a 95 % interval. The likelihood has several
/// ridges: one of broad functions, and through every level and every gap one of steep functions. The ends are
/// the outermost crossings of all: a walk outward from the outermost function known to be within the cut,
/// then a look at every part of the axis further out, but for those that no monotone function can reach
/// (`MonotoneBound`). Unit coordinates.
class Profile {
 public:
  explicit Profile(const Search& search) : search_(search), bound_(search.problem) {}

  /// Of the place of a level; open at an end that the box does not contain.
  [[nodiscard]] Interval place(const SoughtLevel& level, double cut = chi_squared_95) const;
  /// Of ln of the scale; the low end is -infinity when a step is not excluded.
  [[nodiscard]] Interval log_scale(double cut = chi_squared_95) const;
  /// Of lapse and guess; an end at the bound is the bound.
  [[nodiscard]] Interval rate(int parameter, double cut = chi_squared_95) const;

  /// Whether some function whose sought level lies at `place` is within the cut.
  [[nodiscard]] bool holds(const SoughtLevel& level, double place, double cut = chi_squared_95) const;

 private:
  struct Probe;
  struct Top;
  [[nodiscard]] Interval interval(const ProfileCoordinate& coordinate, double cut) const;
  [[nodiscard]] double end(const ProfileCoordinate& coordinate, double cut, double towards,
                           const std::vector<StepFit>& steps) const;
  [[nodiscard]] double end_of_ridge(const ProfileCoordinate& coordinate, double cut, double towards, Top top,
                                    const std::vector<StepFit>& steps) const;
  [[nodiscard]] std::vector<Top> tops(const ProfileCoordinate& coordinate, double needed,
                                      const std::vector<StepFit>& steps) const;
  [[nodiscard]] std::vector<double> probes(const ProfileCoordinate& coordinate) const;
  [[nodiscard]] double crossing(const ProfileCoordinate& coordinate, double cut, double inside,
                                const Probe& first_outside, Maximum warm) const;

  const Search& search_;
  MonotoneBound bound_;
};

/// Variance of one of the coordinates (0: the sought level's place) by Fisher's information at the maximum;
/// parameters at their bounds count as known. Infinite when the information is singular.
[[nodiscard]] double coordinate_variance(const FitProblem& problem, const Maximum& at, int coordinate);

}  // namespace seamline::analysis
