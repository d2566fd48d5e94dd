// Orders of the picture's error where an edge lies in the wrong place.
#include "laboratory/stability/common/namespaces.h"
#include "laboratory/stability/common/orders.h"
#include "laboratory/stability/common/shapes.h"
#include "renderer/estimators/path/path_truth_pass.h"
#include "stimuli/pictures/difference.h"

namespace seamline::stability {
namespace {

constexpr int width_px = 80, height_px = 45;

/// A emitting sheet before a darker wall whose slanting edge crosses the picture, moved to the right by a
/// number of pixels.
Image sheet_picture(double displacement_px) {
  constexpr double distance_m = 4;
  SmallScene scene{.background = {},
                   .object = {},
                   .light = sun_and_sky({0, 1, 0}, 0, 0, 0),
                   .width_px = width_px,
                   .height_px = height_px};
  TruthScene truth = truth_scene_of(scene);
  const double pixel_m = distance_m * 2 * static_cast<double>(truth.camera.tan_half_horizontal) / width_px;
  const auto x = static_cast<float>((displacement_px - 8) * pixel_m);
  truth.background = {shape_of({{x - 0.31F, -9, -4}, {x + 0.29F, 9, -4}, {-90, 9, -4}, {-90, -9, -4}},
                               {{0, 1, 2}, {0, 2, 3}}, {.albedo = 0, .emission = 0.5F}),
                      box_shape({-90, -90, -9}, {90, 90, -8}, {.albedo = 0, .emission = 0.3F})};
  return render_reference(truth, {.spp = 256, .seed = 1, .threads = 1}).radiance;
}

}  // namespace

OrderSeries misplaced_edge_order(bool below_a_pixel) {
  return {
      .name = below_a_pixel ? "edge-below-a-pixel" : "edge-above-a-pixel",
      .line = below_a_pixel ? "edge misplaced by parts of a pixel" : "edge misplaced by pixels",
      .tried = below_a_pixel ? "a slanting hard edge misplaced by 1/32 to 1/4 of a pixel"
                             : "a slanting hard edge misplaced by 4 to 32 pixels",
      .expected = below_a_pixel ? 1.0 : 0.5,
      .tolerance = 0.1,
      .reason =
          below_a_pixel
              ? "every pixel on the edge changes in proportion, bent by the display curve and in steps of 1 "
                "/ 256"
              : "the number of pixels that change grows in proportion; the edge's own pixel counts in part",
      .panel = 3,
      .measure = [below_a_pixel] {
        std::vector<std::pair<double, double>> points;
        const Image right = sheet_picture(0);
        for (double displacement_px = below_a_pixel ? 1.0 / 32 : 4;
             displacement_px <= (below_a_pixel ? 0.25 : 32); displacement_px *= 2)
          points.emplace_back(displacement_px, display_rmse(sheet_picture(displacement_px), right, 0));
        return points;
      }};
}

}  // namespace seamline::stability
