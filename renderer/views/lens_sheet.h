#pragma once
#include <array>

#include "stimuli/definition/views/view.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// A screen under slanted lenses, each over the sub-pixels of all views.
struct SheetScreen {
  LensSheet sheet = {};
  int views = 2;
  std::array<int, 2> place_px = {0, 0};  ///< of the picture's upper left corner on the screen
};

/// The screen of a view's pictures of this width.
[[nodiscard]] SheetScreen sheet_screen(const View& view, int picture_width_px);

/// Where under its lens the middle of a sub-pixel lies, from 0, the lens' left edge, to 1:
///   u = frac((3 x + c + 1/2 + offset - 3 y tan(slant)) / pitch)
/// for channel c (0 red, 1 green, 2 blue) of the picture's pixel (x, y), with x and y counted on the screen;
/// a pixel is three sub-pixels wide and as high.
[[nodiscard]] double place_under_lens(const SheetScreen& screen, int x, int y, int channel);

/// Which view (0: the left eye's) a sub-pixel belongs to: N - 1 - floor(N u), because what lies on the left
/// under a lens is sent to the right.
[[nodiscard]] int view_of_subpixel(const SheetScreen& screen, int x, int y, int channel);

/// The picture that a screen under lenses shows: each sub-pixel from its own view. `all_eyes`: the views'
/// pictures side by side, from the left eye's to the right eye's, each as wide as the result; 3 channels.
[[nodiscard]] Image interleave(const SheetScreen& screen, const Image& all_eyes);

/// What an eye in the middle of view `eye` sees through ideal lenses: of every sub-pixel that sends its light
/// there its own value, and between them, in each channel, what is linear: along rows that send something,
/// and from row to row in those that do not. A channel that nowhere sends anything there is black.
[[nodiscard]] Image through_lenses(const SheetScreen& screen, const Image& interleaved, int eye);

}  // namespace seamline::renderer
