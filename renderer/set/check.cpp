#include "renderer/set/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

namespace seamline::renderer {
namespace {

using Measures = std::array<ObjectMeasures, 3>;

constexpr double least_share_of_a_surface = 0.02;  // a sliver of shadow does not count as a surface crossed
constexpr double least_crossing_share = 0.1;

class SceneChecker {
 public:
  explicit SceneChecker(const TruthScene& scene) : scene_(scene), measures_(measure_objects(scene)) {}

  std::vector<RuleResult> check() {
    const auto has = [&](Artifact artifact) {
      const auto& artifacts = scene_.definition.artifacts;
      return std::find(artifacts.begin(), artifacts.end(), artifact) != artifacts.end();
    };
    const bool receiver = has(Artifact::receiver);
    const bool shadow = has(Artifact::shadow) || has(Artifact::overlap);
    if (receiver || shadow) {
      equal("distances equal within 5 %", "m", 1.05, false,
            [](const ObjectMeasures& m) { return m.distance_m; });
      equal("object areas within a factor of 2", "px", 2.0, true,
            [](const ObjectMeasures& m) { return m.visible_px; });
      equal("shadow areas within a factor of 2", "px", 2.0, true,
            [](const ObjectMeasures& m) { return m.shadow_px; });
    }
    if (receiver) shadows_on_surfaces();
    if (shadow) bodies_in_shadow();
    if (has(Artifact::occlusion)) {
      equal("unoccluded areas equal within 5 %", "px", 1.05, false,
            [](const ObjectMeasures& m) { return m.unoccluded_px; });
      each("hidden share 20 to 80 %", false, 0.2, 0.8,
           [](const ObjectMeasures& m) { return 1 - m.visible_px / m.unoccluded_px; });
    }
    each("silhouette perimeter^2 / (4 pi area) at least 4", true, 4.0, 1e9,
         [](const ObjectMeasures& m) { return m.silhouette_complexity; });
    return std::move(results_);
  }

 private:
  using Measure = std::function<double(const ObjectMeasures&)>;

  [[nodiscard]] bool left_out(std::size_t object, bool shape_rule) const {
    return shape_rule && scene_.definition.objects[object].exempt_from_shape_rules;
  }

  void add(const std::string& rule, const std::string& found, bool met) {
    results_.push_back({scene_.definition.name, rule, found, met});
  }

  void equal(const std::string& rule, const char* unit, double largest_ratio, bool shape_rule,
             const Measure& measure) {
    double least = 1e300, most = 0;
    std::string found;
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      if (left_out(i, shape_rule)) continue;
      const double value = measure(measures_[i]);
      least = std::min(least, value);
      most = std::max(most, value);
      found += fmt::format("{} {:.4g} {}, ", measures_[i].name, value, unit);
    }
    add(rule, found + fmt::format("ratio {:.3f}", most / least), least > 0 && most <= largest_ratio * least);
  }

  void each(const std::string& rule, bool shape_rule, double least, double most, const Measure& measure) {
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      if (left_out(i, shape_rule)) continue;
      const double value = measure(measures_[i]);
      add(rule, fmt::format("{} {:.3g}", measures_[i].name, value), value >= least && value <= most);
    }
  }

  void shadows_on_surfaces() {
    for (const ObjectMeasures& object : measures_) {
      int surfaces = 0;
      double largest = 0;
      std::string found = object.name + ":";
      for (const auto& [surface, px] : object.shadow_px_by_surface) {
        const double share = px / object.shadow_px;
        surfaces += share >= least_share_of_a_surface ? 1 : 0;
        largest = std::max(largest, share);
        if (share >= least_share_of_a_surface) found += fmt::format(" {} {:.0f} %", surface, 100 * share);
      }
      add("shadow on at least 3 surfaces, none with over 70 %", found, surfaces >= 3 && largest <= 0.7);
    }
  }

  void bodies_in_shadow() {
    each("sunward body 30 to 70 % in the real shadow", false, 0.3, 0.7,
         [](const ObjectMeasures& m) { return m.in_real_shadow_px / std::max(m.sun_facing_px, 1.0); });
    each("object's shadow crosses the real shadow's edge (10 to 90 % on shadow)", false, least_crossing_share,
         1 - least_crossing_share, [](const ObjectMeasures& m) {
           return m.shadow_on_shadow_px / std::max(m.shadow_px + m.shadow_on_shadow_px, 1.0);
         });
  }

  const TruthScene& scene_;
  Measures measures_;
  std::vector<RuleResult> results_;
};

}  // namespace

std::vector<RuleResult> check_scene(const TruthScene& scene) {
  return SceneChecker(scene).check();
}

}  // namespace seamline::renderer
