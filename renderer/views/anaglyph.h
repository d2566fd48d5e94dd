#pragma once
#include <Eigen/Core>

#include "stimuli/definition/views/view.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// What of linear colour an anaglyph takes from each eye: its colour is left * L + right * R, rows and
/// columns being red, green and blue.
struct AnaglyphMatrices {
  Eigen::Matrix3f left, right;
};

/// Those of Dubois are of his report "Conversion of a stereo pair to anaglyph with the least-squares
/// projection method" (2009), for red and cyan glasses.
[[nodiscard]] AnaglyphMatrices anaglyph_matrices(AnaglyphMatrix matrix);

/// One picture of two eyes' pictures that stand side by side, linear; negative values become 0.
[[nodiscard]] Image anaglyph(AnaglyphMatrix matrix, const Image& all_eyes);

}  // namespace seamline::renderer
