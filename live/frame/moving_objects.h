#pragma once
#include <optional>
#include <span>

#include "live/frame/live_scene.h"

namespace seamline::live {

/// Gives each of a scene's objects a tree of its own, so that it can be moved. `models` and `origin_m` are
/// those that the scene was made of.
void make_movable(const std::vector<renderer::PlacedModel>& models, const Eigen::Vector3d& origin_m,
                  LiveScene& scene);

/// Moves each object by one of `moves`, from where it was placed, in the world whose `origin_m` is the
/// scene's.
void move_objects(std::span<const Eigen::Isometry3d> moves, const Eigen::Vector3d& origin_m,
                  LiveScene& scene);

/// The nearest virtual surface along each ray. `hits` is as long as `rays`, at most `rays_a_call`.
void nearest_objects(const LiveScene& scene, std::span<const renderer::Ray> rays,
                     std::span<std::optional<renderer::SurfacePoint>> hits);

/// Whether a virtual thing lies on the ray before its end.
[[nodiscard]] bool objects_block(const LiveScene& scene, const renderer::Ray& ray);

}  // namespace seamline::live
