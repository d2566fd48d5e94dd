#include "composites/place/place_page.h"

#include <algorithm>

#include "window/look.h"

namespace seamline::place {

Rect picture_in(const Size& screen_px, double aspect) {
  const double room_px = std::max(1.0, screen_px.height_px - bar_px);
  const double width_px = std::min(screen_px.width_px, room_px * aspect);
  return {(screen_px.width_px - width_px) / 2, (room_px - width_px / aspect) / 2, width_px,
          width_px / aspect};
}

void draw_page(Canvas& canvas, const Rect& picture, const WindowTexture& texture, const Size& screen_px,
               const Bar& bar) {
  canvas.picture(texture, picture);
  const double y_px = screen_px.height_px - bar_px + margin_px;
  canvas.text(Font::body, {margin_px, y_px}, bar.line, look::ink_on_background);
  canvas.text(Font::small, {margin_px, y_px + 1.5 * type_px}, bar.help, look::quiet_on_background);
  const Size said = canvas.measure(Font::body, bar.said);
  canvas.text(Font::body, {screen_px.width_px - said.width_px - margin_px, y_px}, bar.said,
              bar.warned ? look::problem : look::ink_on_background);
}

}  // namespace seamline::place
