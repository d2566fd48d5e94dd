#include "live/frame/shadow_answers.h"

#include <array>
#include <limits>

#include "live/frame/moving_objects.h"

namespace seamline::live {
namespace {

using renderer::ShadowMap;
using renderer::TriangleSpan;

constexpr float leave_share = 2e-3F;
constexpr float endless_m = std::numeric_limits<float>::infinity();

const ShadowMap& map_of(const renderer::ShadowMaps& maps, std::size_t index) {
  return index < maps.suns.size() ? maps.suns[index] : maps.lamps[index - maps.suns.size()];
}

renderer::Ray ray_to(const SeenLight& light, const LitPoint& point) {
  const float leave_m = leave_share * point.from_eye_m;
  return {point.position_m + leave_m * point.normal, light.to_light, light.distance_m};
}

/// Where the objects are, and how far their soft shadows may fall: that far the window grows beside them.
std::vector<Eigen::Vector3f> covered_points(const LiveScene& scene, const renderer::Light& light,
                                            Shadows method) {
  std::vector<Eigen::Vector3f> points;
  for (const auto& mesh : scene.objects.meshes)
    points.insert(points.end(), mesh->positions_m.begin(), mesh->positions_m.end());
  if (method != Shadows::pcss || points.empty()) return points;
  constexpr float reach = 3;  // of the objects' own size
  Eigen::Vector3f least = points.front(), most = points.front();
  for (const Eigen::Vector3f& point_m : points) {
    least = least.cwiseMin(point_m);
    most = most.cwiseMax(point_m);
  }
  const Eigen::Vector3f middle = 0.5F * (least + most);
  for (const renderer::Sun& sun : light.suns)
    points.push_back(middle - sun.to_sun * (reach * (most - least).norm()));
  return points;
}

}  // namespace

SeenLight seen_light(const renderer::Light& light, std::size_t index, const Eigen::Vector3f& point_m) {
  if (index < light.suns.size())
    return {light.suns[index].to_sun, endless_m, light.suns[index].irradiance_w_m2};
  const renderer::Lamp& lamp = light.lamps[index - light.suns.size()];
  const Eigen::Vector3f way_m = lamp.position_m - point_m;
  const float distance_m = way_m.norm();
  const Eigen::Vector3f to_light = way_m / distance_m;
  return {to_light, distance_m, renderer::intensity_towards(lamp, -to_light) / (distance_m * distance_m)};
}

float ShadowAnswers::arriving(Caster caster, std::size_t light_index, const SeenLight& light,
                              const LitPoint& from) const {
  LitPoint point = from;
  if (caster == Caster::real) point.position_m += depth_bias * from.from_eye_m * light.to_light;
  switch (method) {
    case Shadows::none:
      return 1.0F;
    case Shadows::traced:
      return (caster == Caster::object ? objects_block(*objects, ray_to(light, point))
                                       : real_geometry->occluded(ray_to(light, point)))
                 ? 0.0F
                 : 1.0F;
    case Shadows::map:
    case Shadows::pcf:
    case Shadows::pcss:
      return renderer::arriving(map_of(caster == Caster::object ? *object : *real, light_index), lookup,
                                point.position_m, point.normal, point.turn);
  }
  return 1.0F;
}

void draw_maps(const LiveScene& scene, const TriangleSpan& local_scene, int width_px, int threads,
               ShadowAnswers& answers) {
  const std::vector<TriangleSpan> objects = scene.spans();
  const std::array<TriangleSpan, 1> real = {local_scene};
  answers.object.emplace();
  answers.real.emplace();
  renderer::Light one;
  for (const renderer::Sun& sun : scene.light.suns) {
    one.suns = {sun};
    const auto covered_m = covered_points(scene, one, answers.method);
    answers.object->suns.push_back(renderer::sun_shadow_map(sun, objects, covered_m, width_px, threads));
    answers.real->suns.push_back(renderer::sun_shadow_map(sun, real, covered_m, width_px, threads));
  }
  const auto covered_m = covered_points(scene, {}, Shadows::map);
  for (const renderer::Lamp& lamp : scene.light.lamps) {
    answers.object->lamps.push_back(renderer::lamp_shadow_map(lamp, objects, covered_m, width_px, threads));
    answers.real->lamps.push_back(renderer::lamp_shadow_map(lamp, real, covered_m, width_px, threads));
  }
}

ShadowFilter filter_of(Shadows method) {
  switch (method) {
    case Shadows::none:
    case Shadows::traced:
    case Shadows::map:
      return ShadowFilter::none;
    case Shadows::pcf:
      return ShadowFilter::pcf;
    case Shadows::pcss:
      return ShadowFilter::pcss;
  }
  return ShadowFilter::none;
}

}  // namespace seamline::live
