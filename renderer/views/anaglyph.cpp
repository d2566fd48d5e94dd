#include "renderer/views/anaglyph.h"

namespace seamline::renderer {

AnaglyphMatrices anaglyph_matrices(AnaglyphMatrix matrix) {
  const Eigen::RowVector3f luminance_weights(0.2126F, 0.7152F, 0.0722F);  // of the primaries (Rec. 709)
  AnaglyphMatrices out{Eigen::Matrix3f::Zero(), Eigen::Matrix3f::Zero()};
  switch (matrix) {
    case AnaglyphMatrix::colour:
      out.left(0, 0) = out.right(1, 1) = out.right(2, 2) = 1.0F;
      return out;
    case AnaglyphMatrix::half_colour:
      out.left.row(0) = luminance_weights;
      out.right(1, 1) = out.right(2, 2) = 1.0F;
      return out;
    case AnaglyphMatrix::grey:
      out.left.row(0) = out.right.row(1) = out.right.row(2) = luminance_weights;
      return out;
    case AnaglyphMatrix::dubois:
      out.left << 0.437F, 0.449F, 0.164F, -0.062F, -0.062F, -0.024F, -0.048F, -0.050F, -0.017F;
      out.right << -0.011F, -0.032F, -0.007F, 0.377F, 0.761F, 0.009F, -0.026F, -0.093F, 1.234F;
      return out;
  }
  return out;
}

Image anaglyph(AnaglyphMatrix matrix, const Image& all_eyes) {
  const AnaglyphMatrices how = anaglyph_matrices(matrix);
  const int width_px = all_eyes.width_px / 2;
  Image picture(width_px, all_eyes.height_px, 3);
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const Eigen::Vector3f both =
          how.left * all_eyes.rgb(x, y).matrix() + how.right * all_eyes.rgb(x + width_px, y).matrix();
      picture.set_rgb(x, y, both.array().max(0.0F));
    }
  return picture;
}

}  // namespace seamline::renderer
