#include "scenes/shapes/hull.h"

#include <cmath>
#include <numbers>

#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace {

using Vector3d = Eigen::Vector3d;
using std::numbers::pi;

constexpr std::size_t steps_around = 48;
constexpr double roundness = 0.55;  ///< 1: ellipses, towards 0: rectangles

double bent(double value) {
  return std::copysign(std::pow(std::abs(value), roundness), value);
}

Vector3d place_on(const HullSection& section, std::size_t step) {
  const double angle = 2 * pi * (static_cast<double>(step) + 0.5) / static_cast<double>(steps_around);
  const double half_m = (section.high_m - section.low_m) / 2;
  return {section.x_m, section.low_m + half_m * (1 + bent(std::sin(angle))),
          section.half_width_m * bent(std::cos(angle))};
}

/// One end: a fan about the middle.
void close(TriangleMesh& mesh, const HullSection& section, double facing) {
  const Vector3d middle(section.x_m, (section.low_m + section.high_m) / 2, 0);
  for (std::size_t step = 0; step < steps_around; ++step) {
    const Vector3d a = place_on(section, step), b = place_on(section, (step + 1) % steps_around);
    append(mesh, facing > 0 ? polygon({middle, b, a}) : polygon({middle, a, b}));
  }
}

Eigen::Vector4d as_vector(const HullSection& section) {
  return {section.x_m, section.half_width_m, section.low_m, section.high_m};
}

}  // namespace

std::vector<HullSection> smooth_sections(const std::vector<HullSection>& keys, int steps) {
  std::vector<HullSection> sections;
  const auto key = [&](std::size_t i) { return as_vector(keys[std::min(i, keys.size() - 1)]); };
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const Eigen::Vector4d before = key(i == 0 ? 0 : i - 1), from = key(i), to = key(i + 1),
                          after = key(i + 2);
    for (int step = 0; step < steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      const Eigen::Vector4d at =
          0.5 * (2 * from + t * (to - before) + t * t * (2 * before - 5 * from + 4 * to - after) +
                 t * t * t * (3 * from - before - 3 * to + after));
      sections.push_back({at[0], at[1], at[2], at[3]});
    }
  }
  sections.push_back(keys.back());
  return sections;
}

TriangleMesh hull(const std::vector<HullSection>& sections) {
  TriangleMesh mesh;
  for (const HullSection& section : sections)
    for (std::size_t step = 0; step < steps_around; ++step)
      mesh.positions_m.push_back(place_on(section, step));
  mesh.normals.assign(mesh.positions_m.size(), Vector3d::Zero());
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto& p = mesh.positions_m;
    const Vector3d twice_area = (p[b] - p[a]).cross(p[c] - p[a]);
    for (const std::size_t corner : {a, b, c}) mesh.normals[corner] += twice_area;
    mesh.triangles.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  };
  for (std::size_t ring = 0; ring + 1 < sections.size(); ++ring)
    for (std::size_t step = 0; step < steps_around; ++step) {
      const std::size_t a = ring * steps_around + step, b = ring * steps_around + (step + 1) % steps_around;
      add(a, a + steps_around, b + steps_around);
      add(a, b + steps_around, b);
    }
  for (Vector3d& normal : mesh.normals) normal.normalize();
  close(mesh, sections.front(), -1);
  close(mesh, sections.back(), 1);
  return mesh;
}

std::pair<TriangleMesh, TriangleMesh> parted_hull(const std::vector<HullSection>& sections,
                                                  const std::function<bool(double, double)>& wanted) {
  const TriangleMesh whole = hull(sections);
  std::pair<TriangleMesh, TriangleMesh> parts;
  for (std::size_t i = 0; i < whole.triangles.size(); ++i) {
    const std::size_t ring = i / (2 * steps_around), step = i / 2 % steps_around;
    bool first_part = false;
    if (ring + 1 < sections.size()) {
      const double angle = 2 * pi * (static_cast<double>(step) + 1) / static_cast<double>(steps_around);
      first_part = wanted((sections[ring].x_m + sections[ring + 1].x_m) / 2, std::asin(std::sin(angle)));
    }
    TriangleMesh& part = first_part ? parts.first : parts.second;
    const auto first = static_cast<std::uint32_t>(part.positions_m.size());
    for (const std::uint32_t corner : whole.triangles[i]) {
      part.positions_m.push_back(whole.positions_m[corner]);
      part.normals.push_back(whole.normals[corner]);
    }
    part.triangles.push_back({first, first + 1, first + 2});
  }
  return parts;
}

}  // namespace seamline::scenes
