#pragma once
#include <array>
#include <vector>

#include "raytracer/light/light.h"
#include "renderer/realtime/depth_picture.h"
#include "renderer/realtime/harmonics/occlusion_field.h"

namespace seamline::renderer {

/// Transfers of a rigid object's own surface, itself in its way: the integral of max(n . w, 0) V(w) times
/// each harmonic, at its vertices (at most 20,000 of them, evenly taken), once (Sloan and others 2002; paper
/// 001, section 5.4).
struct VertexTransfers {
  int bands = 4;
  std::vector<Eigen::Vector3f> positions_m, normals;
  std::vector<float> transfers;
  float cell_m = 1;  ///< side of the cells that vertices are found by
  Eigen::Vector3f corner_m = Eigen::Vector3f::Zero();
  std::array<int, 3> cells = {1, 1, 1};
  std::vector<std::uint32_t> starts, members;  ///< of each cell, its vertices
};

/// `rays`: over each vertex' hemisphere.
[[nodiscard]] VertexTransfers sample_transfers(std::span<const TriangleSpan> object,
                                               const AreBlocked& blocked, int bands, int rays, int threads);

/// The transfer at a point of the object: of the vertices about it that face its way, nearer ones more. What
/// no vertex is near to has the unhidden one.
void look_up(const VertexTransfers& transfers, const TransferCache& unhidden, const Eigen::Vector3f& point_m,
             const Eigen::Vector3f& normal, std::span<float> out);

/// What fields ask in place of rays. All of the world's frame.
struct FieldLight {
  std::array<std::vector<float>, 3> light;  ///< l: coefficients of each channel's radiance
  OcclusionField object;                    ///< of the virtual object, for real surfaces around it
  OcclusionField real;                      ///< of the local scene, for the places that the object fills
  VertexTransfers self;                     ///< of the object
  TransferCache unhidden;                   ///< of real surfaces
};

/// Coefficients of all light from infinity: suns, whose radiance is all in one direction, and the
/// environment.
[[nodiscard]] std::array<std::vector<float>, 3> light_harmonics(const Light& light, int bands);

/// What a real surface's light is multiplied with past the virtual object (001, Eq. 5), channel by channel.
[[nodiscard]] Rgb field_shadow(const FieldLight& fields, const Eigen::Vector3f& point_m,
                               const Eigen::Vector3f& normal);

/// Irradiance on the object, past itself and the local scene: <l, t^p times t^q>, not below 0.
[[nodiscard]] Rgb field_irradiance(const FieldLight& fields, const Eigen::Vector3f& point_m,
                                   const Eigen::Vector3f& normal);

}  // namespace seamline::renderer
