#pragma once
#include <array>
#include <cstdint>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace seamline {

/// --at and --look-at of a rig in a scene, which need each other. Returns --at, beside which the scene's own
/// camera says nothing.
CLI::Option* add_rig_place(CLI::App& command, std::array<double, 3>& at_m, std::array<double, 3>& look_at_m);

/// --noise and --seed.
void add_noise_options(CLI::App& command, double& noise_scale, std::uint64_t& seed);

/// Light and samples of what its colour camera photographs.
struct RigPhotographOptions {
  std::array<double, 3> environment{1, 1, 1};  ///< radiance, W/m2/sr
  int bounces = 4, spp = 64;
  double exposure_ev = 0;
};

/// --environment, --bounces, --spp and --exposure.
void add_photograph_options(CLI::App& command, RigPhotographOptions& photograph);

}  // namespace seamline
