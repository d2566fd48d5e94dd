#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "composites/photo_view.h"
#include "raytracer/light/light.h"

namespace seamline::renderer {

/// Light that is known before the local scene is.
struct KnownLight {
  Light light;                               ///< what was given, or the panorama's sky and sun
  bool photographed = false;                 ///< the local scene sends what the panorama shows of it
  std::optional<Light> added = {};           ///< that exists only with the objects; none that is black
  std::optional<float> panorama_white = {};  ///< radiance of white, of a panorama of codes
  std::vector<std::string> text;             ///< what there is, a line each
};

/// The light that was given, or the panorama's. `depth`: the local scene, whose holes are sky. Throws
/// InputError where there is none, or where things that were given exclude each other.
[[nodiscard]] KnownLight known_light(const CompositeRequest& request, const SeenPhoto& seen,
                                     const Geometry& depth, Notes& notes);

/// Throws InputError where suns and environment are all the light, and the local scene is closed all round.
void require_way_in(const KnownLight& known, const Geometry& depth, Notes& notes);

/// Paths of `light` look for the spots that its lamps light on real surfaces and objects close to them
/// (raytracer/light/bright_patches.h); nothing without lamps. `mesh`: the local scene.
void look_for_spots(std::span<const std::shared_ptr<const SurfaceMesh>> objects, const DepthMesh& mesh,
                    double albedo, Light& light);

}  // namespace seamline::renderer
