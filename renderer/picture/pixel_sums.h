#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "renderer/transport/transport.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// Sums over the sub-pixel samples of one pixel, of radiance in the truth scene, sorted by what the sample
/// shows: uncovered samples (the object does not cover them) with a surface, uncovered samples with sky,
/// covered samples.
struct TruthPixel {
  Rgb sky = Rgb::Zero();         ///< uncovered, sky
  Split without_object;          ///< uncovered, without the object: the background
  Split with_object;             ///< uncovered, with the object: the reference off the object
  Split object;                  ///< covered: the object's own light in the reference
  Rgb behind = Rgb::Zero();      ///< covered: the background behind the object
  float covered = 0;             ///< number of covered samples
  float uncovered_surfaces = 0;  ///< number of uncovered samples with a surface
};

/// What filters are guided by: the surface that the first sample of a pixel saw.
struct Guide {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< zero: sky
  float distance_m = 0;
};

/// Sums are kept in two halves (even and odd samples): their difference estimates the noise.
template <class Sums>
using Halves = std::array<std::vector<Sums>, 2>;

/// The truth scene of one virtual object, rendered once and used by every stimulus with it.
struct TruthSums {
  int width_px = 0, height_px = 0, spp = 0;
  Halves<TruthPixel> halves = {};  ///< row by row
  std::vector<Guide> guides = {};
  std::vector<std::uint8_t> object_ids =
      {};  ///< of the pixel centre in the truth with the object: the click map
  std::int64_t rays = 0;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
  }
};

/// The background (photograph), the reference, and the object's coverage as pictures.
[[nodiscard]] Image background_image(const TruthSums& truth);
[[nodiscard]] Image reference_image(const TruthSums& truth);
/// The reference from one half of the samples.
[[nodiscard]] Image half_reference_image(const TruthSums& truth, std::size_t half);
[[nodiscard]] Image matte_image(const TruthSums& truth);

/// Sums of one pixel of a stimulus: the pixel formula of documentation/developers/design.md, section 2, with
/// what `mask` takes from the reference.
struct StimulusPixel {
  Rgb sky = Rgb::Zero();             ///< background where truth or depth mesh shows sky: its ratio is 1
  Rgb background = Rgb::Zero();      ///< sum_unc B_s elsewhere
  Rgb without_object = Rgb::Zero();  ///< sum_unc L_no
  Rgb with_object = Rgb::Zero();     ///< sum_unc L_with
  Rgb object = Rgb::Zero();          ///< sum_cov L_obj
  Rgb from_reference = Rgb::Zero();  ///< samples that `mask` takes from the reference
  float uncovered_surfaces = 0;  ///< number of samples in `background`, `without_object` and `with_object`

  StimulusPixel& operator+=(const StimulusPixel& other);
};

/// How the change that the object makes in the local scene is put onto the background.
enum class Compositing {
  ratio,    ///< background * with / without (paper Eq. 1)
  additive  ///< background + with - without (Debevec 1998)
};

struct StimulusSums {
  int width_px = 0, height_px = 0, spp = 0;
  Halves<StimulusPixel> halves = {};
  /// `without_object` before a filter, channels averaged: what decides whether depth sheets have sealed a
  /// surface in, because a filter carries light over a well's edge. Empty: nothing is filtered.
  Halves<float> light_as_sampled = {};
  std::vector<Guide> guides = {};  ///< of the surface whose bounce light is in `without_object`
  bool depth_lights_uncovered =
      false;  ///< whether the depth mesh decides how much light `without_object` has
  std::int64_t rays = 0;
  Compositing compositing = Compositing::ratio;  ///< which its picture is of
  bool wraps = false;                            ///< of a panorama: its last column stands beside its first
};

}  // namespace seamline::renderer
