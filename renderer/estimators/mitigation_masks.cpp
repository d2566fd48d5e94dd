#include "renderer/estimators/mitigation_masks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "raytracer/common/parallel.h"
#include "raytracer/common/sampler.h"
#include "raytracer/light/light_sample.h"
#include "renderer/depth/depth_map.h"
#include "renderer/transport/transport.h"
#include "support/arithmetic/colour.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

constexpr std::uint64_t matte_seed = 0x3a77e;
constexpr int samples_a_pixel = 4;  ///< of the local scene's light, which is then smoothed
constexpr int smoothing_px = 4;     ///< to either side
constexpr float shadowed_below = 0.25F, lit_above = 0.75F;  ///< of a sun's light; between them a part of it
constexpr float lit_quantile =
    0.8F;  ///< of what faces a sun around a place, so much is darker than what is lit
constexpr float most_change = 1.6F;  ///< of a place's scale from everywhere's
constexpr int block_px = 16;         ///< scales are found over three by three of them

Eigen::Vector3f texel_direction(const DirectionMask& mask, int column, int row, double right, double down) {
  return panorama_direction(column + right, row + down, mask.width_px, mask.height_px).cast<float>();
}

float texel_rad(const DirectionMask& mask) {
  return std::numbers::pi_v<float> / static_cast<float>(mask.height_px);
}

/// Whether what a ray meets lies before the object, or, where that is not met, before its centre.
bool is_before(const Geometry& world, const MaskedObject& masked, const Eigen::Vector3f& direction) {
  const Ray ray{Eigen::Vector3f::Zero(), direction};
  const auto real = world.nearest(ray);
  if (!real) return false;
  const auto object = masked.object.nearest(ray);
  return real->distance_m < (object ? object->distance_m : masked.centre_m.norm());
}

/// Where a direction falls in the picture, in pixels; outside it where it does not.
Eigen::Array2f picture_place(const Camera& camera, const Eigen::Vector3f& direction) {
  const Eigen::Vector3f local = camera.axes.transpose() * direction;
  if (!(local.z() < 0.0F)) return {-1.0F, -1.0F};
  const float scale = 0.5F * static_cast<float>(camera.width_px) / camera.tan_half_horizontal;
  return {local.x() / -local.z() * scale + 0.5F * static_cast<float>(camera.width_px),
          0.5F * static_cast<float>(camera.height_px) - local.y() / -local.z() * scale};
}

bool is_in_picture(const Camera& camera, const Eigen::Array2f& place, float margin_px) {
  return place[0] >= -margin_px && place[1] >= -margin_px &&
         place[0] < static_cast<float>(camera.width_px) + margin_px &&
         place[1] < static_cast<float>(camera.height_px) + margin_px;
}

/// One number a pixel.
struct Field {
  int width_px = 0, height_px = 0;
  std::vector<float> values;

  Field(int width, int height)
      : width_px(width),
        height_px(height),
        values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F) {}
  [[nodiscard]] std::size_t index(int x, int y) const { return grid_index(y, x, width_px); }
  /// Linear between pixel centres, borders repeated.
  [[nodiscard]] float at(const Eigen::Array2f& place) const {
    const float x = std::clamp(place[0] - 0.5F, 0.0F, static_cast<float>(width_px - 1));
    const float y = std::clamp(place[1] - 0.5F, 0.0F, static_cast<float>(height_px - 1));
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, width_px - 1), bottom = std::min(top + 1, height_px - 1);
    const float u = x - static_cast<float>(left), v = y - static_cast<float>(top);
    return (1 - v) * ((1 - u) * values[index(left, top)] + u * values[index(right, top)]) +
           v * ((1 - u) * values[index(left, bottom)] + u * values[index(right, bottom)]);
  }
};

/// Mean over a square of `radius` pixels to either side, as much of it as lies in the picture.
Field box_mean(const Field& field, int radius) {
  const int width = field.width_px, height = field.height_px;
  const auto stride = static_cast<std::size_t>(width) + 1;
  std::vector<double> sums(stride * (static_cast<std::size_t>(height) + 1), 0.0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = (static_cast<std::size_t>(y) + 1) * stride + static_cast<std::size_t>(x) + 1;
      sums[i] =
          double{field.values[field.index(x, y)]} + sums[i - 1] + sums[i - stride] - sums[i - stride - 1];
    }
  Field out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto left = static_cast<std::size_t>(std::max(0, x - radius)),
                 right = static_cast<std::size_t>(std::min(width, x + radius + 1)),
                 top = static_cast<std::size_t>(std::max(0, y - radius)),
                 bottom = static_cast<std::size_t>(std::min(height, y + radius + 1));
      const double sum = sums[bottom * stride + right] - sums[bottom * stride + left] -
                         sums[top * stride + right] + sums[top * stride + left];
      out.values[out.index(x, y)] =
          static_cast<float>(sum / static_cast<double>((right - left) * (bottom - top)));
    }
  return out;
}

Field product(const Field& a, const Field& b) {
  Field out = a;
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] *= b.values[i];
  return out;
}

/// He, Sun and Tang: in every window `field` becomes a linear function of `guide`.
Field guided(const Field& field, const Field& guide, int radius, float smoothness) {
  const Field mean_field = box_mean(field, radius), mean_guide = box_mean(guide, radius);
  const Field both = box_mean(product(field, guide), radius),
              squares = box_mean(product(guide, guide), radius);
  Field slope = field, offset = field;
  for (std::size_t i = 0; i < field.values.size(); ++i) {
    const float variance = squares.values[i] - mean_guide.values[i] * mean_guide.values[i];
    const float covariance = both.values[i] - mean_guide.values[i] * mean_field.values[i];
    slope.values[i] = covariance / (std::max(variance, 0.0F) + smoothness);
    offset.values[i] = mean_field.values[i] - slope.values[i] * mean_guide.values[i];
  }
  slope = box_mean(slope, radius), offset = box_mean(offset, radius);
  for (std::size_t i = 0; i < field.values.size(); ++i)
    slope.values[i] = slope.values[i] * guide.values[i] + offset.values[i];
  return slope;
}

/// The photograph as it is looked at, against its own bright tenth.
Field display_values(const Image& photograph) {
  Field out(photograph.width_px, photograph.height_px);
  for (int y = 0; y < out.height_px; ++y)
    for (int x = 0; x < out.width_px; ++x) out.values[out.index(x, y)] = photograph.rgb(x, y).mean();
  std::vector<float> sorted = out.values;
  const auto bright = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() * 9 / 10);
  std::nth_element(sorted.begin(), bright, sorted.end());
  const float white = std::max(*bright, 1e-12F);
  for (float& value : out.values) value = srgb_from_linear(std::max(0.0F, value) / white);
  return out;
}

int blocks_across(int pixels) {
  return (pixels + block_px - 1) / block_px;
}

/// None of no values, which it reorders.
std::optional<float> quantile(std::vector<float>& values, float share) {
  if (values.empty()) return std::nullopt;
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<float>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// What the local scene has at one pixel.
struct PixelLight {
  float without_suns = 0, suns = 0;  ///< mean radiance: A, and S where nothing is in the way
  bool lit = false, faces_sun = false;
};

PixelLight light_at(const Geometry& local, const Light& light, const Camera& camera, int x, int y) {
  PixelLight out;
  const auto point = local.nearest(centre_ray(camera, x, y));
  if (!point) return out;
  float arriving = 0;
  for (std::size_t number = 0; number < light.suns.size(); ++number) {
    const Eigen::Vector3f to_sun = direction_to_sun(light.suns[number], Eigen::Array2f::Constant(0.5F));
    const float cosine = sun_cosine(*point, to_sun);
    if (cosine <= 0.0F) continue;
    const float radiance = (point->albedo * light.suns[number].irradiance_w_m2).mean() * inverse_pi * cosine;
    out.suns += radiance;
    if (!local.occluded(leaving_ray(*point, to_sun, endless))) arriving += radiance;
  }
  out.faces_sun = out.suns > 0.0F;
  out.lit = arriving > 0.5F * out.suns;
  for (int sample = 0; sample < samples_a_pixel; ++sample) {
    const Sampler sampler(matte_seed, x, y, sample);
    const Split found = radiance_with_and_without(local, nullptr, *point, light, sampler).without_object;
    float suns = 0;  // of this very sample
    for (std::size_t number = 0; number < light.suns.size(); ++number) {
      const auto sun = light_sample(light, static_cast<int>(number), *point, Rgb::Ones(), sampler, 0,
                                    EmissionHits::unknown);
      if (sun && !local.occluded(leaving_ray(*point, sun->direction, sun->far_m)))
        suns += sun->radiance.mean();
    }
    out.without_suns += (found.total().mean() - suns) / samples_a_pixel;
  }
  return out;
}

}  // namespace

MaskedObject::MaskedObject(const Geometry& virtual_object) : object(virtual_object) {
  Eigen::AlignedBox3f box;
  for (const auto& mesh : object.meshes())
    for (const Eigen::Vector3f& position_m : mesh->positions_m) box.extend(position_m);
  if (box.isEmpty()) return;
  centre_m = box.center();
  radius_m = 0.5F * box.diagonal().norm();
}

bool MaskedObject::may_meet(const Eigen::Vector3f& direction, float margin_rad) const {
  const float distance_m = centre_m.norm();
  if (distance_m <= radius_m) return true;
  const float angle_rad = std::acos(std::clamp(direction.dot(centre_m) / distance_m, -1.0F, 1.0F));
  return angle_rad <= std::asin(radius_m / distance_m) + margin_rad;
}

DirectionMask occlusion_mask(const Geometry& world, const MaskedObject& object, int width_px, int threads) {
  constexpr int side = 4;
  DirectionMask mask = even_mask(width_px, 0.0F);
  parallel_for(mask.height_px, threads, [&](int row) {
    for (int column = 0; column < mask.width_px; ++column) {
      if (!object.may_meet(texel_direction(mask, column, row, 0.5, 0.5), 2 * texel_rad(mask))) continue;
      int before = 0;
      for (int i = 0; i < side * side; ++i)
        before +=
            is_before(world, object,
                      texel_direction(mask, column, row, (i % side + 0.5) / side, (i / side + 0.5) / side))
                ? 1
                : 0;
      mask.texels[mask.index(column, row)] = static_cast<float>(before) / (side * side);
    }
  });
  return mask;
}

ShadowMatte shadow_matte(const Geometry& truth, const Light& light, const Camera& camera, int width_px,
                         int threads) {
  constexpr int side = 3;
  ShadowMatte matte;
  matte.of_suns.assign(light.suns.size(), even_mask(width_px, 0.0F));
  if (matte.of_suns.empty()) return matte;
  for (DirectionMask& mask : matte.of_suns) mask.known.assign(mask.texels.size(), 1);
  const DirectionMask& any = matte.of_suns.front();
  const float margin_px =
      2 * texel_rad(any) * 0.5F * static_cast<float>(camera.width_px) / camera.tan_half_horizontal * 2;
  parallel_for(any.height_px, threads, [&](int row) {
    for (int column = 0; column < any.width_px; ++column) {
      const Eigen::Array2f place = picture_place(camera, texel_direction(any, column, row, 0.5, 0.5));
      if (!is_in_picture(camera, place, margin_px)) continue;
      std::vector<int> asked(light.suns.size(), 0), blocked(light.suns.size(), 0);
      for (int i = 0; i < side * side; ++i) {
        const Ray ray{Eigen::Vector3f::Zero(),
                      texel_direction(any, column, row, (i % side + 0.5) / side, (i / side + 0.5) / side)};
        const auto point = truth.nearest(ray);
        if (!point) continue;
        const Sampler sampler(matte_seed, column, row, i);
        for (std::size_t number = 0; number < light.suns.size(); ++number) {
          const Eigen::Vector3f to_sun =
              direction_to_sun(light.suns[number], light.suns[number].angular_radius_rad > 0.0F
                                                       ? sampler.point(dimension::sun(0))
                                                       : Eigen::Array2f::Zero());
          if (sun_cosine(*point, to_sun) <= 0.0F) continue;
          ++asked[number];
          blocked[number] += truth.occluded(leaving_ray(*point, to_sun, endless)) ? 1 : 0;
        }
      }
      for (std::size_t number = 0; number < light.suns.size(); ++number) {
        DirectionMask& mask = matte.of_suns[number];
        const std::size_t texel = mask.index(column, row);
        mask.known[texel] = asked[number] > 0 ? 1 : 0;
        if (asked[number] > 0)
          mask.texels[texel] = static_cast<float>(blocked[number]) / static_cast<float>(asked[number]);
      }
    }
  });
  return matte;
}

DirectionMask detected_mask(const Geometry& local, const MaskedObject& object, int depth_width_px,
                            int mask_width_px, const DetectedFrom& from) {
  const Camera& camera = from.camera;
  Field before(camera.width_px, camera.height_px);
  parallel_for(camera.height_px, from.threads, [&](int y) {
    for (int x = 0; x < camera.width_px; ++x)
      before.values[before.index(x, y)] =
          is_before(local, object, camera.centre_direction(x, y)) ? 1.0F : 0.0F;
  });
  const float pixels_a_texel = 2 * std::numbers::pi_v<float> / static_cast<float>(depth_width_px) * 0.5F *
                               static_cast<float>(camera.width_px) / camera.tan_half_horizontal;
  const int radius = std::clamp(static_cast<int>(std::lround(1.5F * pixels_a_texel)), 2, 64);
  const Field moved = guided(before, display_values(from.photograph), radius, 1e-4F);
  DirectionMask mask = even_mask(mask_width_px, 0.0F);
  parallel_for(mask.height_px, from.threads, [&](int row) {
    for (int column = 0; column < mask.width_px; ++column) {
      const Eigen::Vector3f direction = texel_direction(mask, column, row, 0.5, 0.5);
      if (!object.may_meet(direction, 2 * texel_rad(mask))) continue;
      const Eigen::Array2f place = picture_place(camera, direction);
      if (is_in_picture(camera, place, 2.0F))
        mask.texels[mask.index(column, row)] = std::clamp(moved.at(place), 0.0F, 1.0F);
    }
  });
  return mask;
}

ShadowMatte detected_matte(const Geometry& local, const Light& light, int matte_width_px,
                           const DetectedFrom& from) {
  const Camera& camera = from.camera;
  ShadowMatte matte;
  if (light.suns.empty()) return matte;
  std::vector<PixelLight> lights(static_cast<std::size_t>(camera.width_px) *
                                 static_cast<std::size_t>(camera.height_px));
  Field shadowless(camera.width_px, camera.height_px);
  parallel_for(camera.height_px, from.threads, [&](int y) {
    for (int x = 0; x < camera.width_px; ++x) {
      const std::size_t i = shadowless.index(x, y);
      lights[i] = light_at(local, light, camera, x, y);
      shadowless.values[i] = lights[i].without_suns;
    }
  });
  shadowless = box_mean(shadowless, smoothing_px);
  const auto photographed = [&](std::size_t i) {
    const float* pixel = &from.photograph.values[3 * i];
    return (pixel[0] + pixel[1] + pixel[2]) / 3;
  };
  // As bright as the local scene, where both are lit.
  const auto usual = [&](std::size_t i) {
    return photographed(i) / std::max(shadowless.values[i] + lights[i].suns, 1e-12F);
  };
  std::vector<float> of_lit;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (lights[i].lit) of_lit.push_back(usual(i));
  const float everywhere = quantile(of_lit, lit_quantile).value_or(1.0F);
  Field scales(blocks_across(camera.width_px), blocks_across(camera.height_px));
  for (int row = 0; row < scales.height_px; ++row)
    for (int column = 0; column < scales.width_px; ++column) {
      std::vector<float> around;
      for (int y = std::max((row - 1) * block_px, 0); y < std::min((row + 2) * block_px, camera.height_px);
           ++y)
        for (int x = std::max((column - 1) * block_px, 0);
             x < std::min((column + 2) * block_px, camera.width_px); ++x)
          if (lights[shadowless.index(x, y)].faces_sun) around.push_back(usual(shadowless.index(x, y)));
      scales.values[scales.index(column, row)] =
          std::clamp(quantile(around, lit_quantile).value_or(everywhere), everywhere / most_change,
                     everywhere * most_change);
    }
  Field shadow(camera.width_px, camera.height_px);
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const std::size_t i = shadow.index(x, y);
      if (!lights[i].faces_sun) continue;
      const Eigen::Array2f block =
          Eigen::Array2f(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) /
          static_cast<float>(block_px);
      const float scale = std::max(scales.at(block), 1e-12F);
      const float seen = (photographed(i) / scale - shadowless.values[i]) / lights[i].suns;
      shadow.values[i] =
          1.0F - std::clamp((seen - shadowed_below) / (lit_above - shadowed_below), 0.0F, 1.0F);
    }
  DirectionMask mask = even_mask(matte_width_px, 0.0F);
  parallel_for(mask.height_px, from.threads, [&](int row) {
    for (int column = 0; column < mask.width_px; ++column) {
      const Eigen::Array2f place = picture_place(camera, texel_direction(mask, column, row, 0.5, 0.5));
      if (is_in_picture(camera, place, 2.0F)) mask.texels[mask.index(column, row)] = shadow.at(place);
    }
  });
  matte.of_suns.assign(light.suns.size(), mask);
  return matte;
}

}  // namespace seamline::renderer
