#pragma once
#include <array>

namespace seamline::renderer {

/// A vertex of a grid of directions. Of the dense sphere, row -1 is the zenith and row `height` the nadir,
/// where the column means nothing.
struct GridVertex {
  int row = 0;
  int column = 0;
};

/// Three vertices of a grid, none a pole, anticlockwise as seen from the centre. Columns of the dense sphere
/// are not wrapped: they lie in [0, width] and less than a quarter turn apart.
using GridTriangle = std::array<GridVertex, 3>;

}  // namespace seamline::renderer
