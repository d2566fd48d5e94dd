#include "analysis/detection/detection_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/arithmetic/random.h"

namespace seamline::analysis {
namespace {

struct PatternPlace {
  double x_deg = 0, y_deg = 0;
};

double cosine_along(const DetectionPattern& pattern, PatternPlace at, double angle_deg, double factor = 1) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const double along = at.y_deg * std::cos(angle) + at.x_deg * std::sin(angle);
  return std::cos(2 * std::numbers::pi * pattern.frequency_cpd * factor * along);
}

double gaussian_window(const DetectionPattern& pattern, PatternPlace at) {
  const double x = at.x_deg / pattern.sigma_x_deg, y = at.y_deg / pattern.sigma_y_deg;
  return std::exp(-(x * x + y * y) / 2);
}

double five_gabors(const DetectionPattern& pattern, PatternPlace at) {
  double sum = 0;
  for (int place = -2; place <= 2; ++place) {
    const PatternPlace from_its_middle{.x_deg = at.x_deg - 5 * pattern.sigma_x_deg * place,
                                       .y_deg = at.y_deg};
    const double sign = place % 2 == 0 ? 1 : pattern.other;
    sum += sign * cosine_along(pattern, at, 0) * gaussian_window(pattern, from_its_middle);
  }
  return sum;
}

/// The share of a pixel that lies within the disk, by 8 x 8 points.
double disk_share(const DetectionPattern& pattern, PatternPlace at) {
  constexpr int points = 8;
  int inside = 0;
  for (int j = 0; j < points; ++j)
    for (int i = 0; i < points; ++i) {
      const double x = at.x_deg + ((i + 0.5) / points - 0.5) / pattern.pixels_per_degree;
      const double y = at.y_deg + ((j + 0.5) / points - 0.5) / pattern.pixels_per_degree;
      inside += std::hypot(x, y) <= pattern.sigma_x_deg ? 1 : 0;
    }
  return static_cast<double>(inside) / (points * points);
}

double check_sign(const DetectionPattern& pattern, PatternPlace at) {
  const double u = (at.x_deg + at.y_deg) / 2, v = (at.x_deg - at.y_deg) / 2;
  const double frequency = 2 * std::numbers::pi * pattern.frequency_cpd;
  return std::cos(frequency * u) * std::cos(frequency * v) >= 0 ? 1 : -1;
}

/// One row of pixels counted from the middle one, which is row 0.
double pattern_row(const DetectionPattern& pattern, PatternPlace at, int row) {
  return std::lround(at.y_deg * pattern.pixels_per_degree) == row ? 1 : 0;
}

/// Without noise and without what is known of the whole picture only.
double pattern_value_at(const DetectionPattern& pattern, PatternPlace at) {
  const double window = pattern.sigma_y_deg > 0 ? gaussian_window(pattern, at) : 1;
  switch (pattern.kind) {
    case PatternKind::gabor:
      return cosine_along(pattern, at, pattern.angle_deg) * window;
    case PatternKind::compound:
      return (cosine_along(pattern, at, 0) + cosine_along(pattern, at, 0, pattern.other)) / 2 * window;
    case PatternKind::gaussian:
      return window;
    case PatternKind::edge:
      return at.y_deg >= 0 ? window : -window;
    case PatternKind::line:
      return pattern_row(pattern, at, 0) * window;
    case PatternKind::dipole:
      return (pattern_row(pattern, at, -1) - pattern_row(pattern, at, 1)) * window;
    case PatternKind::row_of_five:
      return five_gabors(pattern, at);
    case PatternKind::noise:
      return window;
    case PatternKind::plaid:
      return (cosine_along(pattern, at, pattern.angle_deg) +
              cosine_along(pattern, at, pattern.angle_deg + 90)) /
             2 * window;
    case PatternKind::disk:
      return disk_share(pattern, at);
    case PatternKind::bessel:
      return std::cyl_bessel_j(0,
                               2 * std::numbers::pi * pattern.frequency_cpd * std::hypot(at.x_deg, at.y_deg));
    case PatternKind::checkerboard:
      return check_sign(pattern, at) * window;
  }
  return 0;
}

PatternPlace place_of_pixel(const DetectionPattern& pattern, int x, int y) {
  const int middle = pattern.side_px / 2;
  return {.x_deg = (x - middle) / pattern.pixels_per_degree,
          .y_deg = (y - middle) / pattern.pixels_per_degree};
}

void multiply_by_squares(Image& image) {
  Random random(35);
  const int squares = (image.width_px + 1) / 2;
  std::vector<float> signs;
  for (int i = 0; i < squares * squares; ++i) signs.push_back(random.uniform() < 0.5 ? -1.0F : 1.0F);
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x)
      image.at(x, y) *= signs[static_cast<std::size_t>(y / 2 * squares + x / 2)];
}

/// Less the mean, times the window, largest 1.
void window_bessel(const DetectionPattern& pattern, Image& image) {
  double sum = 0;
  for (const float value : image.values) sum += double{value};
  const double mean = sum / image.values.size();
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x)
      image.at(x, y) = static_cast<float>((double{image.at(x, y)} - mean) *
                                          gaussian_window(pattern, place_of_pixel(pattern, x, y)));
  const float largest = *std::max_element(image.values.begin(), image.values.end());
  for (float& value : image.values) value /= largest;
}

}  // namespace

Image pattern_contrast(const DetectionPattern& pattern) {
  Image image(pattern.side_px, pattern.side_px, 1);
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x)
      image.at(x, y) = static_cast<float>(pattern_value_at(pattern, place_of_pixel(pattern, x, y)));
  if (pattern.kind == PatternKind::noise) multiply_by_squares(image);
  if (pattern.kind == PatternKind::bessel) window_bessel(pattern, image);
  return image;
}

Image pattern_picture(const Image& pattern_contrast, double contrast) {
  Image picture = pattern_contrast;
  for (float& value : picture.values) value = static_cast<float>((1 + contrast * double{value}) / 2);
  return picture;
}

}  // namespace seamline::analysis
