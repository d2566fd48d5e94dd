#pragma once
#include <atomic>
#include <cstdint>
#include <string>

namespace seamline::renderer {

/// The process-wide Embree device.
class RayDevice {
 public:
  RayDevice();
  ~RayDevice();
  RayDevice(const RayDevice&) = delete;
  RayDevice& operator=(const RayDevice&) = delete;
  /// The instruction set that Embree was told to use, e.g. "avx2"; recorded in manifests, because it changes
  /// last bits.
  [[nodiscard]] static std::string instruction_set();
  [[nodiscard]] static RayDevice& instance();
  /// What all Embree scenes of the process take now, without the arrays they share.
  [[nodiscard]] std::int64_t memory_bytes() const { return memory_bytes_; }
  [[nodiscard]] void* handle() const { return device_; }

 private:
  void* device_;
  std::atomic<std::int64_t> memory_bytes_ = 0;
};

}  // namespace seamline::renderer
