#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "renderer/realtime/depth_picture.h"

namespace seamline::renderer {

/// Normals of what a picture shows, one a pixel: unit and towards the camera; zero where it shows nothing.
struct NormalPicture {
  int width_px = 0, height_px = 0;
  std::vector<Eigen::Vector3f> normals;

  [[nodiscard]] const Eigen::Vector3f& at(int x, int y) const {
    return normals[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                   static_cast<std::size_t>(x)];
  }
};

/// Normals out of a camera's picture of depth at the origin (paper 001, section 5.2): of each pixel's four
/// pairs of neighbours, right and below, below and left, left and above, above and right, the cross products
/// of what lies between them and the pixel, added up. Pairs with a pixel that shows nothing are left out.
[[nodiscard]] NormalPicture cross_product_normals(const DepthPicture& depth, const DrawView& view,
                                                  int threads);

/// The same of one pixel.
[[nodiscard]] Eigen::Vector3f cross_product_normal(const DepthPicture& depth, const DrawView& view, int x,
                                                   int y);

/// Normals of vertices as paper 000 (section 4.2) has them: zero first, each triangle's unit normal added to
/// its three vertices, then of unit length. Zero where a vertex has no triangle with an area.
[[nodiscard]] std::vector<Eigen::Vector3f> triangle_mean_normals(const TriangleSpan& mesh);

/// What a picture shows of normals of vertices, linear over each triangle (Gouraud's interpolation, with
/// depth taken into account), where its triangle is the nearest.
[[nodiscard]] NormalPicture draw_normals(const DrawView& view, const TriangleSpan& mesh,
                                         std::span<const Eigen::Vector3f> vertex_normals,
                                         const DepthPicture& depth);

}  // namespace seamline::renderer
