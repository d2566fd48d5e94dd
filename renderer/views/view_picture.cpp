#include "renderer/views/view_picture.h"

#include <algorithm>
#include <array>
#include <vector>

#include "renderer/views/anaglyph.h"
#include "renderer/views/depth_image.h"
#include "renderer/views/lens_sheet.h"
#include "stimuli/definition/parts/task_definition.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

/// The click map of a picture in which the same pixel belongs to all eyes.
ByteImage seen_by_most(const ByteImage& all_eyes, int eyes) {
  const int width_px = all_eyes.width_px / eyes;
  ByteImage ids{width_px, all_eyes.height_px, 1, {}};
  for (int y = 0; y < all_eyes.height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      std::array<int, most_objects_of_scene + 1> votes{};
      for (int eye = 0; eye < eyes; ++eye)
        ++votes.at(all_eyes.values[grid_index(y, eye * width_px + x, all_eyes.width_px)]);
      const auto most = std::max_element(votes.begin() + 1, votes.end());
      ids.values.push_back(static_cast<std::uint8_t>(*most > 0 ? most - votes.begin() : 0));
    }
  return ids;
}

/// Without the one from the axis, which eyes see only on the mesh.
Image panoramas_of_eyes(const View& view, const Image& all) {
  if (view.panoramas() == view.views) return all;
  Image eyes(all.width_px, all.height_px / view.panoramas() * view.views, all.channels);
  std::copy_n(all.values.begin(), eyes.values.size(), eyes.values.begin());
  return eyes;
}

}  // namespace

Image compose_view(const View& view, const Image& all_eyes) {
  switch (view.kind) {
    case ViewKind::mono:
    case ViewKind::side_by_side:
    case ViewKind::depth_image:
      return all_eyes;
    case ViewKind::omnidirectional:
      return panoramas_of_eyes(view, all_eyes);
    case ViewKind::anaglyph:
      return anaglyph(view.matrix, all_eyes);
    case ViewKind::interleaved:
      return interleave(sheet_screen(view, all_eyes.width_px / view.views), all_eyes);
  }
  return all_eyes;
}

Image shown_to_each_eye(const View& view, Image all_eyes) {
  if (view.kind != ViewKind::anaglyph && view.kind != ViewKind::interleaved) return all_eyes;
  const Image shown = compose_view(view, all_eyes);
  for (int y = 0; y < all_eyes.height_px; ++y)
    for (int x = 0; x < all_eyes.width_px; ++x) all_eyes.set_rgb(x, y, shown.rgb(x % shown.width_px, y));
  return all_eyes;
}

ByteImage shown_bytes(const View& view, const Image& picture, double exposure_ev, const Image& planar_m) {
  ByteImage bytes = display_image(picture, exposure_ev);
  if (view.kind != ViewKind::depth_image) return bytes;
  return beside(bytes, depth_codes(planar_m, view.max_depth_m));
}

ByteImage eye_of(const View& view, const ByteImage& all_eyes, int eye) {
  if (view.kind != ViewKind::omnidirectional) return all_eyes;
  ByteImage one{all_eyes.width_px, all_eyes.width_px / 2, all_eyes.channels, {}};
  const std::ptrdiff_t values = std::ptrdiff_t{one.width_px} * one.height_px * one.channels;
  one.values.assign(all_eyes.values.begin() + eye * values, all_eyes.values.begin() + (eye + 1) * values);
  return one;
}

ByteImage view_click_map(const View& view, const ByteImage& all_eyes) {
  switch (view.kind) {
    case ViewKind::mono:
    case ViewKind::side_by_side:
    case ViewKind::omnidirectional:
      return all_eyes;
    case ViewKind::anaglyph:
    case ViewKind::interleaved:
      return seen_by_most(all_eyes, view.views);
    case ViewKind::depth_image:
      return beside(all_eyes, {all_eyes.width_px, all_eyes.height_px, 1,
                               std::vector<std::uint8_t>(all_eyes.values.size())});
  }
  return all_eyes;
}

}  // namespace seamline::renderer
