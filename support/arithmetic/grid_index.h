#pragma once
#include <cstddef>

namespace seamline {

/// Place of a cell in a grid of so many columns that is stored row by row.
[[nodiscard]] constexpr std::size_t grid_index(int row, int column, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

}  // namespace seamline
