#include "renderer/transport/light_facts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::renderer {

LightFacts light_facts(const TruthScene& scene) {
  LightFacts facts{.brightest_albedo = scene.definition.albedo,  // of the depth mesh
                   .sky_is_dark = scene.light.environment_radiance.isZero(0.0F) && !scene.light.environment,
                   .sky_is_mapped = scene.light.environment != nullptr,
                   .bounces = scene.light.bounces,
                   .suns = static_cast<int>(scene.light.suns.size()),
                   .lamps = static_cast<int>(scene.light.lamps.size()),
                   .emitting_triangles = scene.light.emitters ? scene.light.emitters->triangles() : 0};
  const auto look = [&](const std::vector<std::shared_ptr<const SurfaceMesh>>& meshes) {
    for (const auto& mesh : meshes) {
      facts.brightest_albedo = std::max(facts.brightest_albedo, double{mesh->albedo.maxCoeff()});
      facts.emits = facts.emits || mesh->emission.maxCoeff() > 0.0F;
      facts.is_glossy = facts.is_glossy || mesh->f0.maxCoeff() > 0.0F;
    }
  };
  look(scene.background);
  for (const auto& object : scene.objects) look(object);
  Rgb radiance = scene.light.environment_radiance;
  if (scene.light.environment)
    radiance += scene.light.environment->total_w_m2() * std::numbers::inv_pi_v<float>;
  for (const Sun& sun : scene.light.suns) radiance += sun.irradiance_w_m2 * std::numbers::inv_pi_v<float>;
  facts.brightest_radiance = double{radiance.maxCoeff()};
  return facts;
}

BounceLimit needed_bounces(const LightFacts& facts, double exposure_ev, std::optional<double> error) {
  constexpr double steepest_slope = 12.92, lights = 3, share_of_error = 0.1;
  if (is_unbounded(facts)) return {facts.bounces, 0.0};
  const double allowed = share_of_error * error.value_or(1.0 / 255);
  BounceLimit limit{facts.bounces, 0.0};
  while (limit.bounces > 0) {
    const double last = lights * steepest_slope * std::exp2(exposure_ev) * facts.brightest_radiance *
                        std::pow(facts.brightest_albedo, limit.bounces + 1);
    if (limit.change + last > allowed) break;
    limit.change += last;
    --limit.bounces;
  }
  return limit;
}

}  // namespace seamline::renderer
