#include "live/frame/stage_times.h"

#include <numeric>

namespace seamline::live {

std::string_view word(Stage stage) {
  switch (stage) {
    case Stage::tracking:
      return "tracking";
    case Stage::physics:
      return "physics";
    case Stage::local_scene:
      return "local_scene";
    case Stage::mapping:
      return "mapping";
    case Stage::tree:
      return "tree";
    case Stage::maps:
      return "maps";
    case Stage::views:
      return "views";
    case Stage::object:
      return "object";
    case Stage::shadow:
      return "shadow";
    case Stage::show:
      return "show";
  }
  return {};
}

double StageTimes::total_ms() const {
  return std::accumulate(ms.begin(), ms.end(), 0.0);
}

}  // namespace seamline::live
