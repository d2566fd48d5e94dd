#pragma once
#include <Eigen/Core>
#include <limits>

namespace seamline::renderer {

struct Ray {
  Eigen::Vector3f origin_m;
  Eigen::Vector3f direction;  ///< unit
  float far_m = std::numeric_limits<float>::infinity();
};

}  // namespace seamline::renderer
