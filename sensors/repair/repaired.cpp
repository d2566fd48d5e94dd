#include "sensors/repair/repaired.h"

namespace seamline::sensors {

Repaired repaired_frame(const DepthFrame& measured, std::vector<float> depth_m) {
  Repaired repaired{.frame = measured, .marks = {}};
  repaired.frame.depth_m = std::move(depth_m);
  repaired.marks.reserve(measured.depth_m.size());
  for (std::size_t i = 0; i < measured.depth_m.size(); ++i) {
    const float before = measured.depth_m[i], after = repaired.frame.depth_m[i];
    const RepairMark mark = DepthFrame::is_hole(after)    ? RepairMark::empty
                            : DepthFrame::is_hole(before) ? RepairMark::invented
                            : after == before             ? RepairMark::kept
                                                          : RepairMark::changed;
    if (mark == RepairMark::invented && !repaired.frame.confidence.empty()) repaired.frame.confidence[i] = 0;
    repaired.marks.push_back(mark);
    ++repaired.counts[static_cast<std::size_t>(mark)];
  }
  return repaired;
}

Repaired without_repair(const DepthFrame& measured) {
  return repaired_frame(measured, measured.depth_m);
}

}  // namespace seamline::sensors
