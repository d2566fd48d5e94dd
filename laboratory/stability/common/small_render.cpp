#include "laboratory/stability/common/small_render.h"

#include "laboratory/stability/common/namespaces.h"
#include "renderer/depth/capture.h"
#include "renderer/estimators/path/path_depth_pass.h"

namespace seamline::stability {

Composite compose_as_product(const StimulusSums& sums) {
  return compose(sums);
}

SmallPicture render_small(const TruthScene& scene, const SmallRender& how) {
  const ObjectGeometry geometry = object_geometry(scene, 1);
  const PassOptions pass{.spp = how.spp, .seed = how.seed, .threads = how.threads};
  const TruthSums truth = render_truth(scene, geometry, pass);
  const Geometry depth(build_depth_mesh(capture_depth(geometry.truth, how.depth_width_px, 0, how.threads),
                                        {.threads = how.threads}),
                       Rgb::Constant(static_cast<float>(scene.definition.albedo)));
  SmallPicture picture{
      .sums = render_stimulus(scene, geometry, &depth, truth, recipe(how.artifact, how.isolation), pass),
      .composite = {},
      .background = background_image(truth),
      .reference = reference_image(truth)};
  picture.composite = how.compose(picture.sums);
  return picture;
}

int pixels_out_of_range(const Image& image, double most) {
  int count = 0;
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x) {
      const Rgb rgb = image.rgb(x, y);
      count += rgb.allFinite() && (rgb >= 0.0F).all() && (rgb.cast<double>() <= most).all() ? 0 : 1;
    }
  return count;
}

}  // namespace seamline::stability
