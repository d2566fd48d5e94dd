#pragma once
#include <filesystem>
#include <string>

#include "renderer/realtime/shadow_map.h"
#include "x3d/x3d_frame.h"
#include "x3d/x3d_sensors.h"

namespace seamline::renderer {

/// What the sun of a page sees, in the frame of X3D.
struct X3dSun {
  Eigen::Vector3d to_sun = Eigen::Vector3d::UnitY();
  Eigen::Vector3d sun_w_m2 = Eigen::Vector3d::Zero();  ///< irradiance of a surface that faces it
  Eigen::Vector3d sky_w_m2 = Eigen::Vector3d::Ones();  ///< by everything else
  ShadowMap object, real;
};

/// Everything that is in a page.
struct X3dPage {
  const X3dSubject& subject;
  const X3dFrame& frame;
  const ByteImage& photograph;                   ///< as it is shown
  std::span<const std::vector<float>> openness;  ///< of the objects' vertices (`x3d_openness`)
  const X3dSun* sun = nullptr;                   ///< of the shadow; none: there is no shadow
  const X3dUser* user = nullptr;
};

/// `index.html`. `folder`: where the shaders are.
[[nodiscard]] std::string x3d_page_text(const X3dPage& page, const std::filesystem::path& folder);

/// The sun that lights most; null: there is none, or none that lights.
[[nodiscard]] const Sun* brightest_sun(const Light& light);

/// Irradiance of the objects by everything but suns and lamps: the sun's `sky_w_m2`; without a sun, that of a
/// surface under an unblocked environment.
[[nodiscard]] Eigen::Vector3d sky_of(const X3dPage& page);

/// The sun that lights most, with its maps; its sky is the environment's mean irradiance, and at least a
/// tenth of the sun's, because bounce light is not known. None: the scene has no sun.
[[nodiscard]] std::optional<X3dSun> x3d_sun(const X3dSubject& subject, const X3dFrame& frame, int threads);

}  // namespace seamline::renderer
