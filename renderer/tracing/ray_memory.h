#pragma once
#include <cstdint>

namespace seamline::renderer {

/// Counts the memory that Embree asks for while the meter lives: bounding volume hierarchies and its copies
/// of vertices. Only one meter may live at a time, because Embree knows one listener.
class RayMemoryMeter {
 public:
  RayMemoryMeter();
  ~RayMemoryMeter();
  RayMemoryMeter(const RayMemoryMeter&) = delete;
  RayMemoryMeter& operator=(const RayMemoryMeter&) = delete;

  /// Allocated since the meter began, less what was given back.
  [[nodiscard]] std::int64_t bytes() const;
};

}  // namespace seamline::renderer
