#pragma once
#include <cmath>
#include <type_traits>

namespace seamline {

/// Where a place lies among the centres of four cells of a grid.
template <class Number, class Index = int>
struct BetweenCells {
  Index left, top;      ///< column and row of the upper left one; outside of the grid beside its border
  Number across, down;  ///< from its centre, in cells: 0 to 1
};

/// `column`, `row`: whole numbers at the cells' centres.
template <class Index = int, class Number>
[[nodiscard]] BetweenCells<Number, Index> between_cells(Number column, Number row) {
  const Number left = std::floor(column), top = std::floor(row);
  return {static_cast<Index>(left), static_cast<Index>(top), column - left, row - top};
}

/// The mean of the four cells' values, each weighted by how near its centre is. `value_at(column, row)`
/// brings columns and rows into the grid: it repeats borders or wraps around.
template <class Number, class Index, class ValueAt>
[[nodiscard]] auto bilinear(const BetweenCells<Number, Index>& place, const ValueAt& value_at) {
  using Value = std::decay_t<decltype(value_at(place.left, place.top))>;
  const auto along = [&](Index row) {
    return Value((1 - place.across) * value_at(place.left, row) +
                 place.across * value_at(place.left + 1, row));
  };
  return Value((1 - place.down) * along(place.top) + place.down * along(place.top + 1));
}

}  // namespace seamline
