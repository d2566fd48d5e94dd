#pragma once
#include <limits>

namespace seamline {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();  ///< what is not known
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace seamline
