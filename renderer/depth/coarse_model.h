#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "raytracer/tracing/mesh.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/plane_faces.h"
#include "stimuli/set/manifest.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {

/// A flat surface: a rectangle of cells, of which those are left out that the map looks through.
struct ModelRectangle {
  Eigen::Vector3d corner_m = Eigen::Vector3d::Zero();  ///< of the first cell
  Eigen::Vector3d u_m = Eigen::Vector3d::Zero();       ///< along its columns, as long as a cell
  Eigen::Vector3d v_m = Eigen::Vector3d::Zero();       ///< along its rows, at right angles to u
  int columns = 1, rows = 1;
  std::vector<std::uint8_t> solid;  ///< row by row, 1: there

  [[nodiscard]] bool is_solid(int column, int row) const {
    return solid[grid_index(row, column, columns)] != 0;
  }
};

/// A closed box: the points whose coordinates along its axes lie between two corners.
struct ModelBox {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: unit, at right angles, in the world
  Eigen::Vector3d least_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d most_m = Eigen::Vector3d::Zero();
};

/// Planes and boxes in place of a map: the coarse models that paper 003 (section 6) calls sufficient for
/// receivers.
struct CoarseModel {
  std::vector<ModelRectangle> rectangles;
  std::vector<ModelBox> boxes;
  double tolerance = 0;  ///< what lies so near the model, as a share of the distance, is explained by it
};

/// Fits faces (plane_faces.h) and makes boxes of those that meet at right angles in an edge towards the
/// centre; what is behind a box's faces is as far as their texels say. A box that stands where the map looks
/// through is none: its faces stay rectangles, as all others are, upright where they can be and a little
/// larger than what is seen of them, so that neighbours meet.
[[nodiscard]] CoarseModel fit_coarse_model(const DepthMap& map, double yaw_texels, const PlaneSearch& search);

/// How far the model is in a direction (unit); infinity where it is not.
[[nodiscard]] double distance_m(const CoarseModel& model, const Eigen::Vector3d& direction);

/// Whether the model explains a distance that was measured in a direction. It explains no hole.
[[nodiscard]] bool explains(const CoarseModel& model, const Eigen::Vector3d& direction, float measured_m);

/// The model's numbers against a map: its size, the share of the map's solid angle with a depth that it
/// explains, and the root mean square of what is left there, as a share of the distance.
[[nodiscard]] ModelRecord judge(const CoarseModel& model, const DepthMap& map, double yaw_texels,
                                int threads);

/// Two triangles for each piece of a rectangle, twelve for a box.
[[nodiscard]] DepthMesh model_mesh(const CoarseModel& model);

}  // namespace seamline::renderer
