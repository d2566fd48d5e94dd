#include "stimuli/definition/views/view.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {

std::string_view word(ViewKind kind) {
  switch (kind) {
    case ViewKind::mono:
      return "mono";
    case ViewKind::side_by_side:
      return "side_by_side";
    case ViewKind::anaglyph:
      return "anaglyph";
    case ViewKind::interleaved:
      return "interleaved";
    case ViewKind::depth_image:
      return "2d_plus_depth";
  }
  return {};
}

std::string_view word(AnaglyphMatrix matrix) {
  switch (matrix) {
    case AnaglyphMatrix::colour:
      return "colour";
    case AnaglyphMatrix::half_colour:
      return "half_colour";
    case AnaglyphMatrix::grey:
      return "grey";
    case AnaglyphMatrix::dubois:
      return "dubois";
  }
  return {};
}

bool uses(ViewKind kind, std::string_view key) {
  if (kind == ViewKind::mono) return false;
  if (key == "panel_px") return true;
  if (key == "max_depth_m") return kind == ViewKind::depth_image;
  if (key == "matrix") return kind == ViewKind::anaglyph;
  if (key == "separation_m" || key == "zero_parallax_m") return kind != ViewKind::depth_image;
  return kind == ViewKind::interleaved;
}

std::string kinds_that_use(std::string_view key) {
  std::string text;
  for (const ViewKind kind :
       {ViewKind::side_by_side, ViewKind::anaglyph, ViewKind::interleaved, ViewKind::depth_image})
    if (uses(kind, key)) text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", word(kind));
  return text;
}

std::string canonical_text(const View& view) {
  if (view.is_mono()) return {};
  std::string text(word(view.kind));
  if (view.kind == ViewKind::depth_image)
    text += fmt::format(", depth up to {} m", view.max_depth_m);
  else
    text += fmt::format(", {} views {} m apart, zero parallax {} m", view.views, view.separation_m,
                        view.zero_parallax_m);
  if (view.kind == ViewKind::anaglyph) text += fmt::format(", matrix {}", word(view.matrix));
  if (view.kind == ViewKind::interleaved)
    text += fmt::format(", pitch {} slant {} offset {}", view.sheet.pitch_subpixels, view.sheet.slant_deg,
                        view.sheet.offset_subpixels);
  if (view.names_panel()) text += fmt::format(", panel {} x {}", view.panel_px[0], view.panel_px[1]);
  return text;
}

}  // namespace seamline::inline stimuli
