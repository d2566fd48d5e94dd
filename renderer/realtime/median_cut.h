#pragma once
#include <vector>

#include "raytracer/light/light.h"

namespace seamline::renderer {

/// A region of an environment map, and the light from infinity that stands for it.
struct CutLight {
  Eigen::Vector3f to_light = Eigen::Vector3f::UnitY();  ///< unit
  Rgb irradiance_w_m2 = Rgb::Zero();                    ///< on a plane facing it: all light of the region
  double solid_angle_sr = 0;
};

/// Lights in place of an environment map, by median cut (Debevec, "A Median Cut Algorithm for Light Probe
/// Sampling", 2005; paper 001, section 5.3): `count`, a power of two, or as many as the map has texels if
/// these are fewer. A region is cut across its longer side, as long as it is on the sphere in its middle row,
/// where both parts are most alike in luminous power; its light comes from the middle of its power. Together
/// they have all power of the map's texels.
[[nodiscard]] std::vector<CutLight> median_cut(const EnvironmentMap& map, int count);

/// The light with such suns in place of its environment, a constant one too. `soft`: each as large as a disc
/// of its region's solid angle, else hard.
[[nodiscard]] Light with_cut_environment(Light light, int count, bool soft);

}  // namespace seamline::renderer
