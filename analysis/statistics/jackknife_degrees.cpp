#include "analysis/statistics/jackknife_degrees.h"

#include <algorithm>
#include <map>

namespace seamline::analysis {

double jackknife_degrees(const Eigen::VectorXd& values, const std::vector<int>& group_of) {
  constexpr double fewest = 2;
  struct Moments {
    double people = 0, squares = 0, fourth = 0;
  };
  std::map<int, Moments> groups;
  const Eigen::ArrayXd square = (values.array() - values.mean()).square();
  for (Eigen::Index p = 0; p < square.size(); ++p) {
    Moments& group = groups[group_of.empty() ? 0 : group_of[p]];
    group.people += 1;
    group.squares += square[p];
    group.fourth += square[p] * square[p];
  }
  double doubt = 0;
  for (const auto& [number, group] : groups) {
    if (!(group.squares > 0) || group.people < 2) continue;
    const double excess = group.people * group.fourth / (group.squares * group.squares) - 3;
    doubt +=
        group.squares * group.squares * (1 / (group.people - 1) + std::max(0.0, excess) / (2 * group.people));
  }
  const double all = square.sum();
  // Where people do not differ there is nothing to doubt.
  return doubt > 0 ? std::max(fewest, all * all / doubt) : static_cast<double>(values.size()) - 1;
}

}  // namespace seamline::analysis
