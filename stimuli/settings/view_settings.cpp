#include "stimuli/settings/view_settings.h"

namespace seamline::inline stimuli {

std::string sheet_text(const View& view) {
  return ", " + settings_text(view.sheet);
}

bool is_usual_sheet(const View& view) {
  return view.sheet == LensSheet{};
}

std::string panel_text(const View& view) {
  return view.names_panel() ? fmt::format(", panel {} x {}", view.panel_px[0], view.panel_px[1])
                            : std::string();
}

bool names_no_panel(const View& view) {
  return !view.names_panel();
}

std::string_view word(ViewKind kind) {
  return word_of(kind);
}
std::string_view word(AnaglyphMatrix matrix) {
  return word_of(matrix);
}

bool uses(ViewKind kind, std::string_view key) {
  if (kind == ViewKind::mono) return false;
  for (const Setting<LensSheet>& row : settings_of<LensSheet>)
    if (row.key == key) return kind == ViewKind::interleaved;
  return is_used(setting<View>(key), View{.kind = kind});
}

std::string kinds_that_use(std::string_view key) {
  std::string text;
  for (const ViewKind kind : {ViewKind::side_by_side, ViewKind::anaglyph, ViewKind::interleaved,
                              ViewKind::depth_image, ViewKind::omnidirectional})
    if (uses(kind, key)) text += fmt::format("{}\"{}\"", text.empty() ? "" : " or ", word_of(kind));
  return text;
}

std::string canonical_text(const View& view) {
  return settings_text(view);
}

}  // namespace seamline::inline stimuli
