#include "stimuli/pictures/distance_transform.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "support/arithmetic/grid_index.h"

namespace seamline::inline stimuli {
namespace {

/// Distances along the columns, in pixels, by one walk down and one walk up.
std::vector<int> column_distances(const PixelSet& set) {
  const auto width = static_cast<std::size_t>(set.width_px), height = static_cast<std::size_t>(set.height_px);
  std::vector<int> distances(set.values.size());
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t i = y * width + x;
      distances[i] = set.values[i] == 0 ? 0 : 1 + (y == 0 ? 0 : distances[i - width]);
    }
  for (std::size_t y = height; y-- > 0;)
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t i = y * width + x;
      distances[i] = std::min(distances[i], 1 + (y + 1 == height ? 0 : distances[i + width]));
    }
  return distances;
}

/// The lower envelope of the parabolas (x - at)^2 + value, each the lowest from its `from` on.
class LowerEnvelope {
 public:
  void clear() { parabolas_.clear(); }

  /// Parabolas come with rising `at`.
  void add(std::int64_t at, std::int64_t value) {
    double from = -INFINITY;
    while (!parabolas_.empty()) {
      const Parabola& last = parabolas_.back();
      from = static_cast<double>(value + at * at - last.value - last.at * last.at) /
             static_cast<double>(2 * (at - last.at));
      if (from > last.from) break;
      parabolas_.pop_back();
      from = -INFINITY;
    }
    parabolas_.push_back({at, value, from});
  }

  /// The envelope at 0 to count - 1.
  void write(std::int64_t* out, int count) const {
    std::size_t k = 0;
    for (int x = 0; x < count; ++x) {
      while (k + 1 < parabolas_.size() && parabolas_[k + 1].from < x) ++k;
      const std::int64_t away = x - parabolas_[k].at;
      out[x] = away * away + parabolas_[k].value;
    }
  }

 private:
  struct Parabola {
    std::int64_t at, value;
    double from;
  };
  std::vector<Parabola> parabolas_;
};

/// The smallest rectangle around the set, each of its pixels twice in both directions.
PixelSet doubled(const PixelSet& set) {
  int left = set.width_px, right = -1, top = set.height_px, bottom = -1;
  for (int y = 0; y < set.height_px; ++y)
    for (int x = 0; x < set.width_px; ++x) {
      if (set.values[grid_index(y, x, set.width_px)] == 0) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = y;
    }
  if (right < 0) return {};
  PixelSet out{.width_px = 2 * (right - left + 1), .height_px = 2 * (bottom - top + 1), .values = {}};
  out.values.reserve(static_cast<std::size_t>(out.width_px) * static_cast<std::size_t>(out.height_px));
  for (int y = 0; y < out.height_px; ++y)
    for (int x = 0; x < out.width_px; ++x)
      out.values.push_back(set.values[grid_index(top + y / 2, left + x / 2, set.width_px)]);
  return out;
}

}  // namespace

std::vector<std::int64_t> squared_distances(const PixelSet& set) {
  assert(set.values.size() ==
         static_cast<std::size_t>(set.width_px) * static_cast<std::size_t>(set.height_px));
  const std::vector<int> columns = column_distances(set);
  const auto width = static_cast<std::size_t>(set.width_px);
  std::vector<std::int64_t> squares(columns.size());
  LowerEnvelope envelope;
  for (std::size_t row = 0; row < squares.size(); row += width) {
    envelope.clear();
    envelope.add(-1, 0);  // left out, as everything outside the picture
    for (std::size_t x = 0; x < width; ++x) {
      const std::int64_t distance = columns[row + x];
      envelope.add(static_cast<std::int64_t>(x), distance * distance);
    }
    envelope.add(set.width_px, 0);
    envelope.write(&squares[row], set.width_px);
  }
  return squares;
}

double widest_band_px(const PixelSet& set) {
  const std::vector<std::int64_t> squares = squared_distances(doubled(set));
  return squares.empty() ? 0.0
                         : std::sqrt(static_cast<double>(*std::max_element(squares.begin(), squares.end())));
}

}  // namespace seamline::inline stimuli
