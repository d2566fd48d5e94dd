#pragma once
#include <embree3/rtcore.h>

#include "renderer/tracing/geometry.h"

// Inside the files that call Embree only.
namespace seamline::renderer {

[[nodiscard]] inline RTCDevice embree_device() {
  return static_cast<RTCDevice>(RayDevice::instance().handle());
}

[[nodiscard]] inline RTCScene as_scene(void* scene) {
  return static_cast<RTCScene>(scene);
}

}  // namespace seamline::renderer
