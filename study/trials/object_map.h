#pragma once
#include <cstdint>
#include <vector>

#include "study/placement/trial.h"
#include "support/files/image.h"

namespace seamline::study {

/// A frame in picture pixels, x to the right, y downwards from the top left.
struct PictureFrame {
  double x_px = 0, y_px = 0, width_px = 0, height_px = 0;
  bool operator==(const PictureFrame&) const = default;
};

/// Where the objects of a scene are, from its reference's click map: the same for every stimulus of the
/// scene, so nothing that is drawn from it tells which object was inserted. Picture pixels.
struct ObjectMap {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> nearest;  ///< 0, or the object within reach of the pixel, from 1
  /// Frames around the objects: each has its object's middle, and all have the size of the largest one.
  std::vector<PictureFrame> frames = {};
  bool two_eyes = false;  ///< the halves of the picture are two eyes' own, with each object in both
  std::vector<PictureFrame> right_eye_frames = {};  ///< likewise in the right half, if so
};

/// How far beside an object a click counts.
inline constexpr int usual_reach_px = 8;

/// `object_ids`: 1 channel, 0 background, 1 to `objects`. A click counts up to `reach_px` outside of an
/// object, for the nearest one; thin objects could hardly be hit otherwise. `two_eyes`: of a picture side by
/// side.
[[nodiscard]] ObjectMap make_object_map(const ByteImage& object_ids, int reach_px = usual_reach_px,
                                        bool two_eyes = false, int objects = objects_per_stimulus);

/// The same of a panorama, whose last column stands beside its first: a frame may reach beyond the last.
[[nodiscard]] ObjectMap make_panorama_map(const ByteImage& object_ids, int reach_px = usual_reach_px,
                                          int objects = objects_per_stimulus);

/// The object at a place of the picture, from 1, or 0.
[[nodiscard]] int object_at(const ObjectMap& map, double x_px, double y_px);

}  // namespace seamline::study
