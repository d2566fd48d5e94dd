#include "raytracer/scene/lit_parts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "raytracer/tracing/surface_point.h"

namespace seamline::renderer {
namespace {

constexpr float little_lit = 0.25F;  ///< of a mesh's area
constexpr int most_cells_a_side = 128;
constexpr double most_cells = 65536;  ///< of a mesh
constexpr int places_a_side = 8;      ///< of a cell that are looked at
constexpr double around = 1.5;        ///< so much larger than the cell
constexpr int dark = -1000;           ///< class of cells without light

/// Barycentric coordinates of the second and third corner.
using Place = Eigen::Vector2d;

/// Texels of the emission's texture along a mesh's longest edge.
double longest_edge_texels(const SurfaceMesh& mesh) {
  const Texture& texture = *mesh.material->emission_texture;
  const auto& uvs = mesh.uvs[texture.uv_set];
  if (uvs.empty()) return 0;
  const Eigen::Array2f size(static_cast<float>(texture.picture->width_px),
                            static_cast<float>(texture.picture->height_px));
  float longest = 0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector2f edge = texture.transform.leftCols<2>() * (uvs[t[(k + 1) % 3]] - uvs[t[k]]);
      longest = std::max(longest, (edge.array() * size).abs().maxCoeff());
    }
  return static_cast<double>(longest);
}

/// A grid over one triangle: cell (column, row), as the triangle stands or turned.
struct Cell {
  std::array<Place, 3> corners;
};
std::vector<Cell> cells_of(int side) {
  std::vector<Cell> cells;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column + row < side; ++column) {
      const auto at = [&](int right, int up) { return Place(Place(column + right, row + up) / side); };
      cells.push_back({{at(0, 0), at(1, 0), at(0, 1)}});
      if (column + row + 1 < side) cells.push_back({{at(1, 1), at(0, 1), at(1, 0)}});
    }
  return cells;
}

/// The class of a cell, by the largest light in it: octaves, or `dark`. Looked at more finely than texels
/// lie, and a little around it, so that no rim of a lit texel is called dark.
int class_of(const SurfaceMesh& mesh, std::uint32_t triangle, const Cell& cell, Rgb& largest) {
  largest = Rgb::Zero();
  const Place middle = (cell.corners[0] + cell.corners[1] + cell.corners[2]) / 3;
  for (int i = 0; i <= places_a_side; ++i)
    for (int j = 0; i + j <= places_a_side; ++j) {
      const Place within = cell.corners[0] + (cell.corners[1] - cell.corners[0]) * i / places_a_side +
                           (cell.corners[2] - cell.corners[0]) * j / places_a_side;
      const Place place = middle + around * (within - middle);
      largest = largest.max(
          emission_at(mesh, triangle, static_cast<float>(place[0]), static_cast<float>(place[1])));
    }
  const float brightest = largest.maxCoeff();
  return brightest > 0.0F ? static_cast<int>(std::floor(std::log2(brightest))) : dark;
}

/// Copies cells into meshes of their own.
class PartMaker {
 public:
  PartMaker(const SurfaceMesh& mesh, bool lit) : from_(mesh), part_(std::make_shared<SurfaceMesh>()) {
    part_->name = mesh.name;
    part_->object_index = mesh.object_index;
    part_->albedo = mesh.albedo;
    part_->f0 = mesh.f0;
    part_->alpha = mesh.alpha;
    part_->f90 = mesh.f90;
    part_->material = mesh.material;
    if (lit) return;
    auto material = std::make_shared<Material>(*mesh.material);
    material->emission = Rgb::Zero();
    material->emission_texture.reset();
    part_->material = std::move(material);
  }

  void add(std::uint32_t triangle, const Cell& cell, const Rgb& largest) {
    const Triangle& t = from_.triangles[triangle];
    const auto first = static_cast<std::uint32_t>(part_->positions_m.size());
    for (const Place& place : cell.corners) {
      const auto between = [&](const auto& values) {
        using Value = std::decay_t<decltype(values[0])>;
        return Value((values[t[0]].template cast<double>() * (1 - place[0] - place[1]) +
                      values[t[1]].template cast<double>() * place[0] +
                      values[t[2]].template cast<double>() * place[1])
                         .template cast<float>());
      };
      part_->positions_m.push_back(between(from_.positions_m));
      if (!from_.normals.empty()) part_->normals.push_back(between(from_.normals).normalized());
      for (std::size_t set = 0; set < part_->uvs.size(); ++set)
        if (!from_.uvs[set].empty()) part_->uvs[set].push_back(between(from_.uvs[set]));
      if (!from_.tangents.empty()) part_->tangents.push_back(between(from_.tangents));
      if (!from_.colours.empty()) part_->colours.push_back(between(from_.colours));
    }
    part_->triangles.push_back({first, first + 1, first + 2});
    part_->emission = part_->emission.max(largest);
  }

  [[nodiscard]] std::shared_ptr<const SurfaceMesh> part() { return part_; }

 private:
  const SurfaceMesh& from_;
  std::shared_ptr<SurfaceMesh> part_;
};

/// The parts of a mesh; empty where it stays whole.
std::vector<std::shared_ptr<const SurfaceMesh>> lit_parts(const SurfaceMesh& mesh) {
  if (!mesh.material || !mesh.material->emission_texture || !(mesh.emission > 0.0F).any()) return {};
  const double texels = longest_edge_texels(mesh), triangles = static_cast<double>(mesh.triangles.size());
  const double most = std::min<double>(most_cells_a_side, std::sqrt(most_cells / std::max(1.0, triangles)));
  const int side = static_cast<int>(std::min(std::ceil(texels), std::floor(most)));
  if (side < 2 || texels > 0.5 * places_a_side * side) return {};  // or a lit texel might be overlooked
  const std::vector<Cell> cells = cells_of(side);
  std::map<int, PartMaker> parts;
  double lit_m2 = 0, all_m2 = 0;
  for (std::uint32_t t = 0; t < static_cast<std::uint32_t>(mesh.triangles.size()); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Eigen::Vector3f along = mesh.positions_m[b] - mesh.positions_m[a],
                          across = mesh.positions_m[c] - mesh.positions_m[a];
    const double cell_m2 =
        static_cast<double>(along.cross(across).norm()) / (2.0 * static_cast<double>(cells.size()));
    for (const Cell& cell : cells) {
      Rgb largest;
      const int of = class_of(mesh, t, cell, largest);
      all_m2 += cell_m2;
      lit_m2 += of == dark ? 0 : cell_m2;
      parts.try_emplace(of, mesh, of != dark).first->second.add(t, cell, largest);
    }
  }
  std::vector<std::shared_ptr<const SurfaceMesh>> out;
  if (lit_m2 > static_cast<double>(little_lit) * all_m2) return out;
  for (auto& [of, maker] : parts) out.push_back(maker.part());
  return out;
}

}  // namespace

void cut_where_lit(std::vector<std::shared_ptr<const SurfaceMesh>>& meshes) {
  std::vector<std::shared_ptr<const SurfaceMesh>> cut;
  for (const auto& mesh : meshes) {
    const auto parts = lit_parts(*mesh);
    if (parts.empty())
      cut.push_back(mesh);
    else
      cut.insert(cut.end(), parts.begin(), parts.end());
  }
  meshes = std::move(cut);
}

}  // namespace seamline::renderer
