#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "commands/depth_cameras/rig_options.h"
#include "commands/options/output_files.h"
#include "laboratory/settling/frame_ground.h"
#include "laboratory/settling/sensed_depth.h"
#include "raytracer/common/parallel.h"
#include "renderer/realtime/depth_normals.h"
#include "sensors/repair/planes.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/interrupt.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct RelightOptions {
  DepthSubject sensed;
  std::string out;
  std::array<double, 3> to_sun{-0.5, 0.7, 0.5};
  double tolerance_m = 0.03;
  int enlarge = 4, frames = 2;
};

/// Depth as a mesh in its camera's frame, drawn from there in pixels that are so many times finer.
struct DrawnMesh {
  std::vector<Eigen::Vector3f> positions_m;
  std::vector<Triangle> triangles;
  DrawView view;
  DepthPicture depth;
};

DrawnMesh draw(const sensors::DepthFrame& frame, int enlarge, int threads) {
  FrameGround ground(Eigen::Isometry3d::Identity());
  ground.take(frame);
  DrawnMesh mesh;
  for (const Eigen::Vector3d& vertex_m : ground.ground().vertices_m)
    mesh.positions_m.push_back(vertex_m.cast<float>());
  mesh.triangles = ground.ground().triangles;
  const sensors::PinholeCamera& camera = frame.camera;
  mesh.view.from_point = true;
  mesh.view.corner = Eigen::Array2d(-camera.cx_px / camera.fx_px, -camera.cy_px / camera.fy_px).cast<float>();
  mesh.view.size =
      Eigen::Array2d(camera.width_px / camera.fx_px, camera.height_px / camera.fy_px).cast<float>();
  mesh.depth = empty_picture(camera.width_px * enlarge, camera.height_px * enlarge);
  const TriangleSpan span{mesh.positions_m, mesh.triangles};
  draw_depth(mesh.view, std::span(&span, 1), threads, mesh.depth);
  return mesh;
}

/// The mesh as a white thing under one virtual sun and a little light from everywhere; black where nothing
/// is.
Image lit(const sensors::DepthFrame& frame, const Eigen::Vector3f& to_sun, int enlarge, int threads) {
  constexpr float ambient = 0.12F, sun = 0.75F;
  const DrawnMesh mesh = draw(frame, enlarge, threads);
  const TriangleSpan span{mesh.positions_m, mesh.triangles};
  const NormalPicture normals = draw_normals(mesh.view, span, triangle_mean_normals(span), mesh.depth);
  Image image(normals.width_px, normals.height_px, 3);
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x) {
      const Eigen::Vector3f& normal = normals.at(x, y);
      if (normal.isZero()) continue;
      image.set_rgb(x, y, Rgb::Constant(ambient + sun * std::max(0.0F, normal.dot(to_sun))));
    }
  return image;
}

/// Mean square of the difference of two pictures, in display codes.
double square_of_difference(const ByteImage& one, const ByteImage& other) {
  double sum = 0;
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    const double step = double{1} * one.values[i] - other.values[i];
    sum += step * step;
  }
  return sum / one.values.size();
}

ByteImage difference_of(const ByteImage& one, const ByteImage& other) {
  ByteImage out = one;
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = static_cast<std::uint8_t>(std::abs(int{one.values[i]} - int{other.values[i]}));
  return out;
}

void run_relight(const RelightOptions& options) {
  const std::filesystem::path folder = options.out;
  const Eigen::Vector3d to_sun(options.to_sun[0], options.to_sun[1], options.to_sun[2]);
  if (!(to_sun.norm() > 0))
    throw input_error({.field = "--to-sun", .wanted = "a direction", .found = "0 0 0"});
  const SensedDepth depth = sense_depth(options.sensed);
  const Eigen::Vector3f here =
      (depth.world_from_depth.linear().transpose() * to_sun.normalized()).cast<float>();
  prepare_output_folder(folder);
  const int threads = default_thread_count();
  const auto picture = [&](const sensors::DepthFrame& frame) {
    return display_image(lit(frame, here, options.enlarge, threads));
  };
  const auto planes = [&](int frame) {
    return sensors::replace_planes(depth.measured(frame), {.tolerance_m = options.tolerance_m})
        .repaired.frame;
  };
  const ByteImage exact = picture((*depth.exact)(0));
  write_png(folder / "exact.png", exact);
  Progress progress("relight", 2.0 * options.frames);
  const std::vector<std::pair<std::string, DepthSequence>> sequences = {{"measured", depth.measured},
                                                                        {"planes", planes}};
  for (const auto& [name, sequence] : sequences) {
    double between = 0, from_exact = 0;
    ByteImage before;
    for (int frame = 0; frame < options.frames; ++frame) {
      stop_if_interrupted();
      const ByteImage now = picture(sequence(frame));
      from_exact += square_of_difference(now, exact) / options.frames;
      if (frame > 0) between += square_of_difference(now, before) / (options.frames - 1);
      if (frame < 2) write_png(folder / fmt::format("{}_{}.png", name, frame), now);
      if (frame == 1) write_png(folder / (name + "_difference.png"), difference_of(now, before));
      before = now;
      progress.advance(1, name);
    }
    fmt::print(
        "{:<9} differs from frame to frame by {:.1f} of 255 codes, from exact depth by {:.1f} (root mean "
        "square)\n",
        name, std::sqrt(between), std::sqrt(from_exact));
  }
  fmt::print("{}\n", options.out);
}

}  // namespace

void add_relight_command(CLI::App& app) {
  auto options = std::make_shared<RelightOptions>();
  CLI::App* command =
      app.add_subcommand("relight", "a virtual light on the mesh of measured depth, which flickers");
  command->add_option("scene", options->sensed.scene, ".glb, .gltf or builtin:NAME")->required();
  command->add_option("--sensor", options->sensed.sensor, "preset of a rig (documentation/how-to/sensors.md)")
      ->required();
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  CLI::Option* at = add_rig_place(*command, options->sensed.at_m, options->sensed.look_at_m);
  add_number(*command, "--to-sun", options->to_sun, {-1e9, 1e9},
             "towards the virtual light, in the scene's world")
      ->capture_default_str();
  add_noise_options(*command, options->sensed.noise_scale, options->sensed.seed);
  add_number(*command, "--plane-tolerance", options->tolerance_m, {1e-6, 10, "m"},
             "what lies so near to a plane is replaced by it")
      ->capture_default_str();
  add_number(*command, "--enlarge", options->enlarge, {1, 16},
             "pixels of the pictures for one of the sensor, a side")
      ->capture_default_str();
  add_number(*command, "--frames", options->frames, {2, 1000000},
             "of the sensor, over which the flicker is taken")
      ->capture_default_str();
  command->callback([options, at, command] {
    require_outputs_in_folder(
        *command, {"exact.png", "measured_0.png", "measured_1.png", "measured_difference.png", "planes_0.png",
                   "planes_1.png", "planes_difference.png"});
    options->sensed.has_place = at->count() > 0;
    run_relight(*options);
  });
}

}  // namespace seamline::renderer
