#pragma once
#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::inline stimuli {

/// A sun, when the study file overrides what the scene file holds (KHR_lights_punctual, directional).
struct SunDefinition {
  Eigen::Vector3d to_sun =
      Eigen::Vector3d::UnitY();  ///< direction from the scene towards the sun, unit length
  std::array<double, 3> irradiance_w_m2 = {0, 0, 0};  ///< on a plane facing the sun, linear RGB
  double angular_radius_deg = 0.0;                    ///< 0: a hard sun
};

/// A lamp without size in the scene's world. With a cone it is a spot lamp: full within `inner_deg` of its
/// axis, nothing beyond `outer_deg` (KHR_lights_punctual).
struct LampDefinition {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  std::array<double, 3> intensity_w_sr = {0, 0, 0};  ///< linear RGB
  bool is_spot = false;
  Eigen::Vector3d shines_along = -Eigen::Vector3d::UnitY();  ///< unit
  double inner_deg = 0, outer_deg = 45;
};

/// An environment map in place of the constant environment.
struct EnvironmentDefinition {
  std::string file;            ///< as the study file names it: .exr or .hdr, equirectangular, +Y up
  std::filesystem::path path;  ///< where it is
  double rotation_deg = 0;     ///< about +Y, counter-clockwise seen from above
  double strength = 1;         ///< factor on its radiance
};

[[nodiscard]] std::string canonical_text(const SunDefinition& sun);
[[nodiscard]] std::string canonical_text(const LampDefinition& lamp);
[[nodiscard]] std::string canonical_text(const EnvironmentDefinition& environment);

}  // namespace seamline::inline stimuli
