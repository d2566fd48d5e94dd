#pragma once
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "commands/options/setting_option.h"
#include "renderer/depth/depth_mesh.h"
#include "support/text/counted.h"
#include "support/text/number_option.h"

namespace seamline::renderer {

// What `mesh` and `composite` ask about a panoramic depth map.

inline constexpr NumberRange any_yaw_texels{-16384, 16384, "texels"};

struct MeshCommandOptions {
  std::string depth, out;
  MeshDensity density = MeshDensity::adaptive;
  double tolerance = 1e-4;
  double yaw_texels = 0;
};

inline void add_mesh_options(CLI::App& command, MeshCommandOptions& options) {
  add_choice(command, "--mesh", options.density, std::array{MeshDensity::adaptive, MeshDensity::full},
             "adaptive or full");
  add_number(command, "--tolerance", options.tolerance, {1e-9, 1},
             "largest relative error of the adaptive mesh along a ray")
      ->capture_default_str();
}

/// By which the panorama was turned.
inline CLI::Option* add_yaw_option(CLI::App& command, MeshCommandOptions& options) {
  return add_number(command, "--yaw", options.yaw_texels, any_yaw_texels, "by which the map was turned")
      ->capture_default_str();
}

/// The mesh of the map; texels that are no distances are said on standard error.
[[nodiscard]] inline DepthMesh panorama_mesh_of(const MeshCommandOptions& options) {
  const DepthMap map = read_depth_map(options.depth);
  if (map.cleaned_texels > 0)
    fmt::print(stderr, "{}: {} 0, negative, not a number or beyond 1e9 m and {}\n", options.depth,
               counted(map.cleaned_texels, "texel was", "texels were"),
               map.cleaned_texels == 1 ? "is read as a hole" : "are read as holes");
  return build_depth_mesh(
      map, {.density = options.density, .tolerance = options.tolerance, .yaw_texels = options.yaw_texels});
}

/// Refuses a file name whose ending, in capitals or not, does not say what will be in the file.
void need_extension(const std::string& file, std::initializer_list<const char*> endings,
                    const char* option = "--out");

}  // namespace seamline::renderer
