#include "live/frame/stage_times.h"

#include <numeric>

namespace seamline::live {

std::string_view word(FrameStage stage) {
  switch (stage) {
    case FrameStage::tracking:
      return "tracking";
    case FrameStage::physics:
      return "physics";
    case FrameStage::local_scene:
      return "local_scene";
    case FrameStage::mapping:
      return "mapping";
    case FrameStage::tree:
      return "tree";
    case FrameStage::maps:
      return "maps";
    case FrameStage::views:
      return "views";
    case FrameStage::object:
      return "object";
    case FrameStage::shadow:
      return "shadow";
    case FrameStage::show:
      return "show";
  }
  return {};
}

double StageTimes::total_ms() const {
  return std::accumulate(ms.begin(), ms.end(), 0.0);
}

}  // namespace seamline::live
