#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sensors/frame/depth_frame.h"

namespace seamline::sensors {

/// What a repair did to a pixel.
enum class RepairMark : std::uint8_t {
  empty,     ///< still without depth
  kept,      ///< as it was measured, bit for bit
  changed,   ///< measured, and now another value
  invented,  ///< was a hole and has a depth now
};
inline constexpr int repair_mark_count = 4;

/// A frame after a repair, and what was done to each pixel. Amplitudes stay; the confidence of invented
/// pixels is 0.
struct Repaired {
  DepthFrame frame;
  std::vector<RepairMark> marks;
  std::array<std::int64_t, repair_mark_count> counts{};  ///< pixels of each mark

  [[nodiscard]] std::int64_t count(RepairMark mark) const { return counts[static_cast<std::size_t>(mark)]; }
};

/// Marks and counts the difference between what was measured and what a repair made of it: the only place
/// where marks are made, so that none can be forgotten.
[[nodiscard]] Repaired repaired_frame(const DepthFrame& measured, std::vector<float> depth_m);

/// Nothing is done: every pixel is kept or empty.
[[nodiscard]] Repaired without_repair(const DepthFrame& measured);

}  // namespace seamline::sensors
