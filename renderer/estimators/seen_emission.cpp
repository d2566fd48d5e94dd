#include "renderer/estimators/seen_emission.h"

#include <algorithm>
#include <cmath>

#include "raytracer/common/parallel.h"
#include "raytracer/common/tiles.h"

namespace seamline::renderer {
namespace {

constexpr float small_px = 2.0F;  ///< an emitter less wide than this is small
constexpr std::size_t most_pieces = 1U << 18U;
constexpr std::size_t most_squares = 64;  ///< of a pixel that are looked through
constexpr int most_halvings = 12;
constexpr int area_side = 8;  ///< rays that say how much of a pixel a surface covers: its square

/// A ball around a part of an emitting triangle.
struct EmitterPiece {
  Eigen::Vector3f centre_m;
  float radius_m = 0;
  bool is_small = false;
};

/// Directions about an axis, from one eye.
struct ViewCone {
  Eigen::Vector3f from_m, axis;
  float half_rad = 0;

  [[nodiscard]] bool meets(const EmitterPiece& piece) const {
    const Eigen::Vector3f to_piece = piece.centre_m - from_m;
    const float distance_m = to_piece.norm();
    if (distance_m <= piece.radius_m) return true;
    const float angle_rad = std::atan2(axis.cross(to_piece).norm(), axis.dot(to_piece));
    return angle_rad <= half_rad + std::asin(piece.radius_m / distance_m);
  }
};

/// A square of the picture, in pixels.
struct PictureSquare {
  float left = 0, top = 0, side_px = 1;
};

class EmitterPieces {
 public:
  explicit EmitterPieces(const TruthScene& scene) : pixel_rad_(pixel_angle(scene.camera)) {
    for (const auto& mesh : scene.background) add(*mesh);
    for (const auto& object : scene.objects)
      for (const auto& mesh : object) add(*mesh);
  }
  [[nodiscard]] const std::vector<EmitterPiece>& all() const { return pieces_; }
  [[nodiscard]] bool any_small() const {
    return std::any_of(pieces_.begin(), pieces_.end(), [](const EmitterPiece& p) { return p.is_small; });
  }

 private:
  using Corners = std::array<Eigen::Vector3f, 3>;

  static float pixel_angle(const Camera& camera) {
    const bool panoramas = camera.eyes && camera.eyes->panorama_rows > 0;
    const int x = camera.width_px / 2, y = (panoramas ? camera.eyes->panorama_rows : camera.height_px) / 2;
    return std::max(
        1e-6F,
        (camera.direction_within(x, y, 0.0F, 0.5F) - camera.direction_within(x, y, 1.0F, 0.5F)).norm());
  }

  void add(const SurfaceMesh& mesh) {
    if (!(mesh.emission > 0.0F).any()) return;
    const bool has_texture = mesh.material && mesh.material->emission_texture;
    for (const auto& [a, b, c] : mesh.triangles)
      add({mesh.positions_m[a], mesh.positions_m[b], mesh.positions_m[c]}, has_texture);
  }

  /// Halves long edges of small emitters, so that a ball around a part of a thin tube is not as large as the
  /// tube.
  void add(const Corners& at, bool has_texture) {
    const std::array<float, 3> edges = {(at[1] - at[0]).norm(), (at[2] - at[1]).norm(),
                                        (at[0] - at[2]).norm()};
    const auto longest =
        static_cast<std::size_t>(std::max_element(edges.begin(), edges.end()) - edges.begin());
    const Eigen::Vector3f middle = (at[0] + at[1] + at[2]) / 3.0F;
    const float distance_m = middle.norm();
    const Eigen::Vector3f twice_area = (at[1] - at[0]).cross(at[2] - at[0]);
    if (!(edges[longest] > 0.0F) || !(distance_m > 0.0F)) return;
    const float seen_height_m = std::abs(twice_area.dot(middle)) / (distance_m * edges[longest]);
    const float pixel_m = pixel_rad_ * distance_m;
    const bool is_small = has_texture || seen_height_m < small_px * pixel_m;
    if (is_small && edges[longest] > small_px * pixel_m && pieces_.size() < most_pieces) {
      const std::size_t next = (longest + 1) % 3, across = (longest + 2) % 3;
      const Eigen::Vector3f half = 0.5F * (at[longest] + at[next]);
      add({at[across], at[longest], half}, has_texture);
      add({at[across], half, at[next]}, has_texture);
      return;
    }
    float radius_m = 0;
    for (const Eigen::Vector3f& corner : at) radius_m = std::max(radius_m, (corner - middle).norm());
    pieces_.push_back({middle, radius_m * 1.001F, is_small});
  }

  float pixel_rad_;
  std::vector<EmitterPiece> pieces_;
};

/// A pixel of a picture.
struct PixelPlace {
  int x = 0, y = 0;
};

Eigen::Vector3f seen_direction(const Camera& camera, const PixelPlace& pixel, float x, float y) {
  // The pixel decides which eye looks: a square's right and lower edges belong to it.
  return camera.direction_within(pixel.x, pixel.y, x - static_cast<float>(pixel.x),
                                 y - static_cast<float>(pixel.y));
}

/// Around all directions through squares that lie in the columns of one eye; a full sphere where a lens lets
/// none through.
ViewCone cone_around(const Camera& camera, const PixelPlace& pixel, const PictureSquare& square) {
  ViewCone cone{
      camera.place_m(pixel.x, pixel.y),
      seen_direction(camera, pixel, square.left + 0.5F * square.side_px, square.top + 0.5F * square.side_px),
      0.0F};
  constexpr float everywhere_rad = 4.0F;
  if (!(cone.axis.norm() > 0.5F)) cone.half_rad = everywhere_rad;
  for (const float right : {0.0F, 0.5F, 1.0F})
    for (const float down : {0.0F, 0.5F, 1.0F}) {
      const Eigen::Vector3f corner = seen_direction(camera, pixel, square.left + right * square.side_px,
                                                    square.top + down * square.side_px);
      if (!(corner.norm() > 0.5F)) cone.half_rad = everywhere_rad;
      const float angle_rad = std::atan2(cone.axis.cross(corner).norm(), cone.axis.dot(corner));
      cone.half_rad = std::max(cone.half_rad, 1.05F * angle_rad);
    }
  return cone;
}

using Pieces = std::vector<EmitterPiece>;

Pieces pieces_in(const ViewCone& cone, const Pieces& pieces) {
  Pieces out;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(out),
               [&](const EmitterPiece& piece) { return cone.meets(piece); });
  return out;
}

/// The parts of a pixel that an emitter may cover.
std::vector<PictureSquare> squares_that_meet(const Camera& camera, int x, int y, const Pieces& pieces) {
  std::vector<PictureSquare> squares = {{static_cast<float>(x), static_cast<float>(y), 1.0F}};
  for (int halving = 0; halving < most_halvings && !squares.empty() && squares.size() < most_squares;
       ++halving) {
    std::vector<PictureSquare> smaller;
    for (const PictureSquare& square : squares) {
      const float half_px = 0.5F * square.side_px;
      for (const float top : {square.top, square.top + half_px})
        for (const float left : {square.left, square.left + half_px}) {
          const PictureSquare part{left, top, half_px};
          const ViewCone cone = cone_around(camera, {x, y}, part);
          if (std::any_of(pieces.begin(), pieces.end(),
                          [&](const EmitterPiece& piece) { return cone.meets(piece); }))
            smaller.push_back(part);
        }
    }
    squares = std::move(smaller);
  }
  return squares;
}

/// Emission and area by class, [front][surface] in one row.
struct ClassSums {
  std::size_t classes;
  std::vector<Rgb> emission;
  std::vector<float> area;
  explicit ClassSums(std::size_t count)
      : classes(count), emission(count * count, Rgb::Zero()), area(count * count, 0.0F) {}
};

void look_through(const SceneGeometry& geometry, const Ray& ray, float weight, ClassSums& sums) {
  const std::optional<SurfacePoint> room = geometry.room.nearest(ray);
  std::vector<std::optional<SurfacePoint>> alone(geometry.alone.size());
  if (geometry.objects.nearest(ray))
    for (std::size_t k = 0; k < alone.size(); ++k) alone[k] = geometry.alone[k].nearest(ray);
  const auto nearest_without = [&](int left_out) {
    const SurfacePoint* nearest = room ? &*room : nullptr;
    for (int k = 1; k <= geometry.worlds.object_count; ++k)
      if (const auto& hit = alone[k - 1];
          k != left_out && hit && (nearest == nullptr || hit->distance_m < nearest->distance_m))
        nearest = &*hit;
    return nearest;
  };
  const auto add = [&](int front, const SurfacePoint* surface) {
    if (surface == nullptr) return;
    const std::size_t place =
        static_cast<std::size_t>(front) * sums.classes + static_cast<std::size_t>(surface->object_index);
    sums.emission[place] += weight * surface->emission;
    sums.area[place] += weight;
  };
  const SurfacePoint* front = nearest_without(0);
  if (front == nullptr) return;
  add(front->object_index, front);
  if (front->object_index != 0) add(front->object_index, nearest_without(front->object_index));
}

/// Mean emission of each class over its part of a pixel.
std::vector<Rgb> class_means(const TruthScene& scene, const SceneGeometry& geometry, int x, int y,
                             const Pieces& pieces) {
  const Camera& camera = scene.camera;
  const auto ray_through = [&](float across, float down) {
    return Ray{camera.place_m(x, y), seen_direction(camera, {x, y}, across, down)};
  };
  ClassSums emitted(geometry.worlds.count()), all(geometry.worlds.count());
  for (const PictureSquare& square : squares_that_meet(camera, x, y, pieces)) {
    const float middle = 0.5F * square.side_px;
    const Ray ray = ray_through(square.left + middle, square.top + middle);
    if (ray.direction.norm() > 0.5F) look_through(geometry, ray, square.side_px * square.side_px, emitted);
  }
  for (int i = 0; i < area_side * area_side; ++i) {
    const auto place = [](int step) { return (static_cast<float>(step) + 0.5F) / area_side; };
    const Ray ray = ray_through(static_cast<float>(x) + place(i % area_side),
                                static_cast<float>(y) + place(i / area_side));
    if (ray.direction.norm() > 0.5F) look_through(geometry, ray, 1.0F / (area_side * area_side), all);
  }
  for (std::size_t place = 0; place < emitted.area.size(); ++place)
    if (const float area = std::max(all.area[place], emitted.area[place]); area > 0.0F)
      emitted.emission[place] /= area;
  return emitted.emission;
}

}  // namespace

std::shared_ptr<const SeenEmission> find_seen_emission(const TruthScene& scene, int threads) {
  const EmitterPieces pieces(scene);
  if (!pieces.any_small()) return nullptr;
  const Camera& camera = scene.camera;
  const BlockGrid blocks{camera.width_px, camera.height_px};
  const SceneGeometry geometry(scene);
  std::vector<std::vector<std::pair<std::size_t, std::vector<Rgb>>>> of_blocks(
      static_cast<std::size_t>(blocks.count()));
  parallel_for(blocks.count(), threads, [&](int block) {
    const BlockGrid::Rectangle r = blocks.rectangle(block);
    // Eyes stand side by side, and a block may hold columns of two of them: then each pixel looks at all.
    const bool one_eye =
        !camera.eyes || r.left / camera.eyes->width_px == (r.right - 1) / camera.eyes->width_px;
    const PictureSquare whole{static_cast<float>(r.left), static_cast<float>(r.top),
                              static_cast<float>(BlockGrid::side_px)};
    const Pieces near = one_eye && !camera.directions
                            ? pieces_in(cone_around(camera, {r.left, r.top}, whole), pieces.all())
                            : pieces.all();
    for (int y = r.top; !near.empty() && y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x) {
        const PictureSquare pixel{static_cast<float>(x), static_cast<float>(y), 1.0F};
        const Pieces here = pieces_in(cone_around(camera, {x, y}, pixel), near);
        if (std::any_of(here.begin(), here.end(), [](const EmitterPiece& piece) { return piece.is_small; }))
          of_blocks[block].emplace_back(blocks.index(x, y), class_means(scene, geometry, x, y, here));
      }
  });
  auto seen = std::make_shared<SeenEmission>();
  seen->width_px_ = camera.width_px;
  seen->classes_ = geometry.worlds.count();
  seen->found_.resize(blocks.index(0, camera.height_px));
  for (const auto& of_block : of_blocks)
    for (const auto& [pixel, means] : of_block) {
      seen->means_.insert(seen->means_.end(), means.begin(), means.end());
      seen->found_[pixel] = static_cast<std::uint32_t>(seen->pixels());
    }
  if (seen->means_.empty()) return nullptr;
  return seen;
}

}  // namespace seamline::renderer
