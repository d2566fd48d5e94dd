#include "commands/depth_cameras/rig_options.h"

#include <CLI/CLI.hpp>

#include "support/text/number_option.h"

namespace seamline {

CLI::Option* add_rig_place(CLI::App& command, std::array<double, 3>& at_m, std::array<double, 3>& look_at_m) {
  CLI::Option* at = add_number(command, "--at", at_m, any_place_m,
                               "the colour camera's place (default: the scene's camera)");
  CLI::Option* look_at = add_number(command, "--look-at", look_at_m, any_place_m, "the point it looks at");
  at->needs(look_at);
  look_at->needs(at);
  return at;
}

void add_noise_options(CLI::App& command, double& noise_scale, std::uint64_t& seed) {
  add_number(command, "--noise", noise_scale, {0, 1e6},
             "scale of the sensor's noise; 0: none, its holes stay")
      ->capture_default_str();
  add_number(command, "--seed", seed, any_seed, "seed of noise and samples")->capture_default_str();
}

void add_photograph_options(CLI::App& command, RigPhotographOptions& photograph) {
  add_number(command, "--environment", photograph.environment, {0, limits::strongest_light, "W/m2/sr"},
             "environment radiance R G B of photographs; the default is a study's, while picture has none")
      ->capture_default_str();
  add_number(command, "--bounces", photograph.bounces, {0, 1024}, "further diffuse scatterings")
      ->capture_default_str();
  add_number(command, "--spp", photograph.spp, {1, 65536}, "samples per pixel of photographs")
      ->capture_default_str();
  add_number(command, "--exposure", photograph.exposure_ev, {-60, 60, "stops"}, "of photographs")
      ->capture_default_str();
}

}  // namespace seamline
