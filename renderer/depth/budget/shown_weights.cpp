#include "renderer/depth/budget/shown_weights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "renderer/depth/depth_map.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

using RoleShares = std::array<float, depth_roles>;

constexpr int weights_width_px = 1024, weights_height_px = weights_width_px / 2;
constexpr int weights_margin_texels = 3;
/// Of the object's and the surfaces' hiding of the sky: it darkens softly, without an edge.
constexpr float sky_role_share = 0.3F;

float& role_share(RoleShares& shares, DepthRole role) {
  return shares[static_cast<std::size_t>(role)];
}

/// The sphere around the object's bounding box.
struct ObjectBall {
  Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();
  float radius_m = 0;

  explicit ObjectBall(const Geometry& object) {
    Eigen::AlignedBox3f box;
    for (const auto& mesh : object.meshes())
      for (const Eigen::Vector3f& position_m : mesh->positions_m) box.extend(position_m);
    if (box.isEmpty()) return;
    centre_m = box.center();
    radius_m = 0.5F * box.diagonal().norm();
  }
};

/// With a degree around it, as of everything that is found.
bool is_in_photograph(const Camera& camera, const Eigen::Vector3f& direction) {
  if (camera.directions || camera.eyes) return true;
  const Eigen::Vector3f seen = camera.axes.transpose() * direction;
  if (!(seen.z() < 0)) return false;
  constexpr float margin = 1.03F;
  const float wide = camera.tan_half_horizontal * margin,
              high = wide * static_cast<float>(camera.height_px) / static_cast<float>(camera.width_px);
  return std::abs(seen.x()) <= -seen.z() * wide && std::abs(seen.y()) <= -seen.z() * high;
}

/// What is asked of one direction.
class AskedDirection {
 public:
  explicit AskedDirection(const ShownScene& scene) : scene_(scene), ball_(scene.object) {}

  [[nodiscard]] RoleShares at(const Eigen::Vector3f& direction) const {
    RoleShares shares{};
    if (ball_.radius_m == 0) return shares;
    const Ray view{Eigen::Vector3f::Zero(), direction};
    if (scene_.object.occluded(view)) role_share(shares, DepthRole::occluder) = 1;
    const auto hit = scene_.truth.nearest(view);
    if (!hit) return shares;
    const bool seen = is_in_photograph(scene_.photograph, direction);
    for (const Sun& sun : scene_.light.suns) add_line(hit->position_m, sun.to_sun, endless, seen, shares);
    for (const Lamp& lamp : scene_.light.lamps) {
      const Eigen::Vector3f to_lamp = lamp.position_m - hit->position_m;
      add_line(hit->position_m, to_lamp.normalized(), to_lamp.norm(), seen, shares);
    }
    add_sky(hit->position_m, seen, shares);
    return shares;
  }

 private:
  /// The line through a surface to a light: the object may be before the surface or behind it.
  void add_line(const Eigen::Vector3f& at_m, const Eigen::Vector3f& to_light, float far_m, bool seen,
                RoleShares& shares) const {
    if (seen && meets(at_m, to_light, far_m)) role_share(shares, DepthRole::receiver) = 1;
    if (meets(at_m, -to_light, endless)) role_share(shares, DepthRole::blocker) = 1;
  }

  [[nodiscard]] bool meets(const Eigen::Vector3f& from_m, const Eigen::Vector3f& direction,
                           float far_m) const {
    const Eigen::Vector3f to_centre = ball_.centre_m - from_m;
    const float along = to_centre.dot(direction);
    if ((to_centre - along * direction).norm() > ball_.radius_m || along < -ball_.radius_m) return false;
    return scene_.object.occluded({from_m, direction, far_m});
  }

  void add_sky(const Eigen::Vector3f& at_m, bool seen, RoleShares& shares) const {
    const float distance_m = (at_m - ball_.centre_m).norm();
    if (distance_m - ball_.radius_m > scene_.light.sky_distance_m) return;
    const float filled = std::min(1.0F, ball_.radius_m / std::max(distance_m, 1e-6F));
    const float weight = sky_role_share * filled * filled;
    for (const DepthRole role : {DepthRole::receiver, DepthRole::blocker})
      if (seen || role == DepthRole::blocker)
        role_share(shares, role) = std::max(role_share(shares, role), weight);
  }

  const ShownScene& scene_;
  ObjectBall ball_;
};

std::size_t weights_texel(int column, int row) {
  return static_cast<std::size_t>(row) * weights_width_px +
         static_cast<std::size_t>((column + weights_width_px) % weights_width_px);
}

/// The largest of the texels around, along the rows or the columns.
std::vector<RoleShares> spread_weights(const std::vector<RoleShares>& texels, bool along_rows, int threads) {
  std::vector<RoleShares> out(texels.size());
  run_parallel(weights_height_px, threads, [&](int row) {
    for (int column = 0; column < weights_width_px; ++column)
      for (int i = -weights_margin_texels; i <= weights_margin_texels; ++i) {
        const RoleShares& other =
            along_rows ? texels[weights_texel(column + i, row)]
                       : texels[weights_texel(column, std::clamp(row + i, 0, weights_height_px - 1))];
        RoleShares& here = out[weights_texel(column, row)];
        for (std::size_t role = 0; role < depth_roles; ++role) here[role] = std::max(here[role], other[role]);
      }
  });
  return out;
}

}  // namespace

double share_seen(DepthRole role, double width_px) {
  constexpr double scale_octaves = 0.5;
  return 1 / (1 + std::pow(width_px / role_threshold_px[static_cast<std::size_t>(role)],
                           1 / (scale_octaves * std::log(2.0))));
}

ShownWeights where_it_shows(const ShownScene& scene) {
  const AskedDirection asked(scene);
  ShownWeights weights{.width_px = weights_width_px, .height_px = weights_height_px, .texels = {}};
  weights.texels.resize(std::size_t{weights_width_px} * weights_height_px);
  run_parallel(weights_height_px, scene.threads, [&](int row) {
    for (int column = 0; column < weights_width_px; ++column)
      weights.texels[weights_texel(column, row)] =
          asked.at(panorama_direction(column + 0.5, row + 0.5, weights_width_px, weights_height_px)
                       .cast<float>()
                       .normalized());
  });
  weights.texels = spread_weights(spread_weights(weights.texels, true, scene.threads), false, scene.threads);
  return weights;
}

bool nothing_shows(const ShownWeights& weights) {
  return std::all_of(weights.texels.begin(), weights.texels.end(),
                     [](const RoleShares& shares) { return shares == RoleShares{}; });
}

}  // namespace seamline::renderer
