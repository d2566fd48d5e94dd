#pragma once
#include <optional>

#include "stimuli/definition/views/view.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// A picture of one eye and the depth of its pixels: what a 2D-plus-depth screen gets.
struct PictureWithDepth {
  Image colour;    ///< linear, 3 channels
  Image planar_m;  ///< distance from the camera's plane, 1 channel; infinity: the sky
  /// What is behind the things in front, of the same size; none: nothing is known of it.
  std::optional<Image> background = {};
  /// Where that differs from the picture (1) and where it is the picture itself (0); 1 channel.
  std::optional<Image> foreground = {};
};

/// Where an eye stands beside the picture's own.
struct BesideEye {
  double right_m = 0;          ///< along the camera's right vector
  double zero_parallax_m = 1;  ///< at which things stay where they are
  double focal_px = 1;         ///< columns of the picture over 2 tan(half the field of view)
};

/// A picture as another eye sees it, made of one picture and its depth.
struct SynthesisedView {
  Image picture;  ///< holes filled: by the background where it is known, else by what is farther beside them
  Image holes;    ///< 1 where the first eye saw nothing of it, 1 channel
};

/// By how many columns a thing stands farther right for the other eye: f e (1 / Z - 1 / d).
[[nodiscard]] double shift_px(const BesideEye& eye, double planar_m);

/// Every pixel moved to where the other eye sees it; the nearest of several is seen. Between neighbours that
/// part by no more than one and a half columns there is one surface, and its colour is linear; elsewhere
/// there is a jump, and behind it a hole. The eye at 0 sees the picture itself.
[[nodiscard]] SynthesisedView view_from_depth(const PictureWithDepth& from, const BesideEye& eye);

/// Share of a view's pixels that are holes.
[[nodiscard]] double hole_share(const SynthesisedView& view);

/// A view with its holes in magenta.
[[nodiscard]] Image with_holes_shown(const SynthesisedView& view);

/// A picture that was squeezed to half its width, stretched again: colours are linear between pixels, depths
/// (`is_depth`) those of the pixel itself, because between two surfaces there is none.
[[nodiscard]] Image stretched(const Image& squeezed, bool is_depth);

}  // namespace seamline::renderer
