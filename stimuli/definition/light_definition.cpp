#include "stimuli/definition/light_definition.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {
namespace {

template <class Three>
std::string three(const Three& v) {
  return fmt::format("[{},{},{}]", v[0], v[1], v[2]);
}

}  // namespace

std::string canonical_text(const SunDefinition& sun) {
  return fmt::format("sun {} {} {}\n", three(sun.to_sun), three(sun.irradiance_w_m2), sun.angular_radius_deg);
}

std::string canonical_text(const LampDefinition& lamp) {
  std::string out = fmt::format("lamp {} {}", three(lamp.position_m), three(lamp.intensity_w_sr));
  if (lamp.is_spot)
    out += fmt::format(" spot {} {} {}", three(lamp.shines_along), lamp.inner_deg, lamp.outer_deg);
  return out + "\n";
}

std::string canonical_text(const EnvironmentDefinition& environment) {
  return fmt::format("environment map {} {} {}\n", environment.file, environment.rotation_deg,
                     environment.strength);
}

}  // namespace seamline::inline stimuli
