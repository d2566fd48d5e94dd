// `make_composite` on files: the right picture, or one sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>

#include "composites/composite_request.h"
#include "renderer/depth/depth_map.h"
#include "sensors/frame/depth_frame.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "tests/complaint.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A room 3 m around the camera, closed or open above, photographed as a panorama and as a view.
class MakeComposite : public testing::Test {
 protected:
  MakeComposite() : folder_(fs::path(SEAMLINE_TEST_OUTPUT) / "make-composite") {
    fs::create_directories(folder_);
    write_depth("closed.exr", 3.0F, 3.0F);
    write_depth("open.exr", 3.0F, sensors::hole);
    write_exr(folder_ / "panorama.exr", Image(64, 32, 3, 0.5F));
    write_exr(folder_ / "view.exr", Image(40, 30, 3, 0.5F));
  }
  void write_depth(const char* name, float below, float above) const {
    Image depth(64, 32, 1, below);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 64; ++x) depth.at(x, y) = above;
    write_exr(folder_ / name, depth);
  }
  [[nodiscard]] std::string in(const std::string& name) const { return (folder_ / name).string(); }

  /// A panorama of a closed room, that is its own light, and a statue.
  [[nodiscard]] CompositeRequest panorama() const {
    CompositeRequest request;
    request.photograph = in("panorama.exr");
    request.depth.file = in("closed.exr");
    request.depth.tolerance = 1e-2;
    PlacedModel statue;
    statue.file = "builtin:statue";
    statue.path = resolve_named_file("builtin:statue", "--object");
    statue.position_m = {0, -1, -2};
    statue.height_m = 1;
    statue.stands = true;
    request.objects = {statue};
    request.spp = 2;
    request.bounces = 1;
    request.threads = 2;
    request.light.given.environment_radiance = {0, 0, 0};
    request.out = in("out.exr");
    return request;
  }
  /// The same as a view under a given sky.
  [[nodiscard]] CompositeRequest view() const {
    CompositeRequest request = panorama();
    request.photograph = in("view.exr");
    request.depth.file = in("open.exr");
    request.light.given.environment_radiance = {1, 1, 1};
    return request;
  }
  static std::string said(const CompositeRequest& request) {
    return complaint_of([&] { make_composite(request); });
  }

  fs::path folder_;
};

TEST_F(MakeComposite, APanoramaOfAClosedRoomIsItsOwnLight) {
  for (const auto estimator : {Estimator::fast, Estimator::path}) {
    CompositeRequest request = panorama();
    request.estimator = estimator;
    ASSERT_EQ(said(request), "no complaint");
    const Image made = read_image(folder_ / "out.exr");
    ASSERT_EQ(made.width_px, 64);
    ASSERT_EQ(made.height_px, 32);
    int changed = 0, black = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x) {
        changed += std::abs(made.at(x, y) - 0.5F) > 1e-3F ? 1 : 0;
        black += made.at(x, y) < 0.02F ? 1 : 0;
      }
    EXPECT_GT(changed, 20);
    EXPECT_EQ(black, 0);
  }
}

TEST_F(MakeComposite, APanoramaIsNeverDrawnAsAPerspectiveViewUnlessItIsSaidToBeOne) {
  CompositeRequest request = panorama();
  request.look_at_m = Eigen::Vector3d(0, 0, -1);
  EXPECT_THAT(said(request), AllOf(HasSubstr("look_at: wanted view WxH beside it")));
  request.view_px = std::pair(48, 27);
  EXPECT_EQ(said(request), "no complaint");
  EXPECT_EQ(read_image(folder_ / "out.exr").width_px, 48);
  CompositeRequest square = view();
  square.projection = Projection::panorama;
  EXPECT_THAT(said(square), HasSubstr("twice as wide as high, found 40 x 30"));
}

TEST_F(MakeComposite, EqualRequestsGiveEqualBytesForAnyNumberOfThreads) {
  std::map<std::string, std::string> first;
  for (const int threads : {1, 2}) {
    for (const char* out : {"same.exr", "same.png"}) {
      CompositeRequest request = panorama();
      request.threads = threads;
      request.out = in(out);
      request.layers = in("same-layers.exr");
      ASSERT_EQ(said(request), "no complaint");
      for (const std::string& file : {request.out, request.layers}) {
        const std::string bytes = read_file(file);
        const auto [known, is_new] = first.try_emplace(file, bytes);
        EXPECT_EQ(known->second, bytes) << file;
      }
    }
  }
}

TEST_F(MakeComposite, LightThatCannotComeInOrIsNotThereIsRefused) {
  CompositeRequest request = panorama();
  request.light.given.environment_radiance = {1, 1, 1};
  EXPECT_THAT(said(request), AllOf(HasSubstr("closed all round"), HasSubstr("inside the room (lamp;")));
  request = view();
  request.light.given.environment_radiance = {0, 0, 0};
  EXPECT_THAT(said(request), AllOf(HasSubstr("to_sun"), HasSubstr("light_panorama")));
  request.light.from_photograph = true;
  EXPECT_THAT(said(request), HasSubstr("light_from_photograph: wanted a panorama"));
  request.light.from_photograph = false;
  Image elsewhere(64, 32, 3, 0.5F);
  for (std::size_t i = 0; i < elsewhere.values.size(); ++i) elsewhere.values[i] = i % 7 < 3 ? 0.1F : 3.0F;
  write_exr(folder_ / "elsewhere.exr", elsewhere);
  request.light.panorama = in("elsewhere.exr");
  EXPECT_THAT(said(request), HasSubstr("likeness"));
}

TEST_F(MakeComposite, AnObjectThatChangesNothingIsRefusedAndNoPictureIsWritten) {
  fs::remove(folder_ / "nothing.exr");
  CompositeRequest request = view();
  request.out = in("nothing.exr");
  request.objects[0].position_m = {0, -2.5, -6};  // behind the wall
  request.light.given.environment_radiance = {0, 0, 0};
  request.light.given.suns = {SunDefinition{Eigen::Vector3d(0, 1, 0), {1, 1, 1}, 0}};
  EXPECT_THAT(said(request), HasSubstr("hidden"));
  EXPECT_FALSE(fs::exists(folder_ / "nothing.exr"));
}

TEST_F(MakeComposite, ARenderingThatWouldChangeNothingIsRefusedBeforeItBegins) {
  CompositeRequest request = view();
  request.spp = 65536;  // nobody waits for these
  request.objects[0].position_m = {0, -1, 30};
  request.light.given.environment_radiance = {0, 0, 0};
  request.light.given.suns = {SunDefinition{Eigen::Vector3d(0, 1, 0), {1, 1, 1}, 0}};
  EXPECT_THAT(said(request), AllOf(HasSubstr("outside of the picture"), HasSubstr("look_at")));
  request.objects[0].position_m = {0, -2.5, -6};
  EXPECT_THAT(said(request), HasSubstr("hidden"));
  request.objects[0].position_m = {0, -1, 30};
  request.shadows = false;
  EXPECT_THAT(said(request), HasSubstr("outside of the picture"));
}

TEST_F(MakeComposite, AnObjectWithoutAPlaceStandsInTheMiddleOfTheView) {
  CompositeRequest request = view();
  request.objects[0].has_place = false;
  request.objects[0].height_m = 0.3;
  std::string lines;
  make_composite(request, {.line = [&](const std::string& line) { lines += line; }, .note = {}});
  EXPECT_THAT(lines, HasSubstr("has no position: it is put at "));
  const Image made = read_image(folder_ / "out.exr");
  int changed = 0;
  for (int y = 8; y < 22; ++y)
    for (int x = 14; x < 26; ++x) changed += std::abs(made.at(x, y) - 0.5F) > 1e-3F ? 1 : 0;
  EXPECT_GT(changed, 20);
}

TEST_F(MakeComposite, ACameraThatIsRolledTurnsThePictureRoundItsMiddle) {
  CompositeRequest request = panorama();
  request.view_px = std::pair(40, 40);
  request.objects[0].position_m = {0.6, 0, -2};
  request.shadows = false;
  request.spp = 16;
  request.light.given.environment_radiance = {0, 0, 0};
  const auto middle_of_change = [&](double roll_deg) {
    request.roll_deg = roll_deg;
    EXPECT_EQ(said(request), "no complaint");
    const Image made = read_image(folder_ / "out.exr");
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double count = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x)
        if (std::abs(made.at(x, y) - 0.5F) > 1e-3F) sum += Eigen::Vector2d(x - 19.5, y - 19.5), count += 1;
    return Eigen::Vector2d(sum / count);
  };
  const Eigen::Vector2d upright = middle_of_change(0), rolled = middle_of_change(90);
  // The camera is turned clockwise, what it shows the other way: from the right to the top.
  EXPECT_NEAR(rolled.x(), upright.y(), 1);
  EXPECT_NEAR(rolled.y(), -upright.x(), 1);
}

TEST_F(MakeComposite, DepthThatIsNoneOrOfAnotherShapeIsRefused) {
  CompositeRequest request = view();
  write_exr(folder_ / "holes.exr", Image(64, 32, 1, sensors::hole));
  request.depth.file = in("holes.exr");
  EXPECT_THAT(said(request), HasSubstr("nothing but holes"));
  write_exr(folder_ / "square.exr", Image(64, 64, 1, 2.0F));
  request.depth.file = in("square.exr");
  EXPECT_THAT(said(request), AllOf(HasSubstr("64 x 64"), HasSubstr("40 x 30")));
  request.depth.file = in("open.exr");
  request.depth.convention = sensors::DepthConvention::planar;
  EXPECT_THAT(said(request), HasSubstr("depth_kind: wanted radial"));
}

TEST_F(MakeComposite, PlanarMillimetresOfTheViewAreAsGoodAsMetres) {
  Image metres(40, 30, 1, 2.5F);
  write_exr(folder_ / "planar.exr", metres);
  std::string pgm = "P5\n40 30\n65535\n";
  for (int i = 0; i < 40 * 30; ++i) pgm += {static_cast<char>(2500 >> 8), static_cast<char>(2500 & 255)};
  std::ofstream(folder_ / "planar.pgm", std::ios::binary) << pgm;
  CompositeRequest request = view();
  request.depth.file = in("planar.exr");
  ASSERT_EQ(said(request), "no complaint");
  const Image first = read_image(folder_ / "out.exr");
  request.depth.file = in("planar.pgm");
  EXPECT_THAT(said(request), HasSubstr("metres_per_step"));
  request.depth.metres_per_step = 0.001;
  ASSERT_EQ(said(request), "no complaint");
  EXPECT_EQ(read_image(folder_ / "out.exr").values, first.values);
}

TEST_F(MakeComposite, DepthInThePhotographsOwnPixelsHasNoHolesButItsOwn) {
  // A floor 1 m below the camera and a wall: rays through pixels' middles meet the mesh at its vertices.
  Image depth(40, 30, 1);
  const double focal_px = 20 / std::tan(std::numbers::pi / 6);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      const double down = (y + 0.5 - 15) / focal_px;
      depth.at(x, y) = static_cast<float>(down > 0 ? std::min(1 / down, 5.5) : 5.5);
    }
  CompositeRequest request = view();
  request.objects[0].position_m = {0, -1, -3};
  request.depth.file = in("own_pixels.exr");
  request.local_scene = in("own_pixels.png");
  request.report = in("own_pixels.html");
  const auto black_pixels = [&] {
    write_exr(folder_ / "own_pixels.exr", depth);
    EXPECT_EQ(said(request), "no complaint");
    const ByteImage shown = read_bytes_image(folder_ / "own_pixels.png");
    int black = 0;
    for (std::size_t i = 0; i < shown.values.size(); i += 3) black += shown.values[i] == 0 ? 1 : 0;
    return black;
  };
  for (const MeshDensity density : {MeshDensity::full, MeshDensity::adaptive}) {
    request.depth.density = density;
    EXPECT_EQ(black_pixels(), 0);
  }
  EXPECT_THAT(read_file(folder_ / "own_pixels.html"), HasSubstr("no depth, 0.0 % of it"));
  for (int y = 4; y < 10; ++y)
    for (int x = 5; x < 15; ++x) depth.at(x, y) = 0;
  EXPECT_EQ(black_pixels(), 60);
  EXPECT_THAT(read_file(folder_ / "own_pixels.html"), HasSubstr("no depth, 5.0 % of it"));
}

TEST_F(MakeComposite, PixelsThatAreNoNumbersAreNamed) {
  Image photograph(40, 30, 3, 0.5F);
  photograph.at(7, 3, 1) = std::numeric_limits<float>::quiet_NaN();
  write_exr(folder_ / "nan.exr", photograph);
  CompositeRequest request = view();
  request.photograph = in("nan.exr");
  EXPECT_THAT(said(request), AllOf(HasSubstr("nan.exr"), HasSubstr("(7, 3)")));
}

TEST_F(MakeComposite, AMaskOfAnotherShapeOrBeyondOneIsRefused) {
  CompositeRequest request = view();
  write_exr(folder_ / "mask.exr", Image(17, 30, 1, 0.0F));
  request.occlusion_mask = in("mask.exr");
  EXPECT_THAT(said(request), AllOf(HasSubstr("mask.exr"), HasSubstr("17 x 30")));
  write_exr(folder_ / "mask.exr", Image(40, 30, 1, 2.0F));
  EXPECT_THAT(said(request), HasSubstr("from 0 to 1, found 2"));
  write_exr(folder_ / "mask.exr", Image(40, 30, 1, 0.0F));
  EXPECT_EQ(said(request), "no complaint");
  request.shadow_matte = in("mask.exr");
  EXPECT_THAT(said(request), HasSubstr("shadow_matte: wanted a sun"));
}

TEST_F(MakeComposite, AMaskAndAMatteAreForBothEstimatorsAndSaidInTheReport) {
  CompositeRequest request = view();
  request.light.given.suns = {SunDefinition{Eigen::Vector3d(0.2, 1, 0.3), {2, 2, 2}, 0}};
  Image left(40, 30, 1, 0.0F);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 20; ++x) left.at(x, y) = 1.0F;
  write_exr(folder_ / "left.exr", left);
  request.occlusion_mask = request.shadow_matte = in("left.exr");
  request.report = in("masked.html");
  request.estimator = Estimator::path;
  ASSERT_EQ(said(request), "no complaint");
  EXPECT_THAT(read_file(folder_ / "masked.html"), HasSubstr("path, 2 samples"));
  request.estimator.reset();
  std::string bytes;
  for (const int threads : {1, 2}) {
    request.threads = threads;
    ASSERT_EQ(said(request), "no complaint");
    if (bytes.empty()) bytes = read_file(folder_ / "out.exr");
    EXPECT_EQ(read_file(folder_ / "out.exr"), bytes);
  }
  EXPECT_THAT(read_file(folder_ / "masked.html"),
              AllOf(HasSubstr("who is in front: the mask"), HasSubstr("suns reach: the matte"),
                    HasSubstr("fast, 2 samples")));
  const Image made = read_image(folder_ / "out.exr");
  int left_half = 0, right_half = 0;  // pixels of the statue in the sun: no real surface gets so bright
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) (x < 20 ? left_half : right_half) += made.at(x, y) > 0.56F ? 1 : 0;
  EXPECT_EQ(left_half, 0);
  EXPECT_GT(right_half, 3);
  request.occlusion_mask.clear();
  request.occlusion = Occlusion::nobody;
  request.estimator = Estimator::fast;
  EXPECT_THAT(said(request), HasSubstr("estimator: wanted path beside occlusion none"));
}

TEST_F(MakeComposite, ASmallerWidthIsComparedWithAllDepthInTheReport) {
  CompositeRequest request = panorama();
  request.depth_width_px = 16;
  request.report = in("report.html");
  request.layers = in("layers.exr");
  ASSERT_EQ(said(request), "no complaint");
  EXPECT_THAT(
      read_file(folder_ / "report.html"),
      AllOf(HasSubstr("FLIP between the two"), HasSubstr("a panorama of 16 x 8"), HasSubstr("triangles")));
  request.seamless = true;
  request.depth_width_px.reset();
  request.layers.clear();
  ASSERT_EQ(said(request), "no complaint");
  EXPECT_THAT(read_file(folder_ / "report.html"), HasSubstr("PT: not noticed"));
}

TEST_F(MakeComposite, SaysHowManySamplesAPixelHasWhereThatIsNotWhatWasAsked) {
  const auto notes = [&](Estimator estimator, int spp) {
    CompositeRequest request = panorama();
    request.estimator = estimator;
    request.spp = spp;
    std::string said;
    make_composite(request, {.line = {}, .note = [&](const std::string& note) { said += note + "\n"; }});
    return said;
  };
  EXPECT_THAT(notes(Estimator::fast, 1), HasSubstr("in pairs: 2 a pixel, where spp 1 was asked for"));
  EXPECT_THAT(notes(Estimator::fast, 3), HasSubstr("in pairs: 2 a pixel, where spp 3 was asked for"));
  EXPECT_THAT(notes(Estimator::fast, 2), Not(HasSubstr("in pairs")));
  EXPECT_THAT(notes(Estimator::path, 1), Not(HasSubstr("in pairs")));
}

TEST_F(MakeComposite, SaysWhatAPhotographHasLost) {
  Image clipped(64, 32, 3, 0.25F);
  for (int x = 0; x < 64; ++x) clipped.set_rgb(x, 3, Rgb::Ones());
  write_exr(folder_ / "clipped.exr", clipped);
  const auto said_of = [](const fs::path& file) {
    return codes_warning(read_photograph(file, std::nullopt), "it");
  };
  EXPECT_THAT(said_of(folder_ / "clipped.exr"), HasSubstr("3.1 % of its pixels have the same largest value"));
  EXPECT_EQ(said_of(folder_ / "panorama.exr"), "");
  write_png(folder_ / "codes.png", display_image(clipped));
  EXPECT_THAT(said_of(folder_ / "codes.png"), AllOf(HasSubstr("sRGB"), HasSubstr("3.1 %")));
}

TEST(Upright, TurnsAsTheOrientationSays) {
  Image image(3, 2, 1);
  for (int i = 0; i < 6; ++i) image.values[static_cast<std::size_t>(i)] = static_cast<float>(i);
  EXPECT_EQ(upright(image, 1).values, image.values);
  EXPECT_EQ(upright(image, 99).values, image.values);
  // Held with its right side down: the file's left column is the upper row, from below to above.
  const Image turned = upright(image, 6);
  EXPECT_EQ(turned.width_px, 2);
  EXPECT_EQ(turned.values, (std::vector<float>{3, 0, 4, 1, 5, 2}));
  EXPECT_EQ(upright(turned, 8).values, image.values);
  for (const int itself : {2, 3, 4, 5, 7})
    EXPECT_EQ(upright(upright(image, itself), itself).values, image.values);
}

}  // namespace
}  // namespace seamline::renderer
