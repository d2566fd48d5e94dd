#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/transport/worlds.h"

namespace seamline::renderer {

/// Which light a constant sky at a path's first surface is counted as. A map's light has edges, which no
/// filter may touch: it is direct light.
enum class FirstSky {
  direct,
  bounce,  ///< it may be filtered with it
  apart    ///< in `PathLight::sky`, so that it may be filtered, and taken away again
};

/// How one path is traced. Its tail is what comes after the sun at its second surface: to save rays without
/// bias only every few samples trace it, and then it counts as many times.
struct PathRules {
  bool has_tail = true;
  float tail_weight = 1.0F;
  FirstSky first_sky = FirstSky::direct;
  bool without_first_suns = false;  ///< another answers what suns do at the first surface
  WorldSet reach_of = 0xFFFF;       ///< worlds by which `PathLight::reach_m` is measured
};
/// Every `tail_every`-th sample of each half has a tail.
[[nodiscard]] inline PathRules path_rules(const Sampler& sampler, int tail_every,
                                          FirstSky first_sky = FirstSky::direct) {
  return {.has_tail = sampler.turn(tail_every) == 0,
          .tail_weight = static_cast<float>(tail_every),
          .first_sky = first_sky};
}

/// Where a path begins.
struct PathStart {
  WorldSet set;  ///< the worlds in which the camera sees the point
  SurfacePoint point;
  Sampler sampler;
  PathRules rules = {};
};

/// What a path found.
struct PathLight {
  /// Radiance that the point sends to the camera, in the worlds that show it. The point's own emission counts
  /// as direct light, so that no filter of bounce light touches it. [world]; lives as long as the batch,
  /// until it begins anew.
  std::span<Split> light = {};
  std::span<Rgb> sky = {};  ///< likewise, of `FirstSky::apart`; empty where no path of the batch has one
  /// How far the first ray got, in those of `PathRules::reach_of` that show the point; infinity: to the sky.
  float reach_m = std::numeric_limits<float>::infinity();
};

/// Many paths through several worlds, one sample each, followed together: at every vertex the rays of all
/// paths to the sun are asked in one call, and so are those on which the paths go on.
class PathBatch {
 public:
  /// Forgets the paths before. Both outlive the batch's use.
  void begin(const Worlds& worlds, const Light& light);
  void add(const PathStart& start) { starts_.push_back(start); }
  [[nodiscard]] std::size_t size() const { return starts_.size(); }
  [[nodiscard]] const PathStart& start(std::size_t i) const { return starts_[i]; }
  /// Follows all paths to their ends; what they found, in the order they were added in. Once after `begin`.
  [[nodiscard]] std::span<const PathLight> trace();
  /// Of all that it has traced since it was made.
  [[nodiscard]] const RayCounts& counts() const { return counts_; }

 private:
  /// A path at one of its surfaces.
  struct Vertex {
    std::size_t path;
    WorldSet set;
    SurfacePoint point;
    Rgb throughput;       ///< from the surface to the camera, without its own albedo
    float spread = 1.0F;  ///< of the lobe by which the path leaves
  };
  enum class As { direct, bounce, sky };
  struct FoundLight {
    As as = As::bounce;
    Rgb radiance = Rgb::Zero();
    Rgb mirrored = Rgb::Zero();
  };
  /// Light that arrives over a ray where nothing is in the way.
  struct Arriving {
    std::size_t path;
    WorldSet set;
    FoundLight light;
  };

  [[nodiscard]] bool ends_at_sky(int vertex) const { return vertex >= light_->bounces && !emits_; }
  void find_points(int dimension);
  [[nodiscard]] bool asks_sun_elsewhere(const Vertex& at, int number, int vertex) const {
    return vertex == 0 && number < static_cast<int>(light_->suns.size()) &&
           starts_[at.path].rules.without_first_suns;
  }
  void add_light_sample(int number, int vertex);
  [[nodiscard]] As sky_of_first(const Vertex& vertex) const;
  [[nodiscard]] Rgb first_suns(const Vertex& vertex, const Eigen::Vector3f& direction) const;
  void add_sky_of_first();
  void thin_tails();
  void go_on(int vertex);
  void meet(const Vertex& from, WorldSet set, const Eigen::Vector3f& direction,
            const std::optional<SurfacePoint>& hit, int vertex);
  [[nodiscard]] FoundLight sorted(std::size_t path, As as, const Rgb& light) const;
  void ask(const Vertex& vertex, const Ray& ray, const FoundLight& light);
  void add_what_arrives(Coherence coherence);
  void add(std::size_t path, WorldSet set, const FoundLight& found);

  const Worlds* worlds_ = nullptr;
  const Light* light_ = nullptr;
  bool emits_ = false;
  bool glossy_ = false;               ///< some surface is: else nothing is mirrored
  bool mirrors_ = false;              ///< some path left a glossy surface first
  std::vector<Rgb> mirrored_shares_;  ///< of each path, then
  RayCounts counts_;
  std::vector<PathStart> starts_;
  std::vector<PathLight> found_;
  std::vector<Split> lights_;  ///< of `found_`, path by path
  std::vector<Rgb> skies_;     ///< likewise
  std::vector<Vertex> vertices_, next_vertices_;
  std::vector<Eigen::Array2f> points_;  ///< of each vertex
  std::vector<Ray> rays_;
  std::vector<Arriving> arriving_;          ///< of each ray
  std::vector<std::size_t> vertex_of_ray_;  ///< of each ray that goes on
  std::vector<std::uint8_t> blocked_;
  std::vector<std::optional<SurfacePoint>> hits_;
};

}  // namespace seamline::renderer
