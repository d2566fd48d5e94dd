#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "commands/photographs/depth_options.h"
#include "commands/photographs/mesh_options.h"
#include "commands/photographs/sun_options.h"
#include "composites/composite_request.h"

namespace seamline::renderer {

/// What the command line says, before it is a request.
struct CompositeOptions {
  CompositeRequest request;
  MeshCommandOptions mesh;
  DepthOptions depth;
  std::string projection = "auto", depth_view = "auto", view, shadows = "cast", repair = "none", seamless,
              asset_root;
  std::optional<sensors::DepthConvention> depth_kind;
  std::optional<Estimator> estimator;
  sensors::Jumps jumps = sensors::Jumps::stretch;
  MaterialModel materials = MaterialModel::gltf;
  std::string object, objects, transparent, environment_map;
  std::array<double, 3> position_m{0, 0, -3}, rotation_deg{0, 0, 0}, look_at_m{0, 0, -1},
      environment{0, 0, 0};
  SunOptions sun;
  std::array<double, 6> lamp{0, 0, 0, 0, 0, 0}, virtual_lamp = lamp, virtual_sun = lamp;
  bool rest = false;
  double scale = 1, height_m = 1, fov_deg = 60, object_albedo = 0.5, metallic = 0, roughness = 0,
         rotation_of_map_deg = 0, jump_ratio = 1.1, error = 0.0039;
  int depth_width_px = 0;
  std::int64_t depth_samples = 0;
  bool keeps_sun = false;
};

/// The options of `composite`, most of which `place` has as well. What they say is in `options`, which lives
/// as long as the command.
void add_composite_options(CLI::App& command, CompositeOptions& options);

}  // namespace seamline::renderer
