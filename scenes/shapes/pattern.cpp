#include "scenes/shapes/pattern.h"

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "support/arithmetic/colour.h"
#include "support/arithmetic/random.h"

namespace seamline::scenes {
namespace {

using std::numbers::pi;
using Colour = Eigen::Array3d;

constexpr int side_px = 512;

/// Smooth noise around 0, of about unit size, that repeats after `cells` cells a side.
class Noise {
 public:
  Noise(int cells, std::uint64_t seed) : cells_(cells) {
    Random random(seed);
    for (int i = 0; i < cells * cells; ++i) values_.push_back(2 * random.uniform() - 1);
  }
  /// `u`, `v` in sides of the picture.
  [[nodiscard]] double at(double u, double v) const {
    const double x = u * cells_, y = v * cells_;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const double s = ease(x - column), t = ease(y - row);
    const double upper = (1 - s) * value(column, row) + s * value(column + 1, row);
    const double lower = (1 - s) * value(column, row + 1) + s * value(column + 1, row + 1);
    return (1 - t) * upper + t * lower;
  }

 private:
  static double ease(double t) { return t * t * (3 - 2 * t); }
  [[nodiscard]] double value(int column, int row) const {
    const int x = (column % cells_ + cells_) % cells_, y = (row % cells_ + cells_) % cells_;
    return values_[static_cast<std::size_t>(y * cells_ + x)];
  }

  int cells_;
  std::vector<double> values_;
};

/// A place of a surface: what it looks like, and how high it stands.
struct Place {
  Colour colour = Colour::Constant(0.5);  ///< linear
  double roughness = 0.8;
  double height_m = 0;
};

/// How far a place is from the nearest edge of cells of width `width`, all in sides of the picture.
double from_edge(double at, double width) {
  const double within = at / width - std::floor(at / width);
  return std::min(within, 1 - within) * width;
}

/// Boards along u, five a side, each of its own tint, with grain and open joints.
class Planks {
 public:
  static constexpr double side_m = 1.1;
  Place operator()(double u, double v) const {
    constexpr int boards = 5;
    const int board = static_cast<int>(std::floor(v * boards)) % boards;
    const auto number = static_cast<std::size_t>(board);
    const double along = u + offset_[number];
    const double grain = 0.5 * fine_.at(0.12 * along, v + 0.37 * board) + 0.5 * finer_.at(0.1 * along, v) +
                         0.35 * coarse_.at(along, v);
    const double joint = std::min(from_edge(v, 1.0 / boards), from_edge(along, 1.0));
    const double open = std::clamp(1 - joint / 0.0035, 0.0, 1.0);
    Place place;
    place.colour = Colour(0.33, 0.19, 0.095) * (tint_[number] * (1 + 0.22 * grain)) * (1 - 0.75 * open);
    place.roughness = 0.34 + 0.08 * grain + 0.4 * open;
    place.height_m = -0.0016 * open + 0.00012 * grain;
    return place;
  }

 private:
  Noise coarse_{6, 11}, fine_{64, 12}, finer_{128, 13};
  std::array<double, 5> tint_{0.92, 1.12, 0.8, 1.02, 1.2}, offset_{0.1, 0.62, 0.35, 0.85, 0.5};
};

/// Cloth: threads over and under, a little uneven.
class Weave {
 public:
  static constexpr double side_m = 0.25;
  Place operator()(double u, double v) const {
    constexpr int threads = 40;
    const double x = u * threads * pi, y = v * threads * pi;
    const bool warp =
        (static_cast<int>(std::floor(u * threads)) + static_cast<int>(std::floor(v * threads))) % 2 == 0;
    const double over = warp ? std::abs(std::sin(x)) : std::abs(std::sin(y));
    const double uneven = coarse_.at(u, v) + 0.5 * fine_.at(u, v);
    Place place;
    place.colour = Colour(0.10, 0.20, 0.27) * (0.72 + 0.4 * over + 0.12 * uneven + (warp ? 0.06 : -0.06));
    place.roughness = 0.92;
    place.height_m = 0.0007 * over + 0.0002 * uneven;
    return place;
  }

 private:
  Noise coarse_{5, 21}, fine_{80, 22};
};

/// Painted plaster: nearly even, with the marks of the roller.
class Plaster {
 public:
  static constexpr double side_m = 1.5;
  Place operator()(double u, double v) const {
    const double marks = 0.6 * coarse_.at(u, v) + 0.4 * fine_.at(u, v);
    Place place;
    place.colour = Colour(0.72, 0.70, 0.65) * (1 + 0.035 * marks);
    place.roughness = 0.85;
    place.height_m = 0.0012 * finest_.at(u, v);
    return place;
  }

 private:
  Noise coarse_{7, 31}, fine_{31, 32}, finest_{128, 33};
};

/// Poured and polished, with stains.
class Concrete {
 public:
  static constexpr double side_m = 2.0;
  Place operator()(double u, double v) const {
    const double stains = 0.6 * coarse_.at(u, v) + 0.3 * fine_.at(u, v) + 0.25 * finest_.at(u, v);
    const double joint = std::min(from_edge(u, 0.5), from_edge(v, 0.5));
    const double open = std::clamp(1 - joint / 0.002, 0.0, 1.0);
    Place place;
    place.colour = Colour(0.30, 0.29, 0.27) * (1 + 0.3 * stains) * (1 - 0.6 * open);
    place.roughness = 0.55 + 0.15 * stains;
    place.height_m = -0.003 * open + 0.0002 * stains;
    return place;
  }

 private:
  Noise coarse_{4, 41}, fine_{17, 42}, finest_{96, 43};
};

std::uint8_t code_of(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

ByteImage blank() {
  ByteImage image{side_px, side_px, 3, {}};
  image.values.resize(std::size_t{3} * side_px * side_px);
  return image;
}

void put(ByteImage& image, std::size_t pixel, const Colour& shares) {
  for (int channel = 0; channel < 3; ++channel)
    image.values[3 * pixel + static_cast<std::size_t>(channel)] = code_of(shares[channel]);
}

template <class Kind>
PatternPictures drawn(const Kind& kind) {
  PatternPictures pattern{Kind::side_m, blank(), blank(), blank()};
  std::vector<Place> places;
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) places.push_back(kind((x + 0.5) / side_px, (y + 0.5) / side_px));
  const auto height_m = [&](int x, int y) {
    return places[static_cast<std::size_t>((y + side_px) % side_px * side_px + (x + side_px) % side_px)]
        .height_m;
  };
  const double two_steps_m = 2 * Kind::side_m / side_px;
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      const auto pixel = static_cast<std::size_t>(y * side_px + x);
      const Place& place = places[pixel];
      Colour srgb;
      for (int channel = 0; channel < 3; ++channel)
        srgb[channel] = srgb_from_linear(static_cast<float>(place.colour[channel]));
      put(pattern.colour, pixel, srgb);
      // Rows run downwards, green points upwards.
      const Eigen::Vector3d normal =
          Eigen::Vector3d(-(height_m(x + 1, y) - height_m(x - 1, y)) / two_steps_m,
                          (height_m(x, y + 1) - height_m(x, y - 1)) / two_steps_m, 1)
              .normalized();
      put(pattern.normal, pixel, 0.5 * normal.array() + 0.5);
      put(pattern.gloss, pixel, Colour(1, place.roughness, 0));
    }
  return pattern;
}

}  // namespace

PatternPictures make_pattern(std::string_view name) {
  if (name == "planks") return drawn(Planks());
  if (name == "weave") return drawn(Weave());
  if (name == "plaster") return drawn(Plaster());
  if (name == "concrete") return drawn(Concrete());
  throw std::invalid_argument("no pattern is called " + std::string(name));
}

}  // namespace seamline::scenes
