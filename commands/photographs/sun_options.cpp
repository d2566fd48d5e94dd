#include "commands/photographs/sun_options.h"

#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/number_option.h"

namespace seamline::renderer {

CLI::Option* add_sun_options(CLI::App& command, SunOptions& sun, const std::string& what_direction,
                             const std::string& what_irradiance) {
  CLI::Option* to_sun = add_number(command, "--to-sun", sun.to_sun, {-1e9, 1e9}, what_direction);
  CLI::Option* irradiance = add_number(command, "--sun-irradiance", sun.irradiance,
                                       {0, limits::strongest_light, "W/m2"}, what_irradiance);
  to_sun->needs(irradiance);
  irradiance->needs(to_sun);
  return to_sun;
}

void add_sun_radius_option(CLI::App& command, SunOptions& sun, CLI::Option* to_sun) {
  add_number(command, "--sun-radius", sun.radius_deg, {0, 45, "degrees"}, "angular radius of that sun")
      ->capture_default_str()
      ->needs(to_sun);
}

SunDefinition sun_of(const SunOptions& sun) {
  const Eigen::Vector3d to_sun = Eigen::Map<const Eigen::Vector3d>(sun.to_sun.data());
  if (!(to_sun.norm() > 0))
    throw input_error({.field = "--to-sun", .wanted = "a direction that is not zero", .found = "0 0 0"});
  return {to_sun.normalized(), sun.irradiance, sun.radius_deg};
}

}  // namespace seamline::renderer
