#pragma once
#include <cstdint>

#include "x3d/x3d_subject.h"

namespace seamline::renderer {

struct X3dSummary {
  int files = 0;
  std::int64_t bytes = 0;
  std::int64_t object_pixels = 0;  ///< that the object would cover with nothing before it
  std::int64_t hidden_pixels = 0;  ///< of those, with something real in front
  std::vector<std::string> notes = {};
};

/// Writes a folder that shows the subject in X3DOM, whole or not at all: `index.html`, X3DOM with its
/// licence, `program.png` (the program's own picture, traced) and `in_front.png` (who is in front in each
/// pixel's centre: 0 nothing virtual, 128 the real world, 255 the object). Throws InputError where the
/// program was built without X3DOM, the folder holds something, or the object has more triangles than a page
/// can hold.
X3dSummary export_x3d(const X3dRequest& request);

}  // namespace seamline::renderer
