#include "renderer/ray_memory.h"

#include <embree3/rtcore.h>

#include <atomic>

#include "renderer/geometry.h"

namespace seamline {
namespace {

std::atomic<std::int64_t> counted_bytes = 0;

bool count(void* /*user*/, ssize_t bytes, bool /*post*/) {
  counted_bytes += bytes;
  return true;
}

RTCDevice device() {
  return static_cast<RTCDevice>(RayDevice::instance().handle());
}

}  // namespace

RayMemoryMeter::RayMemoryMeter() {
  counted_bytes = 0;
  rtcSetDeviceMemoryMonitorFunction(device(), count, nullptr);
}

RayMemoryMeter::~RayMemoryMeter() {
  rtcSetDeviceMemoryMonitorFunction(device(), nullptr, nullptr);
}

std::int64_t RayMemoryMeter::bytes() const {
  return counted_bytes;
}

}  // namespace seamline
