#pragma once
#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "raytracer/tracing/ray.h"
#include "renderer/realtime/harmonics/triple_products.h"

namespace seamline::renderer {

/// Where a field is sampled: on spheres around a centre, each at the crossings of its circles of latitude
/// (poles included) and longitude. Sparse: what lies between is interpolated.
struct FieldShape {
  Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();
  std::vector<float> radii_m;  ///< rising
  int latitudes = 17, longitudes = 32;
  int bands = 4;

  [[nodiscard]] std::size_t samples() const {
    return radii_m.size() * static_cast<std::size_t>(latitudes) * static_cast<std::size_t>(longitudes);
  }
};

/// Object occlusion field (Zhou and others 2005; paper 001, section 5.4): of each sample q the coefficients
/// of how much is seen past something in each direction, t^q: 1 where nothing is in the way, 0 where
/// something is. In one frame, the world's, like everything they are multiplied with.
struct OcclusionField {
  FieldShape shape;
  std::vector<float> visibility;  ///< by shell, latitude, longitude, coefficient
};

/// Whether something lies on each of many rays.
using AreBlocked = std::function<void(std::span<const Ray> rays, std::span<std::uint8_t> blocked)>;

/// Samples a field by `rays` rays at each place, even over the directions in which things can be: all, or,
/// with `things_radius_m` above 0, for places outside that sphere around the centre the cone that it fills.
[[nodiscard]] OcclusionField sample_field(const FieldShape& shape, const AreBlocked& blocked,
                                          float things_radius_m, int rays, int threads);

/// Coefficients at a place, between the samples: linear in latitude, longitude and the radius' logarithm.
/// Inside the first shell they are that shell's. False beyond the last shell, where the field knows nothing
/// and nothing is in the way; `out` is then left as it is.
[[nodiscard]] bool look_up(const OcclusionField& field, const Eigen::Vector3f& place_m, std::span<float> out);

/// Rising radii from the first to the last, in equal ratios; one shell is the geometric middle.
[[nodiscard]] std::vector<float> shell_radii(float first_m, float last_m, int shells);

/// t^p of diffuse surfaces that nothing hides anything from, max(n . w, 0), for normals in a table by
/// latitude and longitude (001, section 5.4), linear between them.
class TransferCache {
 public:
  explicit TransferCache(int bands, int latitudes = 65);
  void look_up(const Eigen::Vector3f& normal, std::span<float> out) const;

 private:
  int bands_, latitudes_, longitudes_;
  std::vector<float> transfers_;
};

/// What of light with coefficients l reaches a surface of transfer t^p past what t^q leaves visible, over
/// what reaches it without: <l, t> / <l, t^p>, t = t^p times t^q (001, Eq. 5), between 0 and 1; 1 where
/// nothing reaches it anyway. `light` and both transfers are as long as the table's bands have coefficients.
[[nodiscard]] float field_attenuation(const TripleTable& table, std::span<const float> light,
                                      std::span<const float> transfer, std::span<const float> visibility);

}  // namespace seamline::renderer
