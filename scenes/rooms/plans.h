#pragma once
#include <Eigen/Core>

#include "scenes/shapes/glb_file.h"

namespace seamline::scenes {

// What may differ between the scenes of a family. As they stand: bedroom, gazebo and atrium. Metres.

/// A room open to the left, where a low sun comes in.
struct RoomPlan {
  double back_z_m = -6.15, right_x_m = 3.9, left_x_m = -3.9, wall_height_m = 3.1, front_z_m = 3.8;
  double bed_x_m = -0.3, bed_height_m = 0.42, headboard_m = 0.85;
  double wardrobe_x_m = -3.25;
  double chest_x_m = 3.0, chest_width_m = 1.8, chest_height_m = 0.5;
  double shelf_x_m = 0.35, shelf_height_m = 1.5;
  int books = 11;
  double stool_x_m = 0, stool_z_m = -4.86, stool_height_m = 0.28;
  SceneCamera camera = {.position_m = {0, 1.9, 0.1}, .look_at_m = {0, 0.85, -5}, .vertical_fov_rad = 0.78};
  SceneSun sun = {.to_sun = Eigen::Vector3d(-0.62, 0.30, 0.72).normalized(), .irradiance_w_m2 = 2.75};
};

/// An open pavilion on a lawn with the sun behind it.
struct PavilionPlan {
  Eigen::Vector3d centre_m = {-3.45, 0, -16.85};
  double yaw_rad = 0.065;  ///< its left comes a little nearer
  double deck_height_m = 0.45, eaves_m = 3.4;
  /// Its plan: a rectangle with cut corners, the eaves' overhang included.
  double half_width_m = 6.6, half_depth_m = 3.5, cut_m = 1.6;
  double crest_m = 1.35, picket_m = 0.17, picket_pitch_m = 0.41;
  SceneCamera camera = {.position_m = {0, 2.6, 2.0}, .look_at_m = {0, 1.1, -7}, .vertical_fov_rad = 0.51};
  SceneSun sun = {.to_sun = Eigen::Vector3d(-0.332, 0.462, -0.822).normalized(), .irradiance_w_m2 = 5.2};
};

/// A court of two storeys of arcades, with screens behind its columns (paper section 4.1.1).
struct ArcadePlan {
  double bay_m = 3.0;        ///< from column to column
  double spring_m = 2.75;    ///< where the lower arches begin
  double storey_m = 4.5;     ///< floor of the gallery
  double aisle_m = 3.0;      ///< depth behind the columns
  double shaft_m = 0.26;     ///< radius of a column
  double thickness_m = 0.6;  ///< of the arcade wall
  int balusters = 6;         ///< of a bay
  int beads = 2;             ///< of the first bay's balusters; the next bays have one and two more
  double rail_m = 1.95;      ///< height of its middle
  double first_x_m = -12.0;  ///< of eight bays
  double arcade_z_m = -7.5;  ///< the plane of the columns' axes
  SceneCamera camera = {
      .position_m = {2.4, 1.75, 0.9}, .look_at_m = {1.6, 1.95, -7.5}, .vertical_fov_rad = 0.66};
};

[[nodiscard]] SceneContents make_room(const RoomPlan& plan);
[[nodiscard]] SceneContents make_pavilion(const PavilionPlan& plan);
[[nodiscard]] SceneContents make_arcade(const ArcadePlan& plan);

}  // namespace seamline::scenes
