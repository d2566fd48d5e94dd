#include "study/trials/object_map.h"

#include <algorithm>
#include <cmath>

#include "study/placement/trial.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::study {
namespace {

struct Bounds {
  int left = 1 << 30, top = 1 << 30, right = -1, bottom = -1;  ///< the last ones are inside

  void add(int x, int y) {
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, x);
    bottom = std::max(bottom, y);
  }
  [[nodiscard]] bool empty() const { return right < 0; }
};

std::vector<PictureFrame> equal_frames(const std::vector<Bounds>& bounds) {
  constexpr double margin_px = 6;
  double width_px = 0, height_px = 0;
  for (const Bounds& b : bounds) {
    if (b.empty()) continue;
    width_px = std::max(width_px, b.right - b.left + 1 + 2 * margin_px);
    height_px = std::max(height_px, b.bottom - b.top + 1 + 2 * margin_px);
  }
  std::vector<PictureFrame> frames(bounds.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (bounds[i].empty()) continue;
    const double x_px = (bounds[i].left + bounds[i].right + 1) / 2.0;
    const double y_px = (bounds[i].top + bounds[i].bottom + 1) / 2.0;
    frames[i] = {std::round(x_px - width_px / 2), std::round(y_px - height_px / 2), width_px, height_px};
  }
  return frames;
}

/// Every object grows by one pixel in each direction, where nothing is yet.
std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& map, int width_px, int height_px,
                                bool with_corners) {
  std::vector<std::uint8_t> result = map;
  const auto at = [&](int x, int y) -> std::uint8_t {
    if (x < 0 || y < 0 || x >= width_px || y >= height_px) return 0;
    return map[grid_index(y, x, width_px)];
  };
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      if (at(x, y) != 0) continue;
      std::uint8_t found = 0;
      for (int dy = -1; dy <= 1 && found == 0; ++dy)
        for (int dx = -1; dx <= 1 && found == 0; ++dx)
          if (with_corners || dx == 0 || dy == 0) found = at(x + dx, y + dy);
      result[grid_index(y, x, width_px)] = found;
    }
  return result;
}

}  // namespace

ObjectMap make_object_map(const ByteImage& object_ids, int reach_px, bool two_eyes, int objects) {
  ObjectMap map{
      .width_px = object_ids.width_px, .height_px = object_ids.height_px, .nearest = object_ids.values};
  map.two_eyes = two_eyes;
  const int left_eye_px = two_eyes ? map.width_px / 2 : map.width_px;
  std::vector<Bounds> bounds(objects), right_eye_bounds(bounds.size());
  for (int y = 0; y < map.height_px; ++y)
    for (int x = 0; x < map.width_px; ++x) {
      std::uint8_t& id = map.nearest[grid_index(y, x, map.width_px)];
      if (id >= 1 && id <= objects)
        (x < left_eye_px ? bounds : right_eye_bounds).at(id - 1U).add(x, y);
      else
        id = 0;
    }
  map.frames = equal_frames(bounds);
  map.right_eye_frames = equal_frames(right_eye_bounds);
  for (int step = 0; step < reach_px; ++step)  // by turns without and with corners: nearly a disc
    map.nearest = grown(map.nearest, map.width_px, map.height_px, step % 2 == 1);
  return map;
}

namespace {

/// So many columns to the left, those on the left coming in again on the right.
std::vector<std::uint8_t> rolled(const std::vector<std::uint8_t>& map, int width_px, int columns) {
  std::vector<std::uint8_t> out = map;
  for (auto row = out.begin(); row != out.end(); row += width_px)
    std::rotate(row, row + columns, row + width_px);
  return out;
}

/// A column that objects have least of.
int emptiest_column(const ByteImage& ids) {
  std::vector<int> found(ids.width_px, 0);
  for (std::size_t i = 0; i < ids.values.size(); ++i)
    if (ids.values[i] != 0) ++found[i % found.size()];
  return static_cast<int>(std::min_element(found.begin(), found.end()) - found.begin());
}

}  // namespace

ObjectMap make_panorama_map(const ByteImage& object_ids, int reach_px, int objects) {
  const int width_px = object_ids.width_px, columns = emptiest_column(object_ids);
  ByteImage turned = object_ids;
  turned.values = rolled(object_ids.values, width_px, columns);
  ObjectMap map = make_object_map(turned, reach_px, false, objects);
  map.nearest = rolled(map.nearest, width_px, (width_px - columns) % width_px);
  for (PictureFrame& frame : map.frames)
    if (frame.width_px > 0) frame.x_px = std::fmod(frame.x_px + columns + width_px, width_px);
  return map;
}

int object_at(const ObjectMap& map, double x_px, double y_px) {
  if (x_px < 0 || y_px < 0 || x_px >= map.width_px || y_px >= map.height_px) return 0;
  return map.nearest[grid_index(static_cast<int>(y_px), static_cast<int>(x_px), map.width_px)];
}

}  // namespace seamline::study
