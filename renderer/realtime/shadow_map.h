#pragma once
#include <span>
#include <vector>

#include "raytracer/light/light.h"
#include "renderer/realtime/depth_picture.h"
#include "stimuli/definition/methods/pipeline.h"

namespace seamline::renderer {

/// What one light sees of things that may stand in its way (Williams 1978; paper 000, section 4.2; 001,
/// section 5.3). Outside its picture nothing does.
struct ShadowMap {
  DrawView view;
  DepthPicture depth;
  float nearest_m = 0;   ///< the least depth in it; infinity where it is empty
  float tan_radius = 0;  ///< tangent of a sun's angular radius; 0 of hard suns and of lamps
};

/// How a map is looked up.
struct ShadowLookup {
  ShadowFilter filter = ShadowFilter::none;
  /// Light is let past what is nearer than the receiver by less than so many texels' width, times
  /// 1 + tan(angle of incidence), which is what a plane's depth changes from a texel's centre to its edge.
  float bias_texels = 1;
  int taps = 32;  ///< of soft shadows: of the search for blockers, and of the filter
};

/// The share of a light that its map lets arrive at a point with this normal (unit, on the side that is
/// seen). `none`: 0 or 1. `pcf`: of 3 x 3 texels. `pcss`: of the texels under the disc that the sun has as
/// seen through the blockers' mean depth z_b, of radius (z - z_b) tan(radius); blockers are looked for under
/// the disc that the nearest thing would give. Texels beside the point are compared with the receiver's own
/// plane there. `turn` (0 to 1) turns the taps of soft shadows about the middle, so that samples of a pixel
/// see different ones.
[[nodiscard]] float arriving(const ShadowMap& map, const ShadowLookup& how, const Eigen::Vector3f& point_m,
                             const Eigen::Vector3f& normal, float turn);

/// Draws a sun's map: square texels, `width_px` a side, over the points that it must cover and what a disc of
/// its size needs beside them.
[[nodiscard]] ShadowMap sun_shadow_map(const Sun& sun, std::span<const TriangleSpan> casters,
                                       std::span<const Eigen::Vector3f> covered_m, int width_px, int threads);

/// The same of a lamp without size, along the middle of the points that it must cover, and at most 80 degrees
/// aside.
[[nodiscard]] ShadowMap lamp_shadow_map(const Lamp& lamp, std::span<const TriangleSpan> casters,
                                        std::span<const Eigen::Vector3f> covered_m, int width_px,
                                        int threads);

/// A map for every sun and lamp of a light, in its order.
struct ShadowMaps {
  std::vector<ShadowMap> suns, lamps;
};
[[nodiscard]] ShadowMaps draw_shadow_maps(const Light& light, std::span<const TriangleSpan> casters,
                                          std::span<const Eigen::Vector3f> covered_m, int width_px,
                                          int threads);

}  // namespace seamline::renderer
