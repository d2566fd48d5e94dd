#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint_fit.h"

namespace seamline::analysis {

/// Whether something that the model shares wants values of its own.
struct SharingTest {
  std::string
      shared;  ///< "spread of every rating", "scale", "rating criteria", "lapse rate", "guess ratings"
  int parameters = 0;    ///< q: how many more the richer model has
  double statistic = 0;  ///< F of q and people - q degrees of freedom; NaN without p
  double p = 1;          ///< NaN: see `note`
  std::string note;      ///< why there is no p; empty otherwise
};

/// First whether every rating's curve is as steep as the others' (proportional odds; three ratings or more),
/// then what curves share. Robust score tests (Boos 1992, The American Statistician 46) of every block
/// that is shared: the efficient
/// scores of each person e_i at the shared estimate have mean 0 if sharing is right, tested by Hotelling's
/// T^2 over people. A likelihood ratio would take answers of one person for independent.
[[nodiscard]] std::vector<SharingTest> test_sharing(const JointFit& fit, const JointData& data);

}  // namespace seamline::analysis
