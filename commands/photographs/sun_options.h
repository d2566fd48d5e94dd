#pragma once
#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "stimuli/definition/light_definition.h"

namespace seamline::renderer {

/// `--to-sun`, `--sun-irradiance` and `--sun-radius`, the same for every command that takes a sun.
struct SunOptions {
  std::array<double, 3> to_sun{0, 1, 0};      ///< in the world, of any length
  std::array<double, 3> irradiance{0, 0, 0};  ///< W/m2 on a plane that faces it
  double radius_deg = 0;                      ///< angular
};

/// The first two, of which none is taken without the other; `--to-sun` itself.
CLI::Option* add_sun_options(CLI::App& command, SunOptions& sun, const std::string& what_direction,
                             const std::string& what_irradiance);
/// `--sun-radius`, which needs `to_sun`.
void add_sun_radius_option(CLI::App& command, SunOptions& sun, CLI::Option* to_sun);

/// The sun that they say. Throws InputError at a direction of no length.
[[nodiscard]] SunDefinition sun_of(const SunOptions& sun);

}  // namespace seamline::renderer
