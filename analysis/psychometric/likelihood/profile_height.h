#pragma once
#include <vector>

#include "analysis/psychometric/likelihood/search.h"

namespace seamline::analysis {

/// What a profile is over, in unit coordinates.
struct ProfileCoordinate {
  int index = 0;
  SoughtLevel level = {};
  double lower = 0, upper = 0;  ///< bounds of the search
  double start = 0;             ///< at the maximum
};

/// The maximum with the coordinate held at x that a climb from `warm` finds. Of beta-binomial rows its value
/// is raised by what a 95 % interval must allow for an eta that few rows estimate.
[[nodiscard]] Maximum climb_held(const Search& search, const ProfileCoordinate& coordinate, double x,
                                 const Maximum& warm);

/// The profile at x: the highest of climbs from everywhere, `warm` and `steps` among them.
[[nodiscard]] Maximum highest_profile(const Search& search, const ProfileCoordinate& coordinate, double x,
                                      const Maximum& warm, const std::vector<StepFit>& steps);

}  // namespace seamline::analysis
