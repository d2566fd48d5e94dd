#pragma once
#include <functional>
#include <optional>
#include <string>

#include "raytracer/light/light.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// A sun that was found in a panorama and taken out of it.
struct SplitSun {
  Sun sun;
  double solid_angle_sr = 0;
  double share = 0;  ///< of the irradiance of a surface that faces it
};

/// Takes the sun out of an equirectangular picture of radiance: the brightest texel of those that are `sky`,
/// with its neighbours down to a tenth of it, if that is at most a disc of 5 degrees' radius and gives a
/// twentieth of the irradiance of a surface that faces it. What is left in its place is the mean of the
/// texels around it. None: no sun stands out.
[[nodiscard]] std::optional<SplitSun> split_sun(Image& panorama,
                                                const std::function<bool(const Eigen::Vector3f&)>& is_sky);

/// "to_sun x y z, irradiance R G B W/m2, solid angle S sr (radius D degrees), P % of ...".
[[nodiscard]] std::string sun_text(const SplitSun& split);

/// The share of all directions, by solid angle, in which a local scene shows nothing.
[[nodiscard]] double open_share(const Geometry& depth);

}  // namespace seamline::renderer
