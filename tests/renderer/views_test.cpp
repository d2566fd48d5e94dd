// How pictures are shown: eyes, lens sheets, anaglyphs, depth beside a picture, and views made of it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "raytracer/scene/eyes.h"
#include "renderer/views/anaglyph.h"
#include "renderer/views/depth_image.h"
#include "renderer/views/lens_sheet.h"
#include "renderer/views/synthesised_views.h"
#include "renderer/views/view_picture.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

Camera tilted_camera(int width_px = 320, int height_px = 180) {
  Camera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.tan_half_horizontal = 0.6F;
  camera.axes =
      (Eigen::AngleAxisf(0.4F, Eigen::Vector3f::UnitY()) * Eigen::AngleAxisf(-0.3F, Eigen::Vector3f::UnitX()))
          .toRotationMatrix();
  return camera;
}

View eyes_of(int views, double separation_m, double zero_parallax_m) {
  return {.kind = ViewKind::interleaved,
          .views = views,
          .separation_m = separation_m,
          .zero_parallax_m = zero_parallax_m,
          .sheet = five_views_sheet};
}

/// A picture of noise, the same for the same seed.
Image noise(int width_px, int height_px, std::uint64_t seed) {
  Image picture(width_px, height_px, 3);
  Random random(seed, 0);
  for (float& value : picture.values) value = static_cast<float>(random.uniform());
  return picture;
}

Image side_by_side(const std::vector<Image>& pictures) {
  const int width_px = pictures.front().width_px;
  Image all_eyes(static_cast<int>(pictures.size()) * width_px, pictures.front().height_px, 3);
  for (std::size_t k = 0; k < pictures.size(); ++k)
    for (int y = 0; y < all_eyes.height_px; ++y)
      for (int x = 0; x < width_px; ++x)
        all_eyes.set_rgb(static_cast<int>(k) * width_px + x, y, pictures[k].rgb(x, y));
  return all_eyes;
}

TEST(Views, DisparityIsThatOfThePinholes) {
  const double separation_m = 0.065, zero_m = 2.5;
  const Camera centre = tilted_camera();
  const Camera camera = view_camera(centre, eyes_of(5, separation_m, zero_m));
  ASSERT_EQ(camera.width_px, 5 * 320);
  const double focal_px = 0.5 * 320 / static_cast<double>(centre.tan_half_horizontal);
  for (const double depth_m : {0.8, 2.5, 4.0, 60.0})
    for (const double right_m : {-0.3, 0.0, 0.2}) {
      const double up_m = 0.1;
      const Eigen::Vector3d point = centre.axes.cast<double>() * Eigen::Vector3d(right_m, up_m, -depth_m);
      for (int eye = 0; eye < 5; ++eye) {
        const double moved_m = (eye - 2) * separation_m;
        const double column = 160 + focal_px * (right_m / depth_m + moved_m * (1 / zero_m - 1 / depth_m));
        const double row = 90 - focal_px * up_m / depth_m;
        if (column < 0 || column >= 320) continue;
        const int x = static_cast<int>(column), y = static_cast<int>(row);
        const Eigen::Vector3d seen = camera
                                         .direction_within(eye * 320 + x, y, static_cast<float>(column - x),
                                                           static_cast<float>(row - y))
                                         .cast<double>();
        const Eigen::Vector3d there = point - camera.place_m(eye * 320 + x, y).cast<double>();
        EXPECT_LT(seen.cross(there.normalized()).norm(), 2e-6) << depth_m << " m, eye " << eye;
      }
    }
}

TEST(Views, TheMiddleEyeIsTheCameraItselfToTheLastBit) {
  const Camera centre = tilted_camera();
  const Camera camera = view_camera(centre, eyes_of(5, 0.065, 2.5));
  const Camera together = view_camera(centre, eyes_of(2, 0.0, 2.5));
  for (int y = 0; y < centre.height_px; y += 7)
    for (int x = 0; x < centre.width_px; ++x) {
      const Sampler sampler(3, x, y, 1);
      const Ray alone = camera_ray(centre, x, y, sampler);
      EXPECT_EQ(camera_ray(camera, 2 * 320 + x, y, sampler).direction, alone.direction);
      EXPECT_TRUE(camera.place_m(2 * 320 + x, y).isZero());
      for (int eye = 0; eye < 2; ++eye) {
        EXPECT_EQ(camera_ray(together, eye * 320 + x, y, sampler).direction, alone.direction);
        EXPECT_TRUE(together.place_m(eye * 320 + x, y).isZero());
      }
    }
  const Camera back = centre_camera(camera);
  EXPECT_EQ(back.width_px, centre.width_px);
  EXPECT_EQ(back.eyes, nullptr);
  EXPECT_EQ(view_camera(centre, {}).eyes, nullptr);
}

TEST(Views, SqueezedPixelsLookThroughTheMiddleOfTwo) {
  const Camera centre = tilted_camera();
  const Camera camera =
      view_camera(centre, {.kind = ViewKind::side_by_side, .separation_m = 0.0, .zero_parallax_m = 2});
  ASSERT_EQ(camera.width_px, centre.width_px);
  for (const int y : {0, 90, 179})
    for (const int x : {0, 77, 159}) {
      const Eigen::Vector3f wide =
          centre.direction(static_cast<float>(2 * x + 1), static_cast<float>(y) + 0.5F);
      EXPECT_LT((camera.centre_direction(x, y) - wide).norm(), 1e-6F);
      EXPECT_LT((camera.centre_direction(160 + x, y) - wide).norm(), 1e-6F);
    }
  EXPECT_EQ(centre_camera(camera).width_px, centre.width_px);
}

TEST(LensSheet, OfFiveViewsMovesOneSubPixelARow) {
  const SheetScreen screen{.sheet = five_views_sheet, .views = 5};
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 40; ++x)
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_EQ(view_of_subpixel(screen, x, y, channel), 4 - ((3 * x + channel - y) % 5 + 5) % 5);
}

TEST(LensSheet, SendsWhatLiesOnTheLeftUnderALensToTheRight) {
  const SheetScreen screen{.sheet = {.pitch_subpixels = 9, .slant_deg = -12.3, .offset_subpixels = 1.7},
                           .views = 4};
  for (int y = 0; y < 20; ++y)
    for (int s = 1; s < 200; ++s) {
      const int here = view_of_subpixel(screen, s / 3, y, s % 3);
      const int before = view_of_subpixel(screen, (s - 1) / 3, y, (s - 1) % 3);
      const bool same_lens =
          place_under_lens(screen, s / 3, y, s % 3) > place_under_lens(screen, (s - 1) / 3, y, (s - 1) % 3);
      if (same_lens) {
        EXPECT_LE(here, before);
      }
    }
}

TEST(LensSheet, GivesEveryViewItsShareOfTheSubPixels) {
  for (const auto& [pitch, slant, views] : {std::tuple{5.0, five_views_sheet.slant_deg, 5},
                                            std::tuple{4.5, 9.46, 9}, std::tuple{7.13, -14.0, 8}}) {
    const SheetScreen screen{.sheet = {.pitch_subpixels = pitch, .slant_deg = slant}, .views = views};
    std::vector<double> counts(static_cast<std::size_t>(views));
    const int width_px = 150, height_px = 150;
    for (int y = 0; y < height_px; ++y)
      for (int x = 0; x < width_px; ++x)
        for (int channel = 0; channel < 3; ++channel)
          ++counts[static_cast<std::size_t>(view_of_subpixel(screen, x, y, channel))];
    for (const double count : counts)
      EXPECT_NEAR(count / (3.0 * width_px * height_px), 1.0 / views, 0.02 / views);
  }
}

TEST(LensSheet, LensesGiveEachViewBack) {
  for (const SheetScreen& screen :
       {SheetScreen{.sheet = five_views_sheet, .views = 5},
        SheetScreen{.sheet = five_views_sheet, .views = 5, .place_px = {17, 4}},
        SheetScreen{.sheet = {.pitch_subpixels = 4.5, .slant_deg = 9.46, .offset_subpixels = 0.3},
        .views = 9},
        SheetScreen{.sheet = {.pitch_subpixels = 8, .slant_deg = -20}, .views = 2}}) {
    std::vector<Image> ramps, noises;
    for (int k = 0; k < screen.views; ++k) {
      Image ramp(120, 40, 3);
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 120; ++x)
          ramp.set_rgb(x, y, Rgb(0.01F, 0.02F, 0.03F) * static_cast<float>(x) + 0.1F * static_cast<float>(k));
      ramps.push_back(ramp);
      noises.push_back(noise(120, 40, static_cast<std::uint64_t>(k) + 1));
    }
    const Image of_ramps = interleave(screen, side_by_side(ramps));
    const Image of_noises = interleave(screen, side_by_side(noises));
    for (int k = 0; k < screen.views; ++k) {
      const Image ramp = through_lenses(screen, of_ramps, k), any = through_lenses(screen, of_noises, k);
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 120; ++x)
          for (int channel = 0; channel < 3; ++channel) {
            // What is linear comes back everywhere between the outermost columns that the view has.
            if (x >= 30 && x < 90) {
              EXPECT_NEAR(ramp.at(x, y, channel), ramps[static_cast<std::size_t>(k)].at(x, y, channel),
                          1e-5F);
            }
            if (view_of_subpixel(screen, x, y, channel) == k) {
              EXPECT_EQ(any.at(x, y, channel), noises[static_cast<std::size_t>(k)].at(x, y, channel));
            }
          }
    }
  }
}

TEST(LensSheet, ViewsThatAreAllOnePictureAreThatPictureByteForByte) {
  const Image picture = noise(61, 31, 1);
  const SheetScreen screen{.sheet = five_views_sheet, .views = 5};
  EXPECT_EQ(interleave(screen, side_by_side({picture, picture, picture, picture, picture})).values,
            picture.values);
}

TEST(LensSheet, APictureThatIsElsewhereOnTheScreenContinuesItsPattern) {
  const SheetScreen screen{.sheet = {.pitch_subpixels = 4.7, .slant_deg = 11}, .views = 6};
  SheetScreen moved = screen;
  moved.place_px = {31, 12};
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x)
      EXPECT_EQ(view_of_subpixel(moved, x, y, 1), view_of_subpixel(screen, x + 31, y + 12, 1));
}

TEST(Anaglyph, GreyOfTwoEqualPicturesIsTheirGrey) {
  const Image picture = noise(20, 10, 4);
  const Image both = side_by_side({picture, picture});
  const Image grey = anaglyph(AnaglyphMatrix::grey, both), colour = anaglyph(AnaglyphMatrix::colour, both);
  EXPECT_EQ(colour.values, picture.values);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) {
      const Rgb c = picture.rgb(x, y);
      const float luminance = 0.2126F * c[0] + 0.7152F * c[1] + 0.0722F * c[2];
      for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(grey.at(x, y, channel), luminance, 1e-6F);
    }
  // White stays white to the digits that Dubois gives.
  const Image white = anaglyph(AnaglyphMatrix::dubois, Image(2, 1, 3, 1.0F));
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(white.at(0, 0, channel), 1.0F, 0.02F);
}

TEST(Anaglyph, EachEyeHasItsOwnColours) {
  Image all_eyes(2, 1, 3);
  all_eyes.set_rgb(0, 0, {0.5F, 0.25F, 0.125F});
  EXPECT_TRUE((anaglyph(AnaglyphMatrix::colour, all_eyes).rgb(0, 0) == Rgb(0.5F, 0, 0)).all());
  all_eyes = Image(2, 1, 3);
  all_eyes.set_rgb(1, 0, {0.5F, 0.25F, 0.125F});
  EXPECT_TRUE((anaglyph(AnaglyphMatrix::colour, all_eyes).rgb(0, 0) == Rgb(0, 0.25F, 0.125F)).all());
}

TEST(ShownToEachEye, RepeatsThePictureThatShowsAllEyes) {
  const Image all_eyes = noise(24, 10, 7);
  const View two = {.kind = ViewKind::anaglyph};
  for (const View& view : {two, eyes_of(3, 0.06, 2)}) {
    const Image shown = compose_view(view, all_eyes), each = shown_to_each_eye(view, all_eyes);
    ASSERT_EQ(each.width_px, all_eyes.width_px);
    for (int y = 0; y < each.height_px; ++y)
      for (int x = 0; x < each.width_px; ++x)
        EXPECT_TRUE((each.rgb(x, y) == shown.rgb(x % shown.width_px, y)).all()) << x << " " << y;
  }
}

TEST(ShownToEachEye, IsThePictureItselfWhereEyesStandApart) {
  const Image all_eyes = noise(24, 10, 7);
  for (const ViewKind kind : {ViewKind::mono, ViewKind::side_by_side, ViewKind::depth_image})
    EXPECT_EQ(shown_to_each_eye({.kind = kind}, all_eyes).values, all_eyes.values);
}

TEST(DepthImage, KeepsDepthToHalfAStep) {
  Image depth_m(400, 1, 1);
  for (int x = 0; x < 400; ++x) depth_m.at(x, 0) = 0.01F + 0.02F * static_cast<float>(x);
  depth_m.at(399, 0) = std::numeric_limits<float>::infinity();
  const double most_m = 6;
  const ByteImage codes = depth_codes(depth_m, most_m);
  const Image back = depth_of_codes(codes, most_m);
  for (int x = 0; x < 400; ++x) {
    if (depth_m.at(x, 0) > 6) {
      EXPECT_EQ(codes.values[static_cast<std::size_t>(x)], 255);
    } else {
      EXPECT_NEAR(back.at(x, 0), depth_m.at(x, 0), most_m / 510 + 1e-6);
    }
  }
  EXPECT_EQ(depth_codes(back, most_m).values, codes.values);
}

TEST(DepthImage, IsPlanar) {
  const Camera camera = tilted_camera(40, 30);
  // A plane across the view, 3 m in front.
  const Image depth_m = planar_depth_m(camera, [&](const Ray& ray) -> std::optional<float> {
    return 3.0F / ray.direction.dot(-camera.axes.col(2));
  });
  for (const float one_m : depth_m.values) EXPECT_NEAR(one_m, 3.0F, 1e-5F);
}

TEST(DepthImage, HalvesComeApartAgain) {
  ByteImage left{2, 2, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}, right{2, 2, 1, {20, 21, 22, 23}};
  const ByteImage both = beside(left, right);
  EXPECT_EQ(half_of(both, false).values, left.values);
  EXPECT_EQ(half_of(both, true).values,
            (std::vector<std::uint8_t>{20, 20, 20, 21, 21, 21, 22, 22, 22, 23, 23, 23}));
}

PictureWithDepth plane_at(float planar_m) {
  return {.colour = noise(64, 8, 9), .planar_m = Image(64, 8, 1, planar_m)};
}

TEST(SynthesisedViews, TheEyeOfThePictureSeesThePicture) {
  PictureWithDepth from = plane_at(2);
  Random random(1, 0);
  for (float& depth_m : from.planar_m.values) depth_m = 1 + 5 * static_cast<float>(random.uniform());
  const SynthesisedView view = view_from_depth(from, {.right_m = 0, .zero_parallax_m = 3, .focal_px = 60});
  EXPECT_EQ(view.picture.values, from.colour.values);
  EXPECT_EQ(hole_share(view), 0);
}

TEST(SynthesisedViews, APlaneIsShiftedExactly) {
  // f e (1 / Z - 1 / d) = 80 * 0.1 * (1 / 4 - 1 / 2) = -2 columns.
  const PictureWithDepth from = plane_at(2);
  const BesideEye eye{.right_m = 0.1, .zero_parallax_m = 4, .focal_px = 80};
  EXPECT_NEAR(shift_px(eye, 2), -2, 1e-12);
  const SynthesisedView view = view_from_depth(from, eye);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 64; ++x) {
      EXPECT_EQ(view.holes.at(x, y), x < 62 ? 0.0F : 1.0F);
      if (x < 62) {
        EXPECT_TRUE((view.picture.rgb(x, y) - from.colour.rgb(x + 2, y)).abs().maxCoeff() < 1e-5F);
      }
    }
  // In the window nothing moves, whatever the eye.
  const PictureWithDepth there = plane_at(4);
  EXPECT_EQ(view_from_depth(there, {.right_m = -3.3, .zero_parallax_m = 4, .focal_px = 80}).picture.values,
            there.colour.values);
}

TEST(SynthesisedViews, AHoleIsAsWideAsTwoSurfacesPartAndShowsTheBackground) {
  PictureWithDepth from = plane_at(4);
  Image background = noise(64, 8, 20), mask(64, 8, 1);
  for (int y = 0; y < 8; ++y)
    for (int x = 24; x < 40; ++x) from.planar_m.at(x, y) = 1, mask.at(x, y) = 1.0F;
  // The far plane stays; the near one goes 80 * 0.1 * (1 / 4 - 1) = 6 columns to the left for the right eye.
  const BesideEye eye{.right_m = 0.1, .zero_parallax_m = 4, .focal_px = 80};
  const SynthesisedView bare = view_from_depth(from, eye);
  from.background = background;
  from.foreground = mask;
  const SynthesisedView filled = view_from_depth(from, eye);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 64; ++x) {
      const bool near = x >= 18 && x < 34, hole = x >= 34 && x < 40;
      EXPECT_EQ(bare.holes.at(x, y), hole ? 1.0F : 0.0F) << x;
      const Rgb wanted = near ? from.colour.rgb(x + 6, y) : from.colour.rgb(x, y);
      if (!hole) {
        EXPECT_LT((bare.picture.rgb(x, y) - wanted).abs().maxCoeff(), 1e-5F) << x;
      }
      if (hole) {
        EXPECT_TRUE((bare.picture.rgb(x, y) == from.colour.rgb(40, y)).all()) << "what is farther beside it";
        EXPECT_TRUE((filled.picture.rgb(x, y) == background.rgb(x, y)).all());
      }
    }
}

TEST(ViewPicture, ClicksMeanWhatMostEyesSee) {
  const ByteImage all_eyes{6, 1, 1, {1, 0, /**/ 1, 2, /**/ 2, 2}};
  const View view = eyes_of(3, 0.1, 2);
  EXPECT_EQ(view_click_map(view, all_eyes).values, (std::vector<std::uint8_t>{1, 2}));
  const View two{.kind = ViewKind::side_by_side, .zero_parallax_m = 2};
  EXPECT_EQ(view_click_map(two, all_eyes).values, all_eyes.values);
  const View depth{.kind = ViewKind::depth_image, .max_depth_m = 2};
  EXPECT_EQ(view_click_map(depth, all_eyes).values,
            (std::vector<std::uint8_t>{1, 0, 1, 2, 2, 2, 0, 0, 0, 0, 0, 0}));
}

TEST(ViewPicture, EveryKindFillsTheStudysPicture) {
  for (const View& view : {View{}, View{.kind = ViewKind::side_by_side, .zero_parallax_m = 2},
                           View{.kind = ViewKind::anaglyph, .zero_parallax_m = 2}, eyes_of(5, 0.065, 2),
                           View{.kind = ViewKind::depth_image, .max_depth_m = 5}}) {
    const Camera camera = view_camera(tilted_camera(), view);
    const Image all_eyes = noise(camera.width_px, camera.height_px, 1);
    const ByteImage shown =
        shown_bytes(view, compose_view(view, all_eyes), 0, Image(camera.width_px, camera.height_px, 1, 2.0F));
    EXPECT_EQ(shown.width_px, 320) << word(view.kind);
    EXPECT_EQ(shown.height_px, 180);
    EXPECT_EQ(shown.channels, 3);
  }
}

}  // namespace
}  // namespace seamline::renderer
