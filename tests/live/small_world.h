#pragma once
#include <algorithm>
#include <filesystem>

#include "live/frame/pipeline.h"
#include "live/recording/make_recording.h"
#include "support/arithmetic/random.h"

/// A small room, a rig without errors, and recordings of them.
namespace seamline::live::test {

inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_TEST_OUTPUT) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

inline renderer::FileMesh file_mesh(const std::string& name, std::vector<Eigen::Vector3d> corners_m,
                                    std::vector<renderer::Triangle> triangles, float albedo) {
  renderer::FileMesh mesh;
  mesh.name = name;
  mesh.positions_m = std::move(corners_m);
  mesh.triangles = std::move(triangles);
  mesh.albedo = Rgb::Constant(albedo);
  return mesh;
}

/// Four corners in order.
inline renderer::FileMesh square(const std::string& name, std::vector<Eigen::Vector3d> corners_m,
                                 float albedo) {
  return file_mesh(name, std::move(corners_m), {{0, 1, 2}, {0, 2, 3}}, albedo);
}

inline renderer::FileMesh box(const std::string& name, const Eigen::Vector3d& least_m,
                              const Eigen::Vector3d& most_m, float albedo) {
  std::vector<Eigen::Vector3d> corners_m;
  for (int i = 0; i < 8; ++i)
    corners_m.emplace_back((i & 1) != 0 ? most_m.x() : least_m.x(), (i & 2) != 0 ? most_m.y() : least_m.y(),
                           (i & 4) != 0 ? most_m.z() : least_m.z());
  return file_mesh(name, std::move(corners_m),
                   {{0, 1, 3},
                    {0, 3, 2},
                    {4, 7, 5},
                    {4, 6, 7},
                    {0, 4, 5},
                    {0, 5, 1},
                    {2, 3, 7},
                    {2, 7, 6},
                    {0, 2, 6},
                    {0, 6, 4},
                    {1, 5, 7},
                    {1, 7, 3}},
                   albedo);
}

/// Floor, back wall and a box that stands left of the middle, under one sun from the upper left; the camera
/// is at the origin and looks along -z.
inline renderer::SceneFile room() {
  renderer::SceneFile file;
  file.meshes = {square("floor", {{-4, -1, 1}, {4, -1, 1}, {4, -1, -6}, {-4, -1, -6}}, 0.5F),
                 square("wall", {{-4, -1, -4}, {4, -1, -4}, {4, 3, -4}, {-4, 3, -4}}, 0.4F),
                 box("box", {-0.9, -1, -2.6}, {-0.4, 0.1, -2.1}, 0.6F)};
  file.camera = renderer::FileCamera{};
  file.suns = {{Eigen::Vector3d(-0.5, 1, 0.35).normalized(), Rgb::Constant(2.0F)}};
  file.file = "room";
  return file;
}

/// The room with 32 x 20 patches of planted greys on its wall and 32 x 16 on its floor: corners to follow.
inline renderer::SceneFile patched_room() {
  renderer::SceneFile file = room();
  Random random(7);
  const auto grey = [&] { return static_cast<float>(0.1 + 0.8 * random.uniform()); };
  for (int column = 0; column < 32; ++column) {
    const double left = -4 + 0.25 * column;
    for (int row = 0; row < 20; ++row) {
      const double low = -1 + 0.2 * row, z = -3.999;
      file.meshes.push_back(square(
          "patch", {{left, low, z}, {left + 0.25, low, z}, {left + 0.25, low + 0.2, z}, {left, low + 0.2, z}},
          grey()));
    }
    for (int row = 0; row < 16; ++row) {
      const double far = -4 + 0.25 * row, y = -0.999;
      file.meshes.push_back(
          square("tile",
                 {{left, y, far}, {left + 0.25, y, far}, {left + 0.25, y, far + 0.25}, {left, y, far + 0.25}},
                 grey()));
    }
  }
  return file;
}

/// Depth and colour camera are one, and nothing is measured wrongly.
inline sensors::Rig exact_rig(int width_px = 160, int height_px = 120) {
  sensors::Rig rig;
  rig.depth = rig.colour = sensors::pinhole_of_field_of_view(width_px, height_px, 60);
  rig.noise = sensors::GenericNoise{};
  return rig;
}

inline SceneDefinition definition_of(double environment) {
  SceneDefinition definition;
  definition.environment_radiance = {environment, environment, environment};
  definition.bounces = 0;
  return definition;
}

/// The sum of absolute differences of codes, over 255 and their count; and how many differ.
struct CodeDifference {
  double rms = 0, largest = 0;
};
inline CodeDifference difference(const ByteImage& a, const ByteImage& b) {
  CodeDifference found;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double off = std::abs(static_cast<double>(a.values[i]) - static_cast<double>(b.values[i])) / 255;
    found.rms += off * off;
    found.largest = std::max(found.largest, off);
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(a.values.size()));
  return found;
}

/// A recording in memory.
inline LoadedRecording recorded(const renderer::SceneFile& file, const sensors::Rig& rig,
                                const SceneDefinition& definition, const CameraPath& path, int frames,
                                int spp = 4) {
  const renderer::SensedScene scene = renderer::sensed_scene(file, definition, rig);
  LoadedRecording recording;
  recording.rig.depth_form.camera = rig.depth;
  recording.rig.depth_form.convention = sensors::convention_of(rig.noise);
  recording.rig.colour = recording.view = rig.colour;
  recording.rig.colour_from_depth = rig.colour_from_depth;
  recording.has_light = true;
  recording.light.environment_radiance = definition.environment_radiance;
  recording.light.suns.emplace();
  recording.light.lamps.emplace();
  for (const renderer::FileSun& sun : file.suns) {
    const auto power = static_cast<double>(sun.irradiance_w_m2[0]);
    recording.light.suns->push_back({.to_sun = sun.to_sun, .irradiance_w_m2 = {power, power, power}});
  }
  for (int i = 0; i < frames; ++i) {
    Eigen::Isometry3d pose =
        pose_on_path(path, scene.world_from_colour, frames > 1 ? static_cast<double>(i) / (frames - 1) : 0);
    renderer::SenseSettings settings;
    settings.photograph = {.spp = spp, .seed = 1 + static_cast<std::uint64_t>(i), .threads = 2};
    const renderer::SensedFrame sensed = renderer::sense_frame(scene, rig, pose, settings);
    recording.frames.push_back({.time_s = i / 30.0,
                                .depth = sensed.measured.frame,
                                .colour = display_image(sensed.colour),
                                .world_from_colour = pose});
  }
  return recording;
}

/// A box as a virtual thing: right of the middle, its shadow on the floor.
inline renderer::FileMesh virtual_box() {
  return box("virtual", {-0.15, -0.98, -2.75}, {0.3, -0.4, -2.35}, 0.8F);
}

inline LiveScene scene_with(const LoadedRecording& recording,
                            const std::vector<renderer::FileMesh>& objects) {
  renderer::SceneFile file;
  file.meshes = objects;
  LiveScene empty = live_scene(recording, {}, Eigen::Vector3d::Zero());
  renderer::PhotoObjects placed;
  placed.meshes = renderer::place_meshes(file, Eigen::Affine3d::Identity(), Eigen::Vector3d::Zero(), 0.5, 1);
  renderer::Geometry geometry(placed.meshes, renderer::Edges::loose);
  return {.objects = std::move(placed),
          .geometry = std::move(geometry),
          .light = empty.light,
          .ambient_radiance = empty.ambient_radiance,
          .display_factor = 1};
}

}  // namespace seamline::live::test
