#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/psychometric/intervals/judged_fit.h"
#include "analysis/psychometric/people/people_fit.h"

namespace seamline::analysis {

/// A group (condition) with its own fit.
struct FittedGroup {
  std::string name;                 ///< empty: the table has no groups
  JudgedFit sums;                   ///< of everybody's answers together
  std::vector<std::size_t> people;  ///< their places in the table's list; empty: no participants
  std::optional<PeopleFit> mixed;   ///< where the table names participants
};

/// A quantity of group `second` less that of group `first`.
struct GroupDifference {
  std::optional<double> estimate;  ///< where both have one
  Interval ci95;                   ///< open where one of theirs is
  double p = 0,
         adjusted_p = 0;  ///< that there is none; Holm's over all pairs of this quantity. NaN: not tested
};

struct GroupPair {
  std::size_t first = 0, second = 0;  ///< places in the list of groups
  GroupDifference threshold;          ///< on the axis: octaves on log2, else the level's unit
  GroupDifference log2_width;         ///< of log2 of the width: -1 is half as wide, twice as steep
};

/// All pairs of groups, first before second. With participants (every group has a mixed fit) the interval is
/// over participants: who is in both groups counts with their difference, so groups may lie within or between
/// participants,
///
///     within:  se^2 = (n - 1) / n sum_p (d_p - mean)^2, n - 1 degrees of freedom, d_p the difference of what
///     leaving
///              p out moves;     between:  se^2 = se_1^2 + se_2^2, degrees of freedom of Welch (1947).
///
/// Without participants it is made of the two profile intervals [l, u] about m (Zou and Donner 2008):
///
///     low = d - sqrt((m_2 - l_2)^2 + (u_1 - m_1)^2),   high = d + sqrt((u_2 - m_2)^2 + (m_1 - l_1)^2)
///
/// and p is that of the normal whose 95 % interval ends where this one ends towards 0.
[[nodiscard]] std::vector<GroupPair> group_pairs(const std::vector<FittedGroup>& groups);

}  // namespace seamline::analysis
