#include "laboratory/figures/field_figure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "renderer/realtime/harmonics/occlusion_field.h"
#include "renderer/realtime/harmonics/spherical_harmonics.h"

namespace seamline::renderer {
namespace {

constexpr int view_px = 480, map_width_px = 288, map_height_px = 144, field_gap_px = 16;
constexpr int latitudes = 17, longitudes = 32, field_rays = 8192;
constexpr std::array bands_shown = {2, 4, 6};

using Colour = std::array<std::uint8_t, 3>;
constexpr std::array<Colour, 3> highlights = {Colour{214, 39, 40}, Colour{31, 119, 180}, Colour{44, 140, 44}};
/// Latitude and longitude of the samples that are shown: above, beside, below.
constexpr std::array<std::pair<int, int>, 3> shown_samples = {std::pair{5, 4}, {8, 10}, {11, 7}};

Eigen::Vector3f sample_direction(int latitude, int longitude) {
  const double polar = std::numbers::pi * latitude / (latitudes - 1),
               azimuth = 2 * std::numbers::pi * longitude / longitudes;
  return Eigen::Vector3d(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                         std::sin(polar) * std::sin(azimuth))
      .cast<float>();
}

/// Through the centre of a texel of an equirectangular map, +Y up, its middle column towards -Z.
Eigen::Vector3d map_direction(int x, int y) {
  const double azimuth = 2 * std::numbers::pi * ((x + 0.5) / map_width_px - 0.5),
               polar = std::numbers::pi * (y + 0.5) / map_height_px;
  return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

class FieldSheet {
 public:
  FieldSheet(int width_px, int height_px)
      : picture{.width_px = width_px, .height_px = height_px, .channels = 3, .values = {}} {
    picture.values.assign(width_px * static_cast<std::size_t>(height_px) * 3, 255);
  }
  void set(int x, int y, const Colour& colour) {
    if (x < 0 || y < 0 || x >= picture.width_px || y >= picture.height_px) return;
    std::copy(colour.begin(), colour.end(),
              picture.values.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width_px + x));
  }
  void disc(double x, double y, double radius_px, const Colour& colour) {
    for (int row = static_cast<int>(y - radius_px); row <= static_cast<int>(y + radius_px) + 1; ++row)
      for (int column = static_cast<int>(x - radius_px); column <= static_cast<int>(x + radius_px) + 1;
           ++column)
        if (std::hypot(column + 0.5 - x, row + 0.5 - y) <= radius_px) set(column, row, colour);
  }
  void frame(int left, int top, int width, int height, const Colour& colour) {
    for (int t = 1; t <= 3; ++t) {
      for (int x = left - t; x < left + width + t; ++x) {
        set(x, top - t, colour);
        set(x, top + height - 1 + t, colour);
      }
      for (int y = top - t; y < top + height + t; ++y) {
        set(left - t, y, colour);
        set(left + width - 1 + t, y, colour);
      }
    }
  }
  ByteImage picture;
};

Colour grey(double share) {
  const auto code = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
  return {code, code, code};
}

/// The object from a little above, lit from the eye, with the shell's samples before and behind it.
void draw_view(const Geometry& object, const Eigen::Vector3f& centre_m, float shell_m, int threads,
               FieldSheet& canvas) {
  const Eigen::Vector3f back = Eigen::Vector3f(0.45F, 0.35F, 1).normalized();
  const Eigen::Vector3f right = Eigen::Vector3f::UnitY().cross(back).normalized(), up = back.cross(right);
  const float eye_distance_m = 5 * shell_m, half = 1.15F * shell_m;  // parallel rays from there
  parallel_for(view_px, threads, [&](int y) {
    for (int x = 0; x < view_px; ++x) {
      const float u = (2.0F * (static_cast<float>(x) + 0.5F) / view_px - 1.0F) * half,
                  v = (1.0F - 2.0F * (static_cast<float>(y) + 0.5F) / view_px) * half;
      const auto hit = object.nearest({centre_m + eye_distance_m * back + u * right + v * up, -back});
      if (hit)
        canvas.set(x, y, grey(0.25 + 0.6 * std::abs(static_cast<double>(hit->geometric_normal.dot(back)))));
    }
  });
  const auto draw = [&](int latitude, int longitude, double radius_px, const Colour& colour) {
    const Eigen::Vector3f from_centre_m = shell_m * sample_direction(latitude, longitude);
    if (object.occluded({centre_m + from_centre_m, back})) return;
    canvas.disc(0.5 * view_px * (1.0 + static_cast<double>(from_centre_m.dot(right) / half)),
                0.5 * view_px * (1.0 - static_cast<double>(from_centre_m.dot(up) / half)), radius_px, colour);
  };
  for (int latitude = 0; latitude < latitudes; ++latitude)
    for (int longitude = 0; longitude < longitudes; ++longitude) {
      const bool before = sample_direction(latitude, longitude).dot(back) > 0;
      draw(latitude, longitude, before ? 2.6 : 1.4, before ? Colour{235, 140, 30} : Colour{200, 190, 170});
    }
  for (std::size_t i = 0; i < shown_samples.size(); ++i)
    draw(shown_samples[i].first, shown_samples[i].second, 7, highlights[i]);
}

}  // namespace

FieldFigure field_figure(const Geometry& object, const Eigen::Vector3f& centre_m, float radius_m,
                         double shell, int threads) {
  const float shell_m = static_cast<float>(shell) * radius_m;
  const int columns = 1 + static_cast<int>(bands_shown.size());
  FieldSheet canvas(view_px + columns * (map_width_px + field_gap_px) + field_gap_px,
                    std::max(view_px, 3 * (map_height_px + field_gap_px) + field_gap_px));
  draw_view(object, centre_m, shell_m, threads, canvas);
  FieldFigure figure{.picture = {}, .bands = {bands_shown.begin(), bands_shown.end()}, .rms = {}};
  std::vector<OcclusionField> fields;
  for (const int bands : bands_shown)
    fields.push_back(sample_field(
        {centre_m, {shell_m}, latitudes, longitudes, bands},
        [&](std::span<const Ray> asked, std::span<std::uint8_t> blocked) {
          object.occluded(asked, blocked, Coherence::scattered);
        },
        radius_m, field_rays, threads));
  for (std::size_t i = 0; i < shown_samples.size(); ++i) {
    const Eigen::Vector3f place_m =
        centre_m + shell_m * sample_direction(shown_samples[i].first, shown_samples[i].second);
    const int top = field_gap_px + static_cast<int>(i) * (map_height_px + field_gap_px);
    std::vector<std::vector<float>> kept;
    for (const OcclusionField& field : fields) {
      kept.emplace_back(static_cast<std::size_t>(coefficient_count(field.shape.bands)));
      (void)look_up(field, place_m, kept.back());
    }
    std::vector<double> squares(fields.size(), 0);
    double weights = 0;
    std::vector<double> harmonics(static_cast<std::size_t>(coefficient_count(bands_shown.back())));
    for (int y = 0; y < map_height_px; ++y)
      for (int x = 0; x < map_width_px; ++x) {
        const Eigen::Vector3d direction = map_direction(x, y);
        const double visible = object.occluded({place_m, direction.cast<float>()}) ? 0 : 1;
        const double weight = std::sin(std::numbers::pi * (y + 0.5) / map_height_px);
        weights += weight;
        evaluate_harmonics(bands_shown.back(), direction, harmonics);
        const auto left = [&](std::size_t column) {
          return view_px + field_gap_px + static_cast<int>(column) * (map_width_px + field_gap_px);
        };
        canvas.set(left(0) + x, top + y, grey(visible));
        for (std::size_t b = 0; b < kept.size(); ++b) {
          double value = 0;
          for (std::size_t k = 0; k < kept[b].size(); ++k) value += kept[b][k] * harmonics[k];
          squares[b] += weight * (value - visible) * (value - visible);
          canvas.set(left(b + 1) + x, top + y, grey(value));
        }
      }
    for (std::size_t column = 0; column <= kept.size(); ++column)
      canvas.frame(view_px + field_gap_px + static_cast<int>(column) * (map_width_px + field_gap_px), top,
                   map_width_px, map_height_px, highlights[i]);
    figure.rms.emplace_back();
    for (const double sum : squares) figure.rms.back().push_back(std::sqrt(sum / weights));
  }
  figure.picture = std::move(canvas.picture);
  return figure;
}

}  // namespace seamline::renderer
