#include "scenes/clay.h"
#include "scenes/objects.h"

namespace seamline {

Sculpture sculpt_statue() {
  Sculpture sculpture;
  auto& clay = sculpture.strokes;
  clay.push_back(limb({{{0, 0.1, 0}, 0.15}, {{0, 1.4, 0}, 0.1}}, 0.05));
  return sculpture;
}

}  // namespace seamline
