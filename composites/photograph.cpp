#include "composites/photograph.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "support/arithmetic/bilinear.h"
#include "support/files/picture_file.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

bool is_colour(const Rgb& colour) {
  return (colour.abs() <= static_cast<float>(limits::strongest_light)).all();  // false for NaN
}

void require_colours(const Image& picture, const std::filesystem::path& path) {
  std::size_t wrong = 0;
  std::string first;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const Rgb colour = picture.rgb(x, y);
      if (is_colour(colour)) continue;
      if (wrong++ == 0)
        first = fmt::format("{:g} {:g} {:g} in ({}, {})", colour[0], colour[1], colour[2], x, y);
    }
  if (wrong > 0)
    throw input_error(
        {.file = path.string(),
         .wanted = fmt::format("colours that are numbers, at most {:g}", limits::strongest_light),
         .found = fmt::format("{} of another kind, the first {}", counted(wrong, "pixel"), first)});
}

/// The share of pixels that are white in some channel: 1 of codes, else the picture's largest value.
double share_at_white(const Image& picture, bool was_codes) {
  float white = was_codes ? 1.0F : 0.0F;
  if (!was_codes)
    for (const float value : picture.values) white = std::max(white, value);
  std::size_t clipped = 0;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) clipped += picture.rgb(x, y).maxCoeff() >= white ? 1 : 0;
  return static_cast<double>(clipped) / (static_cast<double>(picture.width_px) * picture.height_px);
}

}  // namespace

Photograph read_photograph(const std::filesystem::path& path, const std::optional<Projection>& projection,
                           const std::string& layer) {
  PictureFile file = read_picture(
      path,
      [&](const ImageHeader& header) {
        if (header.channels < 3)
          throw input_error({.file = path.string(),
                             .wanted = "three colour channels",
                             .found = std::to_string(header.channels) + " channels"});
      },
      layer);
  const int width_px = file.image.width_px, height_px = file.image.height_px;
  Photograph photograph{.radiance = std::move(file.image),
                        .orientation = file.orientation,
                        .was_codes = !file.floating_point,
                        .width_px = width_px,
                        .height_px = height_px,
                        .profile = std::move(file.profile),
                        .notes = std::move(file.notes)};
  Image& picture = photograph.radiance;
  require_colours(picture, path);
  photograph.clipped_share = share_at_white(picture, photograph.was_codes);
  const bool twice_as_wide = picture.width_px == 2 * picture.height_px;
  photograph.projection = projection.value_or(twice_as_wide ? Projection::panorama : Projection::perspective);
  if (photograph.projection == Projection::panorama && !twice_as_wide)
    throw input_error({.file = path.string(),
                       .wanted = "a panorama twice as wide as high",
                       .found = fmt::format("{} x {}", picture.width_px, picture.height_px)});
  return photograph;
}

std::string codes_warning(const Photograph& photograph, const std::string& file) {
  // Of a picture of one value nothing can be said.
  const bool ends_at_one_value = photograph.clipped_share > 0.002 && photograph.clipped_share < 0.5;
  if (!photograph.was_codes)
    return ends_at_one_value ? fmt::format(
                                   "{}: {:.2g} % of its pixels have the same largest value, as a picture "
                                   "that was clipped has: how bright these were is lost",
                                   printable(file), 100 * photograph.clipped_share)
                             : "";
  return fmt::format(
      "{}: whole numbers, taken as {} (white is 1 W/m2/sr); {:.2g} % of the pixels are white in some channel, and how "
      "bright these were is lost",
      printable(file), photograph.profile ? "codes of its profile" : "sRGB codes (IEC 61966-2-1)",
      100 * photograph.clipped_share);
}

namespace {

template <class Lens>
Camera camera_through(const Lens& lens, const Camera& view) {
  Camera camera = view;
  camera.width_px = lens.width_px;
  camera.height_px = lens.height_px;
  const Eigen::Matrix3d turn = world_from_photograph(view).linear();
  camera.directions =
      std::make_shared<const ImageDirections>([lens, turn](float x, float y) -> Eigen::Vector3f {
        const auto direction = sensors::direction_through(lens, {double{x}, double{y}});
        if (!direction) return Eigen::Vector3f::Zero();
        const Eigen::Vector3d towards = turn * *direction;
        return towards.normalized().cast<float>();
      });
  return camera;
}

}  // namespace

Camera lens_camera(const sensors::PinholeCamera& lens, const Camera& view) {
  Camera camera = camera_through(lens, view);
  camera.tan_half_horizontal = static_cast<float>(
      std::tan(0.5 * sensors::horizontal_field_of_view_deg(lens) * std::numbers::pi / 180));
  return camera;
}

Camera lens_camera(const sensors::FisheyeCamera& lens, const Camera& view) {
  Camera camera = camera_through(lens, view);
  // No pinhole sees as much; what asks for an angle a pixel gets that of its middle.
  camera.tan_half_horizontal = static_cast<float>(0.5 * lens.width_px / lens.fx_px);
  return camera;
}

Rgb panorama_radiance(const Image& panorama, const Eigen::Vector3f& direction) {
  constexpr float pi = std::numbers::pi_v<float>;
  const int width = panorama.width_px, height = panorama.height_px;
  const float column =
      (std::atan2(direction.x(), -direction.z()) / (2 * pi) + 0.5F) * static_cast<float>(width) - 0.5F;
  const float row =
      (0.5F - std::asin(std::clamp(direction.y(), -1.0F, 1.0F)) / pi) * static_cast<float>(height) - 0.5F;
  return bilinear(between_cells(column, row), [&](int x, int y) {
    return panorama.rgb((x + width) % width, std::clamp(y, 0, height - 1));
  });
}

Image view_of_panorama(const Image& panorama, const Camera& camera, int threads) {
  constexpr int side = 4;
  Image view(camera.width_px, camera.height_px, 3);
  parallel_for(camera.height_px, threads, [&](int y) {
    for (int x = 0; x < camera.width_px; ++x) {
      Rgb sum = Rgb::Zero();
      for (int i = 0; i < side * side; ++i)
        sum += panorama_radiance(
            panorama, camera.direction(static_cast<float>(x) + (static_cast<float>(i % side) + 0.5F) / side,
                                       static_cast<float>(y) + (static_cast<float>(i / side) + 0.5F) / side));
      view.set_rgb(x, y, sum / static_cast<float>(side * side));
    }
  });
  return view;
}

ViewMatch match_view(const Image& photograph, const Camera& camera, const Image& panorama) {
  const int step = std::max(1, std::min(camera.width_px, camera.height_px) / 64);
  const auto bright = [](const Rgb& colour) { return std::log(std::max(1e-6, double{colour.mean()})); };
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int y = step / 2; y < camera.height_px; y += step)
    for (int x = step / 2; x < camera.width_px; x += step) {
      const Eigen::Vector3f direction = camera.centre_direction(x, y);
      if (direction.isZero()) continue;
      const double shown = bright(photograph.rgb(x, y)),
                   around = bright(panorama_radiance(panorama, direction));
      n += 1, a += shown, b += around, aa += shown * shown, bb += around * around, ab += shown * around;
    }
  const double spread = (aa - a * a / n) * (bb - b * b / n);
  return {.likeness = spread > 0 ? (ab - a * b / n) / std::sqrt(spread) : 0,
          .scale = n > 0 ? std::exp((a - b) / n) : 1};
}

}  // namespace seamline::renderer
