#include "stimuli/definition/views/look_definition.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {

std::string_view word(LookKind kind) {
  switch (kind) {
    case LookKind::fixed:
      return "fixed";
    case LookKind::mouse:
      return "mouse";
    case LookKind::head:
      return "head";
  }
  return "";
}

std::string canonical_text(const LookDefinition& look) {
  std::string out = fmt::format("{} {} x {} px {} degrees", word(look.kind), look.view_px[0], look.view_px[1],
                                look.horizontal_fov_deg);
  if (look.start_deg) out += fmt::format(" start {} {}", (*look.start_deg)[0], (*look.start_deg)[1]);
  out += fmt::format(" yaw {} {} pitch {} {}", look.yaw_deg[0], look.yaw_deg[1], look.pitch_deg[0],
                     look.pitch_deg[1]);
  if (look.start_spread_deg > 0) out += fmt::format(" start within {}", look.start_spread_deg);
  return look.follows_device ? out + " follows device" : out;
}

}  // namespace seamline::inline stimuli
