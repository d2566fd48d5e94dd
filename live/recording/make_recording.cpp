#include "live/recording/make_recording.h"

#include <fmt/core.h>

#include <numbers>

#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/progress.h"

namespace seamline::live {
namespace {

constexpr double ahead_m = 2;  ///< an orbit's middle, where the picture's middle shows nothing
constexpr double degree = std::numbers::pi / 180;

/// What the middle of the first picture shows.
Eigen::Vector3d middle_m(const renderer::SensedScene& scene, const sensors::Rig& rig) {
  const auto direction =
      sensors::direction_through(rig.colour, {0.5 * rig.colour.width_px, 0.5 * rig.colour.height_px});
  const Eigen::Vector3d forward =
      (scene.world_from_colour.linear() * direction.value_or(Eigen::Vector3d::UnitZ())).normalized();
  const auto hit =
      scene.truth.nearest({scene.world_from_colour.translation().cast<float>(), forward.cast<float>()});
  const double far_m = hit ? static_cast<double>(hit->distance_m) : ahead_m;
  return scene.world_from_colour.translation() + far_m * forward;
}

std::array<double, 3> three(const Rgb& rgb) {
  return {rgb[0], rgb[1], rgb[2]};
}

/// The light of a scene in words of a recording. Surfaces that emit are left out: there is no word for them.
SceneDefinition light_of(const renderer::Light& light, const SceneDefinition& definition,
                         const Eigen::Vector3d& centre_m) {
  SceneDefinition words;
  words.environment_radiance = definition.environment_radiance;
  words.suns.emplace();
  words.lamps.emplace();
  for (const renderer::Sun& sun : light.suns)
    words.suns->push_back({.to_sun = sun.to_sun.cast<double>(),
                           .irradiance_w_m2 = three(sun.irradiance_w_m2),
                           .angular_radius_deg = sun.angular_radius_rad / degree});
  for (const renderer::Lamp& lamp : light.lamps)
    words.lamps->push_back({.position_m = lamp.position_m.cast<double>() + centre_m,
                            .intensity_w_sr = three(lamp.intensity_w_sr),
                            .is_spot = lamp.is_spot,
                            .shines_along = lamp.axis.cast<double>(),
                            .inner_deg = std::acos(static_cast<double>(lamp.inner_cosine)) / degree,
                            .outer_deg = std::acos(static_cast<double>(lamp.outer_cosine)) / degree});
  return words;
}

}  // namespace

Recording make_recording(const renderer::SceneFile& file, const SceneDefinition& definition,
                         const sensors::Rig& rig, const std::string& rig_name, const MakeOptions& options,
                         const std::filesystem::path& folder) {
  const renderer::SensedScene scene = renderer::sensed_scene(file, definition, rig);
  CameraPath path = options.path;
  path.centre_m = options.orbit_m ? *options.orbit_m - scene.centre_m : middle_m(scene, rig);
  Recording recording{.folder = folder, .has_light = true};
  recording.light = light_of(scene.light, definition, scene.centre_m);
  recording.light.exposure_ev = options.exposure_ev;
  for (const char* below : {"depth", "colour"}) prepare_output_folder(folder / below);
  Progress progress("record", options.frames);
  for (int i = 0; i < options.frames; ++i) {
    const double share = options.frames > 1 ? static_cast<double>(i) / (options.frames - 1) : 0;
    Eigen::Isometry3d pose = pose_on_path(path, scene.world_from_colour, share);
    renderer::SenseSettings settings = options.sense;
    settings.key.frame += i;
    // Else the colours' noise would stand still on the sensor, and corners that are followed with it.
    settings.photograph.seed += i;
    const renderer::SensedFrame sensed = renderer::sense_frame(scene, rig, pose, settings);
    RecordedFrame frame{.time_s = i / options.frames_per_s,
                        .depth_file = fmt::format("depth/{:06}.exr", i),
                        .colour_file = fmt::format("colour/{:06}.png", i)};
    pose.translation() += scene.centre_m;
    if (options.keeps_poses) frame.world_from_colour = pose;
    Image depth(rig.depth.width_px, rig.depth.height_px, 1);
    depth.values = sensed.measured.frame.depth_m;
    write_exr(folder / frame.depth_file, depth);
    write_png(folder / frame.colour_file, display_image(sensed.colour, options.exposure_ev));
    recording.frames.push_back(std::move(frame));
    progress.advance(1, recording.frames.back().colour_file);
  }
  registration::CameraFile cameras;
  cameras.depth = rig.depth;
  cameras.colour = rig.colour;
  cameras.colour_from_depth = rig.colour_from_depth;
  cameras.convention = sensors::convention_of(rig.noise);
  write_file_atomically(folder / recording.camera_file,
                        registration::camera_file_text(cameras, "The rig " + rig_name));
  write_file_atomically(folder / recording_index, recording_text(recording));
  return recording;
}

}  // namespace seamline::live
