#include "live/frame/live_scene.h"

#include <cmath>
#include <numbers>

#include "support/arithmetic/shortest_turn.h"

namespace seamline::live {
namespace {

using renderer::Light;

Eigen::Isometry3d turned_up(const LoadedRecording& recording) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  if (recording.up != Eigen::Vector3d::UnitY())
    turn.linear() = shortest_turn(recording.up, Eigen::Vector3d::UnitY()).toRotationMatrix();
  return turn;
}

/// The mean radiance over all directions.
Rgb mean_sky(const Light& light) {
  if (!light.environment) return light.environment_radiance;
  constexpr int rows = 64;
  Rgb sum = Rgb::Zero();
  float weights = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < 2 * rows; ++column) {
      const float polar = (static_cast<float>(row) + 0.5F) / rows * std::numbers::pi_v<float>;
      const float azimuth = (static_cast<float>(column) + 0.5F) / rows * std::numbers::pi_v<float>;
      const Eigen::Vector3f direction(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                      std::sin(polar) * std::sin(azimuth));
      sum += light.environment->radiance(direction) * std::sin(polar);
      weights += std::sin(polar);
    }
  return sum / weights;
}

/// A sun over the photographer's left shoulder.
SceneDefinition usual_light(const Eigen::Isometry3d& first) {
  constexpr double sun_w_m2 = 1.6, sky_w_m2_sr = 0.17;
  SceneDefinition light;
  const Eigen::Vector3d backwards = -first.linear().col(2), left = -first.linear().col(0);
  const Eigen::Vector3d level = (backwards + 0.7 * left).cwiseProduct(Eigen::Vector3d(1, 0, 1));
  light.suns = {SunDefinition{.to_sun = (level + 1.3 * Eigen::Vector3d::UnitY()).normalized(),
                              .irradiance_w_m2 = {sun_w_m2, sun_w_m2, sun_w_m2}}};
  light.lamps.emplace();
  light.environment_radiance = {sky_w_m2_sr, sky_w_m2_sr, sky_w_m2_sr};
  return light;
}

void turn_light(const Eigen::Isometry3d& turn, Light& light) {
  if (turn.isApprox(Eigen::Isometry3d::Identity(), 0)) return;
  const Eigen::Isometry3f by = turn.cast<float>();
  for (renderer::Sun& sun : light.suns) sun.to_sun = by.linear() * sun.to_sun;
  for (renderer::Lamp& lamp : light.lamps) {
    lamp.position_m = by * lamp.position_m;
    lamp.axis = by.linear() * lamp.axis;
  }
}

}  // namespace

std::vector<renderer::TriangleSpan> LiveScene::spans() const {
  std::vector<renderer::TriangleSpan> spans;
  for (const auto& mesh : objects.meshes) spans.push_back({mesh->positions_m, mesh->triangles});
  return spans;
}

Eigen::Isometry3d upright(const LoadedRecording& recording, const Eigen::Isometry3d& pose) {
  return turned_up(recording) * pose;
}

Eigen::Isometry3d first_pose(const LoadedRecording& recording) {
  if (const auto& pose = recording.frames.front().world_from_colour) return upright(recording, *pose);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear().diagonal() = Eigen::Vector3d(1, -1, -1);
  return upright(recording, pose);
}

LiveScene live_scene(const LoadedRecording& recording, const SceneRequest& request,
                     const Eigen::Vector3d& origin_m) {
  renderer::PhotoObjects objects = renderer::place_objects(request.models, origin_m);
  renderer::Geometry geometry(objects.meshes, renderer::Edges::loose);
  Light light;
  if (request.light != nullptr) {
    light = renderer::scene_light(*request.light, {}, origin_m);
  } else if (recording.has_light) {
    const Eigen::Isometry3d turn = upright(recording, Eigen::Isometry3d::Identity());
    light = renderer::scene_light(recording.light, {}, turn.inverse() * origin_m);
    turn_light(turn, light);
  } else {
    light = renderer::scene_light(usual_light(first_pose(recording)), {}, origin_m);
  }
  const Rgb ambient_radiance = mean_sky(light);
  return {.objects = std::move(objects),
          .geometry = std::move(geometry),
          .light = std::move(light),
          .ambient_radiance = ambient_radiance,
          .display_factor = static_cast<float>(std::exp2(recording.light.exposure_ev))};
}

}  // namespace seamline::live
