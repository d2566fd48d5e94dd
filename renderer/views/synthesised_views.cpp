#include "renderer/views/synthesised_views.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace seamline::renderer {
namespace {

constexpr double largest_stretch_px = 1.5;  // of one surface between two neighbours

/// One row of a view in the making.
class ViewRow {
 public:
  ViewRow(const PictureWithDepth& from, const BesideEye& eye, int y, SynthesisedView& out)
      : from_(from), eye_(eye), y_(y), out_(out) {
    const int width_px = from.colour.width_px;
    nearness_.assign(static_cast<std::size_t>(width_px), -1.0F);
    for (int x = 0; x < width_px; ++x)
      at_px_.push_back(x + 0.5 + shift_px(eye, static_cast<double>(from.planar_m.at(x, y))));
  }

  void move_pixels() {
    const int width_px = from_.colour.width_px;
    bool joined = false;  // to the pixel on the left
    for (int x = 0; x < width_px; ++x) {
      if (!joined) cover(at_px_[place(x)] - 0.5, at_px_[place(x)], x, x);
      joined =
          x + 1 < width_px && std::abs(at_px_[place(x + 1)] - at_px_[place(x)] - 1) <= largest_stretch_px;
      if (joined)
        cover(at_px_[place(x)], at_px_[place(x + 1)], x, x + 1);
      else
        cover(at_px_[place(x)], at_px_[place(x)] + 0.5, x, x);
    }
  }

  /// What nothing moved to is a hole.
  void fill_holes() {
    const int width_px = from_.colour.width_px;
    for (int x = 0; x < width_px; ++x) {
      if (nearness_[place(x)] >= 0) continue;
      int right = x;
      while (right < width_px && nearness_[place(right)] < 0) ++right;
      const int left = x - 1;
      const bool by_left =
          right == width_px || (left >= 0 && nearness_[place(left)] <= nearness_[place(right)]);
      const int beside = by_left ? left : right;
      for (int hole = x; hole < right; ++hole) fill(hole, beside);
      x = right;
    }
  }

 private:
  [[nodiscard]] static std::size_t place(int x) { return static_cast<std::size_t>(x); }

  /// Colours the columns whose middles lie from `begin_px` to before `end_px`, from pixel `first` to `last`.
  void cover(double begin_px, double end_px, int first, int last) {
    const double low_px = std::min(begin_px, end_px), high_px = std::max(begin_px, end_px);
    const int begin = std::max(0, static_cast<int>(std::ceil(low_px - 0.5)));
    const int end = std::min(from_.colour.width_px, static_cast<int>(std::ceil(high_px - 0.5)));
    const double length_px = end_px - begin_px;
    for (int x = begin; x < end; ++x) {
      const auto share = static_cast<float>(length_px == 0 ? 0 : (x + 0.5 - begin_px) / length_px);
      const float nearness =
          (1.0F - share) * 1.0F / from_.planar_m.at(first, y_) + share * 1.0F / from_.planar_m.at(last, y_);
      if (nearness <= nearness_[place(x)]) continue;
      nearness_[place(x)] = nearness;
      out_.holes.at(x, y_) = 0.0F;
      out_.picture.set_rgb(x, y_,
                           (1.0F - share) * from_.colour.rgb(first, y_) + share * from_.colour.rgb(last, y_));
    }
  }

  /// From the background as far away as what is seen beside the hole, or from that itself.
  void fill(int hole, int beside) {
    if (beside < 0 || beside >= from_.colour.width_px) return;  // nothing in the whole row
    if (from_.background) {
      const float beside_m = nearness_[place(beside)] > 0 ? 1.0F / nearness_[place(beside)]
                                                          : std::numeric_limits<float>::infinity();
      const int x = static_cast<int>(std::floor(hole + 0.5 - shift_px(eye_, static_cast<double>(beside_m))));
      if (x >= 0 && x < from_.colour.width_px && (!from_.foreground || from_.foreground->at(x, y_) > 0.5F)) {
        out_.picture.set_rgb(hole, y_, from_.background->rgb(x, y_));
        return;
      }
    }
    out_.picture.set_rgb(hole, y_, out_.picture.rgb(beside, y_));
  }

  const PictureWithDepth& from_;
  const BesideEye& eye_;
  int y_;
  SynthesisedView& out_;
  std::vector<double> at_px_;    ///< where the middle of each pixel goes
  std::vector<float> nearness_;  ///< 1 / m of what is seen in each column; below 0: nothing
};

}  // namespace

double shift_px(const BesideEye& eye, double planar_m) {
  return eye.focal_px * eye.right_m * (1 / eye.zero_parallax_m - 1 / planar_m);
}

SynthesisedView view_from_depth(const PictureWithDepth& from, const BesideEye& eye) {
  SynthesisedView view{Image(from.colour.width_px, from.colour.height_px, 3),
                       Image(from.colour.width_px, from.colour.height_px, 1, 1.0F)};
  for (int y = 0; y < view.picture.height_px; ++y) {
    ViewRow row(from, eye, y, view);
    row.move_pixels();
    row.fill_holes();
  }
  return view;
}

double hole_share(const SynthesisedView& view) {
  return std::accumulate(view.holes.values.begin(), view.holes.values.end(), 0.0) /
         static_cast<double>(view.holes.values.size());
}

Image with_holes_shown(const SynthesisedView& view) {
  Image picture = view.picture;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x)
      if (view.holes.at(x, y) > 0.5F) picture.set_rgb(x, y, {1.0F, 0.0F, 1.0F});
  return picture;
}

Image stretched(const Image& squeezed, bool is_depth) {
  Image out(2 * squeezed.width_px, squeezed.height_px, squeezed.channels);
  for (int y = 0; y < out.height_px; ++y)
    for (int x = 0; x < out.width_px; ++x) {
      const int here = x / 2;
      const int next = std::clamp(here + (x % 2 == 0 ? -1 : 1), 0, squeezed.width_px - 1);
      const float share = is_depth ? 0.0F : 0.25F;  // a column's middle is a quarter of a pixel from here
      for (int channel = 0; channel < out.channels; ++channel)
        out.at(x, y, channel) =
            (1.0F - share) * squeezed.at(here, y, channel) + share * squeezed.at(next, y, channel);
    }
  return out;
}

}  // namespace seamline::renderer
