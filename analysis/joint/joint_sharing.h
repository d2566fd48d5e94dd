#pragma once
#include <string>
#include <vector>

#include "analysis/joint/joint_fit.h"

namespace seamline::analysis {

/// Whether something that the model shares wants values of its own.
struct SharingTest {
  std::string
      shared;  ///< "spread of every rating", "scale", "rating criteria", "lapse rate", "guess ratings"
  int parameters = 0;                   ///< q: how many more the richer model has
  double statistic = 0;                 ///< F of q and people - q degrees of freedom; NaN without p
  double p = 1;                         ///< NaN: see `note`
  std::string note;                     ///< why there is no p; empty otherwise
  bool JointSharing::*block = nullptr;  ///< null: the spread of every rating
};

/// First whether every rating's curve is as steep as the others' (proportional odds; three ratings or more;
/// not where the answers placed the levels), then what curves share. Robust score tests (Boos 1992, The
/// American Statistician 46) of every block that is shared: the efficient scores of each person e_i at the
/// shared estimate have mean 0 if sharing is right, tested by Hotelling's T^2 over people. A likelihood ratio
/// would take answers of one person for independent.
[[nodiscard]] std::vector<SharingTest> test_sharing(const JointFit& fit, const JointData& data);

/// Below this p a block is refused where sharing is decided by the answers: four blocks are tested.
inline constexpr double refused_sharing_p = 0.0125;

/// That rule as a sentence for readers.
[[nodiscard]] std::string sentence_of_sharing();

/// A fit, and why it shares what it shares.
struct SharedFit {
  JointFit fit;
  std::vector<SharingTest> tests;    ///< of the first fit, which shares all that was asked for
  std::vector<SharingTest> refused;  ///< blocks that are each curve's own because of a test, in that order
};

/// The joint model with as much in common as the answers bear: the block with the smallest p becomes each
/// curve's own, as long as that p is below `refused_sharing_p` and the richer model has numbers, for as many
/// curves as before. `decided` false: shares what was asked for, whatever the tests say.
/// `fitter` is `fit_joint`, or `fit_placed` where the answers placed the levels.
using JointFitter = JointFit (*)(const JointData&, const JointSharing&);
[[nodiscard]] SharedFit fit_shared(const JointData& data, const JointSharing& sharing, bool decided,
                                   JointFitter fitter = fit_joint);

}  // namespace seamline::analysis
