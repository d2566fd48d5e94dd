#include "registration/errors/error_classes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "registration/mesh/register_by_mesh.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::registration {
namespace {

using sensors::DepthFrame;
using sensors::PinholeCamera;
using Mask = std::vector<std::uint8_t>;

/// Pixels of the depth camera from an outline within which an error is the outline's.
constexpr double edge_reach_px = 2;

/// Of neighbouring depths between which there is an outline: an error there is at most as large as the jump.
/// Slopes between neighbouring pixels of flat surfaces stay below a hundredth.
double outline_ratio(double tolerance) {
  return 1 + std::max(tolerance, 0.01);
}

/// The depth camera with so many times as many pixels across.
PinholeCamera finer(const PinholeCamera& camera, int times) {
  PinholeCamera fine = camera;
  fine.width_px *= times;
  fine.height_px *= times;
  for (double* value : {&fine.fx_px, &fine.fy_px, &fine.cx_px, &fine.cy_px, &fine.skew_px}) *value *= times;
  return fine;
}

/// Pixels beside which depth jumps, `is_unseen(hole, neighbour)` saying of which holes nothing is known.
template <class IsUnseen>
Mask outlines_of(const DepthFrame& frame, double ratio, const IsUnseen& is_unseen) {
  Mask outlines(frame.depth_m.size(), 0);
  const auto compare = [&](std::size_t a, std::size_t b) {
    const float at_a = frame.depth_m[a], at_b = frame.depth_m[b];
    const bool hole_a = DepthFrame::is_hole(at_a), hole_b = DepthFrame::is_hole(at_b);
    if (hole_a && hole_b) return;
    const auto [nearest_m, farthest_m] = std::minmax(at_a, at_b);
    const bool jumps = hole_a   ? !is_unseen(a, b)
                       : hole_b ? !is_unseen(b, a)
                                : static_cast<double>(farthest_m) > ratio * static_cast<double>(nearest_m);
    if (jumps) outlines[a] = outlines[b] = 1;
  };
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      if (column + 1 < frame.camera.width_px) compare(frame.index(column, row), frame.index(column + 1, row));
      if (row + 1 < frame.camera.height_px) compare(frame.index(column, row), frame.index(column, row + 1));
    }
  return outlines;
}

/// Every pixel within `reach_px` of one that is marked, along rows and columns.
Mask widened(const Mask& mask, const PinholeCamera& camera, int reach_px) {
  const auto along = [&](const Mask& from, int lines, int length, int line_step, int step) {
    Mask to(from.size(), 0);
    for (int line = 0; line < lines; ++line) {
      int last_marked = -reach_px - 1, next = 0;
      const auto at = [&](int i) { return static_cast<std::size_t>(line * line_step + i * step); };
      for (int i = 0; i < length; ++i) {
        for (; next < length && next <= i + reach_px; ++next)
          if (from[at(next)] != 0) last_marked = next;
        to[at(i)] = last_marked >= i - reach_px ? 1 : 0;
      }
    }
    return to;
  };
  const int width = camera.width_px, height = camera.height_px;
  return along(along(mask, height, width, width, 1), width, height, 1, width);
}

/// What the depth camera truly sees, and where its outlines are.
class TrueView {
 public:
  TrueView(const DepthFrame& truth, const PinholeCamera& depth_camera,
           const Eigen::Isometry3d& colour_from_depth, const ErrorSettings& settings)
      : times_(std::clamp(static_cast<int>(std::ceil(truth.camera.fx_px / depth_camera.fx_px)), 1, 8)),
        frame_(register_by_mesh(truth, colour_from_depth.inverse(), finer(depth_camera, times_),
                                {.jumps = Jumps::cut,
                                 .jump_ratio = outline_ratio(settings.tolerance),
                                 .threads = settings.threads})
                   .frame) {
    const auto is_unseen = [&](std::size_t hole, std::size_t neighbour) {
      return !photograph_shows(truth.camera, colour_from_depth, hole, neighbour);
    };
    near_edge_ = widened(outlines_of(frame_, outline_ratio(settings.tolerance), is_unseen), frame_.camera,
                         static_cast<int>(std::ceil(edge_reach_px * times_)));
  }

  /// Whether all that is seen around a place of the depth camera's picture is nearer than a point there.
  [[nodiscard]] bool hides(const Eigen::Vector2d& place_px, double planar_m, double tolerance) const {
    const Eigen::Vector2i pixel = pixel_of(place_px);
    float farthest_m = 0;
    for (int row = pixel.y() - 1; row <= pixel.y() + 1; ++row)
      for (int column = pixel.x() - 1; column <= pixel.x() + 1; ++column) {
        if (row < 0 || column < 0 || row >= frame_.camera.height_px || column >= frame_.camera.width_px)
          continue;
        const float depth_m = frame_.at(column, row);
        if (!DepthFrame::is_hole(depth_m)) farthest_m = std::max(farthest_m, depth_m);
      }
    return farthest_m > 0 && static_cast<double>(farthest_m) * (1 + tolerance) < planar_m;
  }

  [[nodiscard]] bool is_near_edge(const Eigen::Vector2d& place_px) const {
    const Eigen::Vector2i pixel = pixel_of(place_px);
    return near_edge_[frame_.index(pixel.x(), pixel.y())] != 0;
  }

 private:
  [[nodiscard]] Eigen::Vector2i pixel_of(const Eigen::Vector2d& place_px) const {
    const auto nearest = [&](double place, int size) {
      return static_cast<int>(std::clamp(std::floor(place * times_), 0.0, size - 1.0));
    };
    return {nearest(place_px.x(), frame_.camera.width_px), nearest(place_px.y(), frame_.camera.height_px)};
  }

  /// Whether the photograph would show what is in a hole at its neighbour's depth: else the hole is where the
  /// photograph ends.
  [[nodiscard]] bool photograph_shows(const PinholeCamera& colour, const Eigen::Isometry3d& colour_from_depth,
                                      std::size_t hole, std::size_t neighbour) const {
    const std::size_t width = static_cast<std::size_t>(frame_.camera.width_px);
    const auto direction = sensors::direction_through(
        frame_.camera, {static_cast<double>(hole % width) + 0.5, static_cast<double>(hole / width) + 0.5});
    if (!direction) return false;
    const Eigen::Vector3d point_m = *direction * static_cast<double>(frame_.depth_m[neighbour]);
    const auto place_px = sensors::project(colour, colour_from_depth * point_m);
    return place_px && place_px->x() > 1 && place_px->y() > 1 && place_px->x() < colour.width_px - 1 &&
           place_px->y() < colour.height_px - 1;
  }

  int times_;
  DepthFrame frame_;
  Mask near_edge_;
};

/// Asks the classes' questions of one pixel after the other.
class Classifier {
 public:
  Classifier(const RegisteredFrame& registered, const DepthFrame& truth, const DepthFrame& measured,
             const Eigen::Isometry3d& colour_from_depth, const ErrorSettings& settings)
      : registered_(registered),
        truth_(truth),
        measured_(measured),
        settings_(settings),
        points_m_(points_in_colour_frame(truth, colour_from_depth.inverse(), settings.threads)),
        view_(truth, measured.camera, colour_from_depth, settings),
        near_edge_(widened(
            outlines_of(truth, outline_ratio(settings.tolerance),
                        [](std::size_t, std::size_t) { return false; }),
            truth.camera,
            static_cast<int>(std::ceil(edge_reach_px * truth.camera.fx_px / measured.camera.fx_px)))) {}

  [[nodiscard]] ErrorClass operator()(std::size_t at) const {
    if (is_right(at)) return ErrorClass::right;
    if (registered_.extruded[at] != 0) return ErrorClass::border;
    if (DepthFrame::is_hole(truth_.depth_m[at])) return ErrorClass::nothing;
    const Eigen::Vector3d& point_m = points_m_[at];
    const auto place_px = sensors::project(measured_.camera, point_m);
    if (!place_px || !is_between_centres(*place_px)) return ErrorClass::border;
    const bool radial = measured_.convention == sensors::DepthConvention::radial;
    const double value_m = radial ? point_m.norm() : point_m.z();
    if (value_m < settings_.range.nearest_m) return ErrorClass::near;
    if (value_m > settings_.range.farthest_m) return ErrorClass::far;
    if (view_.hides(*place_px, point_m.z(), settings_.tolerance)) return ErrorClass::occluded;
    const bool without_depth = registered_.filled[at] == 0;
    if (is_unmeasured(*place_px, without_depth)) return ErrorClass::unmeasured;
    if (without_depth) return ErrorClass::gap;
    return near_edge_[at] != 0 || view_.is_near_edge(*place_px) ? ErrorClass::edge : ErrorClass::noise;
  }

 private:
  [[nodiscard]] bool is_right(std::size_t at) const {
    const float found_m = registered_.frame.depth_m[at], true_m = truth_.depth_m[at];
    if (DepthFrame::is_hole(found_m) || DepthFrame::is_hole(true_m)) return found_m == true_m;
    const double difference_m = std::abs(static_cast<double>(found_m) - static_cast<double>(true_m));
    return difference_m <= settings_.tolerance * static_cast<double>(true_m);
  }

  /// The mesh ends at the centres of the outermost pixels.
  [[nodiscard]] bool is_between_centres(const Eigen::Vector2d& place_px) const {
    return place_px.x() >= 0.5 && place_px.y() >= 0.5 && place_px.x() <= measured_.camera.width_px - 0.5 &&
           place_px.y() <= measured_.camera.height_px - 0.5;
  }

  /// The pixel in which the point lies is a hole; or, of what has no depth, one of the four around it.
  [[nodiscard]] bool is_unmeasured(const Eigen::Vector2d& place_px, bool without_depth) const {
    const auto is_hole = [&](double x, double y) {
      const auto nearest = [](double place, int size) {
        return static_cast<int>(std::clamp(std::floor(place), 0.0, size - 1.0));
      };
      return DepthFrame::is_hole(
          measured_.at(nearest(x, measured_.camera.width_px), nearest(y, measured_.camera.height_px)));
    };
    if (!without_depth) return is_hole(place_px.x(), place_px.y());
    for (const double down : {-0.5, 0.5})
      for (const double across : {-0.5, 0.5})
        if (is_hole(place_px.x() + across, place_px.y() + down)) return true;
    return false;
  }

  const RegisteredFrame& registered_;
  const DepthFrame& truth_;
  const DepthFrame& measured_;
  const ErrorSettings& settings_;
  std::vector<Eigen::Vector3d> points_m_;  ///< the truth in the depth camera's frame
  TrueView view_;
  Mask near_edge_;  ///< of the photograph
};

double median_of(std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void tally_all(ErrorClassMap& map, const RegisteredFrame& registered, const DepthFrame& truth) {
  std::array<std::vector<double>, error_class_count> errors_m;
  for (std::size_t at = 0; at < map.classes.size(); ++at) {
    const auto one = static_cast<std::size_t>(map.classes[at]);
    ++map.tallies[one].pixels;
    const float found_m = registered.frame.depth_m[at], true_m = truth.depth_m[at];
    if (DepthFrame::is_hole(found_m))
      ++map.tallies[one].without_depth;
    else if (!DepthFrame::is_hole(true_m))
      errors_m[one].push_back(std::abs(static_cast<double>(found_m) - static_cast<double>(true_m)));
  }
  for (std::size_t one = 0; one < error_class_count; ++one)
    map.tallies[one].median_error_m = median_of(errors_m[one]);
}

}  // namespace

const char* word(ErrorClass error_class) {
  constexpr std::array<const char*, error_class_count> words = {
      "right", "border", "near", "far", "occluded", "nothing", "unmeasured", "gap", "edge", "noise"};
  return words[static_cast<std::size_t>(error_class)];
}

ErrorClassMap classify_errors(const RegisteredFrame& registered, const DepthFrame& truth,
                              const DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
                              const ErrorSettings& settings) {
  require_valid(measured, colour_from_depth, registered.frame.camera, {});
  if (truth.camera.width_px != registered.frame.camera.width_px ||
      truth.depth_m.size() != registered.frame.depth_m.size())
    throw input_error({.field = "registration: truth",
                       .wanted = fmt::format("{} values, one for each pixel of the photograph",
                                             registered.frame.depth_m.size()),
                       .found = std::to_string(truth.depth_m.size())});
  const Classifier class_of(registered, truth, measured, colour_from_depth, settings);
  ErrorClassMap map;
  map.classes.resize(truth.depth_m.size());
  const auto width = static_cast<std::size_t>(truth.camera.width_px);
  run_parallel(truth.camera.height_px, settings.threads, [&](int row) {
    for (std::size_t at = static_cast<std::size_t>(row) * width, i = 0; i < width; ++i, ++at)
      map.classes[at] = class_of(at);
  });
  tally_all(map, registered, truth);
  return map;
}

}  // namespace seamline::registration
