#include "renderer/tracing/ray_memory.h"

#include <atomic>

#include "renderer/tracing/embree_handles.h"

namespace seamline::renderer {
namespace {

std::atomic<std::int64_t> counted_bytes = 0;

bool count(void* /*user*/, ssize_t bytes, bool /*post*/) {
  counted_bytes += bytes;
  return true;
}

}  // namespace

RayMemoryMeter::RayMemoryMeter() {
  counted_bytes = 0;
  rtcSetDeviceMemoryMonitorFunction(embree_device(), count, nullptr);
}

RayMemoryMeter::~RayMemoryMeter() {
  rtcSetDeviceMemoryMonitorFunction(embree_device(), nullptr, nullptr);
}

std::int64_t RayMemoryMeter::bytes() const {
  return counted_bytes;
}

}  // namespace seamline::renderer
