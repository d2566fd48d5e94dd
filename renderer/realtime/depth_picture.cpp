#include "renderer/realtime/depth_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

constexpr float cut_off_m = 1e-3F;
constexpr float no_depth_m = std::numeric_limits<float>::infinity();

/// A corner of a triangle in the picture. `value` is what is linear over the picture: depth of parallel
/// views, 1 / depth from a point.
struct Corner {
  float x, y, value;
};

/// From points of the world to corners.
class CornerProjection {
 public:
  CornerProjection(const DrawView& view, const DepthPicture& picture)
      : view_(view),
        to_px_(static_cast<float>(picture.width_px) / view.size[0],
               static_cast<float>(picture.height_px) / view.size[1]) {}

  /// In the view's axes.
  [[nodiscard]] Eigen::Vector3f seen(const Eigen::Vector3f& point_m) const {
    return view_.axes * (point_m - view_.eye_m);
  }
  [[nodiscard]] Corner corner(const Eigen::Vector3f& seen_m) const {
    const float over_depth = view_.from_point ? 1.0F / seen_m.z() : 1.0F;
    return {(seen_m.x() * over_depth - view_.corner[0]) * to_px_[0],
            (seen_m.y() * over_depth - view_.corner[1]) * to_px_[1],
            view_.from_point ? over_depth : seen_m.z()};
  }
  [[nodiscard]] bool from_point() const { return view_.from_point; }

 private:
  const DrawView& view_;
  Eigen::Array2f to_px_;
};

/// The edge between two corners. From the same ends in the same order whichever triangle asks, so that
/// neighbours agree. A level edge is where it begins.
class Edge {
 public:
  Edge(const Corner& above, const Corner& below)
      : x_(above.x), y_(above.y), slope_(below.y > above.y ? (below.x - above.x) / (below.y - above.y) : 0) {}
  [[nodiscard]] float x_at(float y) const { return x_ + (y - y_) * slope_; }

 private:
  float x_, y_, slope_;
};

bool is_above(const Corner& a, const Corner& b) {
  return a.y < b.y || (a.y == b.y && a.x < b.x);
}

/// The rows of a picture that one worker draws.
class Band {
 public:
  Band(DepthPicture& picture, bool from_point, int first_row, int last_row)
      : picture_(picture), from_point_(from_point), first_row_(first_row), last_row_(last_row) {}

  void draw(Corner a, Corner b, Corner c) {
    if (is_above(b, a)) std::swap(a, b);
    if (is_above(c, b)) std::swap(b, c);
    if (is_above(b, a)) std::swap(a, b);
    if (!(c.y >= static_cast<float>(first_row_) && a.y <= static_cast<float>(last_row_ + 1))) return;
    const int top = std::max(first_row_, whole_above(std::max(a.y - 0.5F, -1.0F)));
    const int bottom = std::min(last_row_, whole_below(std::min(c.y - 0.5F, static_cast<float>(last_row_))));
    if (top > bottom) return;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    const float least = std::min({a.value, b.value, c.value}), most = std::max({a.value, b.value, c.value});
    const float by_x =
        area == 0.0F ? 0.0F : ((b.value - a.value) * (c.y - a.y) - (c.value - a.value) * (b.y - a.y)) / area;
    const float by_y =
        area == 0.0F ? 0.0F : ((c.value - a.value) * (b.x - a.x) - (b.value - a.value) * (c.x - a.x)) / area;
    const Edge whole(a, c), upper(a, b), lower(b, c);
    const float width = static_cast<float>(picture_.width_px);
    for (int row = top; row <= bottom; ++row) {
      const float y = static_cast<float>(row) + 0.5F;
      const float one = whole.x_at(y), other = y < b.y ? upper.x_at(y) : lower.x_at(y);
      const int left = whole_above(std::clamp(std::min(one, other) - 0.5F, -1.0F, width));
      const int right = whole_below(std::clamp(std::max(one, other) - 0.5F, -1.0F, width));
      const float in_row = a.value + by_y * (y - a.y) + by_x * (0.5F - a.x);
      float* const pixels =
          &picture_.depth_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.width_px)];
      const int last = std::min(right, picture_.width_px - 1);
      if (from_point_)
        for (int x = std::max(left, 0); x <= last; ++x) {
          const float depth_m = 1.0F / std::clamp(in_row + by_x * static_cast<float>(x), least, most);
          pixels[x] = std::min(pixels[x], depth_m);
        }
      else
        for (int x = std::max(left, 0); x <= last; ++x)
          pixels[x] = std::min(pixels[x], std::clamp(in_row + by_x * static_cast<float>(x), least, most));
    }
  }

 private:
  DepthPicture& picture_;
  bool from_point_;
  int first_row_, last_row_;
};

/// Of a triangle that reaches behind the nearest plane, the polygon before it.
int cut_at_nearest(const std::array<Eigen::Vector3f, 3>& seen, std::array<Eigen::Vector3f, 4>& out) {
  int count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector3f &from = seen[i], &to = seen[(i + 1) % 3];
    if (from.z() >= cut_off_m) out[static_cast<std::size_t>(count++)] = from;
    if ((from.z() >= cut_off_m) != (to.z() >= cut_off_m)) {
      const float share = (cut_off_m - from.z()) / (to.z() - from.z());
      Eigen::Vector3f between = from + share * (to - from);
      between.z() = cut_off_m;
      out[static_cast<std::size_t>(count++)] = between;
    }
  }
  return count;
}

/// A mesh whose vertices are projected already.
struct ProjectedMesh {
  std::vector<Eigen::Vector3f> seen_m;  ///< from a point only
  std::vector<Corner> corners;
};

ProjectedMesh project(const CornerProjection& projection, std::span<const Eigen::Vector3f> positions_m,
                      int threads) {
  ProjectedMesh out;
  out.corners.resize(positions_m.size());
  if (projection.from_point()) out.seen_m.resize(positions_m.size());
  constexpr std::size_t at_a_time = 4096;
  const auto parts = static_cast<int>((positions_m.size() + at_a_time - 1) / at_a_time);
  parallel_for(parts, threads, [&](int part) {
    const std::size_t first = static_cast<std::size_t>(part) * at_a_time;
    for (std::size_t i = first; i < std::min(positions_m.size(), first + at_a_time); ++i) {
      const Eigen::Vector3f seen_m = projection.seen(positions_m[i]);
      out.corners[i] = projection.corner(seen_m);
      if (projection.from_point()) out.seen_m[i] = seen_m;
    }
  });
  return out;
}

void draw_mesh(const CornerProjection& projection, const ProjectedMesh& mesh,
               std::span<const Triangle> triangles, Band& band) {
  for (const Triangle& triangle : triangles) {
    if (projection.from_point()) {
      const std::array<Eigen::Vector3f, 3> seen = {mesh.seen_m[triangle[0]], mesh.seen_m[triangle[1]],
                                                   mesh.seen_m[triangle[2]]};
      const float nearest = std::min({seen[0].z(), seen[1].z(), seen[2].z()});
      if (!(nearest >= cut_off_m)) {
        std::array<Eigen::Vector3f, 4> polygon;
        const int corners = cut_at_nearest(seen, polygon);
        for (int i = 2; i < corners; ++i)
          band.draw(projection.corner(polygon[0]), projection.corner(polygon[i - 1]),
                    projection.corner(polygon[i]));
        continue;
      }
    }
    band.draw(mesh.corners[triangle[0]], mesh.corners[triangle[1]], mesh.corners[triangle[2]]);
  }
}

}  // namespace

ViewedPoint view_point(const DrawView& view, const DepthPicture& picture, const Eigen::Vector3f& point_m) {
  const CornerProjection projection(view, picture);
  const Eigen::Vector3f seen_m = projection.seen(point_m);
  const Corner corner = projection.corner(seen_m);
  return {corner.x, corner.y, seen_m.z()};
}

void draw_depth(const DrawView& view, std::span<const TriangleSpan> meshes, int threads,
                DepthPicture& picture) {
  std::fill(picture.depth_m.begin(), picture.depth_m.end(), no_depth_m);
  const CornerProjection projection(view, picture);
  std::vector<ProjectedMesh> projected;
  projected.reserve(meshes.size());
  for (const TriangleSpan& mesh : meshes) projected.push_back(project(projection, mesh.positions_m, threads));
  const int bands = std::clamp(threads, 1, std::max(picture.height_px, 1));
  parallel_for(bands, threads, [&](int number) {
    const int first_row = picture.height_px * number / bands;
    const int last_row = picture.height_px * (number + 1) / bands - 1;
    Band band(picture, view.from_point, first_row, last_row);
    for (std::size_t i = 0; i < meshes.size(); ++i)
      draw_mesh(projection, projected[i], meshes[i].triangles, band);
  });
}

DepthPicture empty_picture(int width_px, int height_px) {
  return {width_px, height_px,
          std::vector<float>(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px),
                             no_depth_m)};
}

Eigen::Matrix3f axes_along(const Eigen::Vector3f& forward) {
  const Eigen::Vector3f aside =
      std::abs(forward.y()) < 0.9F ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitX();
  const Eigen::Vector3f right = forward.cross(aside).normalized();
  Eigen::Matrix3f axes;
  axes.row(0) = right.transpose();
  axes.row(1) = forward.cross(right).transpose();
  axes.row(2) = forward.transpose();
  return axes;
}

}  // namespace seamline::renderer
