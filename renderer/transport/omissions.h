#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/tracing/ray.h"

namespace seamline::renderer {

/// What the fast estimator leaves out because a scene or stimulus does not need it; each can be turned off
/// (`--no-omit NAME`) to see that the picture changes no more than `--explain` says.
struct Omissions {
  bool path_tails = true;       ///< the tail of a path is traced for every 4th sample only
  bool bounce_filter = true;    ///< bounce light is filtered instead of sampled more
  bool ratio_samples = true;    ///< the depth mesh is asked for few samples where the picture allows
  bool untouched_tiles = true;  ///< tiles in which nothing asks the depth mesh are not traced
  bool who_is_in_front = true;  ///< what an object hides is kept only when an artifact asks for it
  bool late_bounces = true;     ///< bounces too dark to matter are not traced
  bool dark_sky = true;         ///< no ray is traced only to find an environment without light
};

struct OmissionName {
  std::string_view name;
  bool Omissions::*on;
};
inline constexpr std::array<OmissionName, 7> omission_names = {
    {{"path_tails", &Omissions::path_tails},
     {"bounce_filter", &Omissions::bounce_filter},
     {"ratio_samples", &Omissions::ratio_samples},
     {"untouched_tiles", &Omissions::untouched_tiles},
     {"who_is_in_front", &Omissions::who_is_in_front},
     {"late_bounces", &Omissions::late_bounces},
     {"dark_sky", &Omissions::dark_sky}}};

/// All omissions but those named. Throws InputError for a name that is none, listing the names.
[[nodiscard]] Omissions omissions_without(const std::vector<std::string>& names);

/// The names of those turned off, for hashes; empty when all are on.
[[nodiscard]] std::string turned_off(const Omissions& omissions);

/// How the blocks of frames of clips came to their samples.
struct FrameBlocks {
  std::int64_t as_in_base = 0;   ///< every path found what it found in the base
  std::int64_t beside_base = 0;  ///< the base and what few samples changed
  std::int64_t anew = 0;         ///< all samples
  std::int64_t rays_spared = 0;  ///< of those that the base has

  [[nodiscard]] std::int64_t count() const { return as_in_base + beside_base + anew; }
  FrameBlocks& operator+=(const FrameBlocks& other) {
    rays_spared += other.rays_spared;
    as_in_base += other.as_in_base;
    beside_base += other.beside_base;
    anew += other.anew;
    return *this;
  }
};

/// What omissions saved in a scene, from counters.
struct Savings {
  RayCounts joint;                    ///< of the pass that all stimuli share
  RayCounts depth;                    ///< of all stimuli's questions to depth meshes
  std::int64_t stimuli = 0;           ///< rendered
  std::int64_t ratio_samples = 0;     ///< samples not asked of the depth mesh
  double ratio_rays = 0;              ///< the same times the rays of one such sample
  std::int64_t untouched_blocks = 0;  ///< not asked, over all stimuli
  std::int64_t untouched_rays = 0;    ///< their camera rays, which is the least they would have cost
  std::int64_t order_bytes = 0;       ///< who is in front on each ray, not kept
  FrameBlocks frames = {};            ///< of the photographs of clips

  [[nodiscard]] RayCounts counts() const { return joint + depth; }
};

}  // namespace seamline::renderer
