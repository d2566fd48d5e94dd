#pragma once
#include <array>

namespace seamline::renderer {

/// Cubic B-spline at whole steps: the kernel of the a-trous filters.
inline constexpr std::array<float, 5> b_spline = {1.0F / 16, 4.0F / 16, 6.0F / 16, 4.0F / 16, 1.0F / 16};

}  // namespace seamline::renderer
