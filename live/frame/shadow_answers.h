#pragma once
#include <optional>

#include "live/frame/live_scene.h"
#include "live/frame/methods.h"
#include "renderer/realtime/shadow_map.h"

namespace seamline::live {

/// One of the scene's suns, then lamps, as a point sees it.
struct SeenLight {
  Eigen::Vector3f to_light;  ///< unit
  float distance_m;          ///< infinity of suns
  Rgb irradiance_w_m2;       ///< on a surface that faces it, nothing being in the way
};
[[nodiscard]] SeenLight seen_light(const renderer::Light& light, std::size_t index,
                                   const Eigen::Vector3f& point_m);

/// Who may stand in a light's way.
enum class Caster { object, real };

/// A point on a surface, real or virtual.
struct LitPoint {
  Eigen::Vector3f position_m;
  Eigen::Vector3f normal;  ///< unit, towards the eye
  float from_eye_m;        ///< its distance from the eye: rays leave it by a share of that
  float turn;              ///< 0 to 1: turns the taps of soft shadows
};

/// How the light of a frame is asked for: which shadows, and what they are asked of.
struct ShadowAnswers {
  Shadows method = Shadows::none;
  renderer::ShadowLookup lookup = {};
  /// Of the local scene as a caster, what is nearer to the point than this share of the point's distance from
  /// the eye, towards the light, is the point's own surface, measured or rebuilt wrongly.
  float depth_bias = 0.015F;
  std::optional<renderer::ShadowMaps> object, real;
  const LiveScene* objects = nullptr;  ///< of traced shadows
  const renderer::Geometry* real_geometry = nullptr;

  /// The share of a light that a caster lets arrive. Rays begin 0.2 % of the distance above the surface.
  [[nodiscard]] float arriving(Caster caster, std::size_t light_index, const SeenLight& light,
                               const LitPoint& from) const;
};

/// The shadow maps of a frame: two for each light, of the objects and of the local scene, both of the part of
/// the light's picture that the objects fill, because nothing else receives or throws a virtual shadow.
void draw_maps(const LiveScene& scene, const renderer::TriangleSpan& local_scene, int width_px, int threads,
               ShadowAnswers& answers);

[[nodiscard]] ShadowFilter filter_of(Shadows method);

}  // namespace seamline::live
