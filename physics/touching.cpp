#include "physics/touching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace seamline::renderer {
namespace {

constexpr double corner_bonus_m = 1e-4;
constexpr double same_way_cosine = 0.9;  ///< of 25 degrees

using TouchCell = std::array<int, 4>;

TouchCell touch_cell(const Touch& touch, double cell_m) {
  TouchCell key{};
  for (int axis = 0; axis < 3; ++axis)
    key[static_cast<std::size_t>(axis)] = static_cast<int>(std::floor(touch.on_body_m[axis] / cell_m));
  int side = 0;
  touch.push.cwiseAbs().maxCoeff(&side);
  key[3] = 2 * side + (touch.push[side] > 0 ? 1 : 0);
  return key;
}

double rank_m(const Touch& touch) {
  return touch.distance_m - (touch.is_corner ? corner_bonus_m : 0);
}

}  // namespace

std::vector<Touch> spread_touches(std::vector<Touch> touches, double cell_m) {
  const auto place = [](const Touch& t) {
    return std::array{rank_m(t), t.on_body_m.x(), t.on_body_m.y(), t.on_body_m.z()};
  };
  std::stable_sort(touches.begin(), touches.end(),
                   [&](const Touch& a, const Touch& b) { return place(a) < place(b); });
  std::map<TouchCell, Touch> deepest;
  for (const Touch& touch : touches) deepest.emplace(touch_cell(touch, cell_m), touch);
  std::vector<Touch> out;
  for (const auto& [key, touch] : deepest) out.push_back(touch);
  return out;
}

void keep_impulses(const std::vector<Touch>& before, double reach_m, std::vector<Touch>& touches) {
  std::vector<bool> given(before.size(), false);
  for (Touch& touch : touches) {
    double nearest_m = reach_m;
    std::size_t found = before.size();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double distance_m = (before[i].on_body_m - touch.on_body_m).norm();
      if (given[i] || !(distance_m < nearest_m) || before[i].push.dot(touch.push) < same_way_cosine) continue;
      nearest_m = distance_m;
      found = i;
    }
    if (found == before.size()) continue;
    given[found] = true;
    touch.impulse = before[found].impulse;
  }
}

}  // namespace seamline::renderer
