#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "support/files/image.h"

namespace seamline {

/// FLIP (Andersson et al. 2020) derived independently for whole pictures: doubles throughout, two-dimensional
/// kernels as the paper writes them, no shared code, matrices as decimals.
namespace independent {

using Triple = std::array<double, 3>;
using Plane = std::vector<double>;

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double matrix[3][3] = {{0.4123865632529917, 0.35759149092062537, 0.18045049120356368},
                                        {0.21263682167732384, 0.7151829818412507, 0.07218019648142547},
                                        {0.019330620152483987, 0.11919716364020845, 0.9503725870054354}};
inline constexpr double inverse[3][3] = {{3.2410032329763587, -1.5373989694887855, -0.4986158819963629},
                                         {-0.9692242522025166, 1.875929983695176, 0.041554226340084724},
                                         {0.055639419851975444, -0.20401120612390997, 1.0571489771875335}};
inline constexpr double white[3] = {0.9504285453771807, 1.0, 1.0889003707981277};

inline double linear(double code) {
  const double v = code / 255;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

inline Triple times(const double (&m)[3][3], const Triple& v) {
  Triple out{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out[row] += m[row][column] * v[column];
  return out;
}

inline Triple opponent(const Triple& rgb) {
  const Triple xyz = times(matrix, rgb);
  const double x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

inline Triple hunt_lab(const Triple& rgb) {
  const Triple xyz = times(matrix, rgb);
  Triple f{};
  for (int i = 0; i < 3; ++i) {
    const double t = xyz[i] / white[i];
    f[i] = t > 0.00885645167903563 ? std::pow(t, 1.0 / 3) : 7.787037037037037 * t + 0.13793103448275862;
  }
  const double lightness = 116 * f[1] - 16;
  return {lightness, 5 * lightness * (f[0] - f[1]), 2 * lightness * (f[1] - f[2])};
}

inline double distance(const Triple& a, const Triple& b) {
  return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

struct Kernel {
  int radius;
  Plane weight;  // (2 radius + 1)^2, rows first
};

inline double at(const Plane& plane, int width, int height, int x, int y) {
  x = x < 0 ? 0 : x >= width ? width - 1 : x;
  y = y < 0 ? 0 : y >= height ? height - 1 : y;
  return plane[static_cast<std::size_t>(y * width + x)];
}

inline double filtered_at(const Plane& plane, int width, int height, int x, int y, const Kernel& kernel) {
  double sum = 0;
  std::size_t i = 0;
  for (int dy = -kernel.radius; dy <= kernel.radius; ++dy)
    for (int dx = -kernel.radius; dx <= kernel.radius; ++dx)
      sum += kernel.weight[i++] * at(plane, width, height, x + dx, y + dy);
  return sum;
}

inline Kernel sensitivity(double ppd_px, double a1, double b1, double a2, double b2) {
  Kernel kernel{static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_px)), {}};
  double sum = 0;
  for (int y = -kernel.radius; y <= kernel.radius; ++y)
    for (int x = -kernel.radius; x <= kernel.radius; ++x) {
      const double r2 = (x * x + y * y) / (ppd_px * ppd_px);
      kernel.weight.push_back(a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * r2 / b1) +
                              a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * r2 / b2));
      sum += kernel.weight.back();
    }
  for (double& weight : kernel.weight) weight /= sum;
  return kernel;
}

inline Kernel feature(double ppd_px, bool point, bool vertical) {
  const double sd = 0.5 * 0.082 * ppd_px;
  Kernel kernel{static_cast<int>(std::ceil(3 * sd)), {}};
  double positive = 0, negative = 0;
  for (int y = -kernel.radius; y <= kernel.radius; ++y)
    for (int x = -kernel.radius; x <= kernel.radius; ++x) {
      const int along = vertical ? y : x;
      const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
      const double weight = point ? (along * along / (sd * sd) - 1) * g : -along * g;
      kernel.weight.push_back(weight);
      (weight > 0 ? positive : negative) += std::abs(weight);
    }
  for (double& weight : kernel.weight) weight /= weight > 0 ? positive : negative;
  return kernel;
}

struct Picture {
  int width, height;
  std::array<Plane, 3> channel;
};

inline Picture picture_of(const ByteImage& image) {
  Picture picture{image.width_px, image.height_px, {}};
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    const Triple ycc =
        opponent({linear(image.values[i]), linear(image.values[i + 1]), linear(image.values[i + 2])});
    for (int c = 0; c < 3; ++c) picture.channel[static_cast<std::size_t>(c)].push_back(ycc[c]);
  }
  return picture;
}

inline Triple seen_colour(const Picture& p, int x, int y, const std::array<Kernel, 3>& kernels) {
  Triple ycc{};
  for (std::size_t c = 0; c < 3; ++c) ycc[c] = filtered_at(p.channel[c], p.width, p.height, x, y, kernels[c]);
  const double yy = (ycc[0] + 16) / 116;
  Triple rgb = times(inverse, {white[0] * (yy + ycc[1] / 500), yy, white[2] * (yy - ycc[2] / 200)});
  for (double& value : rgb) value = std::min(1.0, std::max(0.0, value));
  return hunt_lab(rgb);
}

inline double strength(const Picture& p, int x, int y, const Kernel& horizontal, const Kernel& vertical) {
  Plane grey = p.channel[0];
  for (double& value : grey) value = (value + 16) / 116;
  return std::hypot(filtered_at(grey, p.width, p.height, x, y, horizontal),
                    filtered_at(grey, p.width, p.height, x, y, vertical));
}

inline Plane flip(const ByteImage& reference, const ByteImage& test, double ppd_px) {
  const Picture r = picture_of(reference), t = picture_of(test);
  const std::array<Kernel, 3> kernels = {sensitivity(ppd_px, 1, 0.0047, 0, 1e-5),
                                         sensitivity(ppd_px, 1, 0.0053, 0, 1e-5),
                                         sensitivity(ppd_px, 34.1, 0.04, 13.5, 0.025)};
  const double most = std::pow(distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
  const Kernel ex = feature(ppd_px, false, false), ey = feature(ppd_px, false, true);
  const Kernel px = feature(ppd_px, true, false), py = feature(ppd_px, true, true);
  Plane out;
  for (int y = 0; y < r.height; ++y)
    for (int x = 0; x < r.width; ++x) {
      const double power =
          std::pow(distance(seen_colour(r, x, y, kernels), seen_colour(t, x, y, kernels)), 0.7);
      const double colour = power < 0.4 * most ? 0.95 / (0.4 * most) * power
                                               : 0.95 + (power - 0.4 * most) / (most - 0.4 * most) * 0.05;
      const double edges = std::abs(strength(r, x, y, ex, ey) - strength(t, x, y, ex, ey));
      const double points = std::abs(strength(r, x, y, px, py) - strength(t, x, y, px, py));
      out.push_back(std::pow(colour, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0))));
    }
  return out;
}

}  // namespace independent

}  // namespace seamline
