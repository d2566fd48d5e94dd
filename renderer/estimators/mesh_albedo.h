#pragma once
#include <memory>

#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"
#include "stimuli/definition/study_definition.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// The least and the most albedo that is read out of a photograph.
inline constexpr float least_photographed_albedo = 0.01F, most_photographed_albedo = 0.95F;

/// Texels around a map of albedo: as many as the panorama's depth map has; of a sensor, as many as give its
/// texels per degree on its axis all round, rounded to an even number. Of a photograph 1024 at most: finer
/// texels would hold its noise.
[[nodiscard]] int albedo_map_width_px(const DepthSettings& depth);

/// The truth's albedo in the directions of texel centres, one ray each, as its depth is captured. Of glossy
/// surfaces the diffuse base and what the specular layer sends back at normal incidence over it,
/// a + (1 - a) f0. Directions that show nothing are unknown, and `elsewhere` is the study's one albedo.
[[nodiscard]] AlbedoMap albedo_of_truth(const Geometry& truth, int width_px, double usual_albedo,
                                        int threads);

/// What albedo is read from.
struct PhotographedScene {
  const Image& photograph;  ///< linear radiance
  const Camera& camera;     ///< at the origin
  const Light& light;
  double usual_albedo = 0.5;  ///< of what the photograph does not show, and where no light arrives
  int threads = 1;
};

/// Albedo estimated from a photograph and the local scene alone: a = pi B / E, where B is the photograph's
/// mean radiance in a texel and E the mean irradiance there of the local scene under the scene's light,
/// bounce light included, traced with the usual albedo first and then once more with the first estimate.
/// Clamped to `least_photographed_albedo` .. `most_photographed_albedo`. Texels that the photograph does not
/// show, and those that get less than a fiftieth of the median irradiance, have the usual albedo: where the
/// local scene is all but black the quotient says nothing. Every surface counts as diffuse, and what emits as
/// lit; a shadow that the local scene puts elsewhere than the photograph becomes paint. `local` is painted
/// when it returns. The same for any number of threads.
[[nodiscard]] std::shared_ptr<const AlbedoMap> paint_from_photograph(Geometry& local, int width_px,
                                                                     const PhotographedScene& scene);

/// Paints a local scene as its depth settings say; `constant` leaves it as it is.
void paint_mesh(Geometry& local, const Geometry& truth, const DepthSettings& depth,
                const PhotographedScene& scene);

}  // namespace seamline::renderer
