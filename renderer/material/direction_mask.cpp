#include "renderer/material/direction_mask.h"

namespace seamline::renderer {

DirectionMask empty_mask(int width_px, float elsewhere) {
  DirectionMask mask{
      .width_px = width_px, .height_px = width_px / 2, .texels = {}, .known = {}, .elsewhere = elsewhere};
  mask.texels.assign(static_cast<std::size_t>(mask.width_px) * static_cast<std::size_t>(mask.height_px),
                     elsewhere);
  return mask;
}

}  // namespace seamline::renderer
