#include "support/arithmetic/shortest_turn.h"

#include <cmath>

namespace seamline {

Eigen::Quaterniond shortest_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double opposite = -1 + 1e-12;
  const Eigen::Vector3d start = from.normalized(), end = to.normalized();
  const double cosine = end.dot(start);
  Eigen::Quaterniond turn;
  if (cosine < opposite) {
    turn.w() = 0;
    turn.vec() = start.unitOrthogonal();
    return turn;
  }
  const double twice_w = std::sqrt((1 + cosine) * 2);
  turn.vec() = start.cross(end) * (1 / twice_w);
  turn.w() = twice_w * 0.5;
  return turn;
}

}  // namespace seamline
