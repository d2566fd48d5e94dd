#include "sets/check.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>

namespace seamline::renderer {
namespace {

using Measures = std::vector<ObjectMeasures>;

constexpr double least_share_of_a_surface = 0.02;  // a sliver of shadow does not count as a surface crossed
constexpr double least_crossing_share = 0.1;

constexpr const char* equal_distances = "distances equal within 5 %";
constexpr const char* object_areas = "object areas within a factor of 2";
constexpr const char* shadow_areas = "shadow areas within a factor of 2";
constexpr const char* several_surfaces = "shadow on at least 3 surfaces, none with over 70 %";
constexpr const char* half_in_shadow = "sunward body 30 to 70 % in the real shadow";
constexpr const char* crossing_shadow =
    "object's shadow crosses the real shadow's edge (10 to 90 % on shadow)";
constexpr const char* unoccluded_areas = "unoccluded areas equal within 5 %";
constexpr const char* partly_hidden = "hidden share 20 to 80 %";
constexpr const char* rich_silhouette = "silhouette perimeter^2 / (4 pi area) at least 4";

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
      equal(equal_distances, "m", 1.05, false, [](const ObjectMeasures& m) { return m.distance_m; });
      equal(object_areas, "px", 2.0, true, [](const ObjectMeasures& m) { return m.visible_px; });
      equal(shadow_areas, "px", 2.0, true, [](const ObjectMeasures& m) { return m.shadow_px; });
    }
    if (receiver) shadows_on_surfaces();
    if (shadow) bodies_in_shadow();
    if (has(Artifact::occlusion)) {
      equal(unoccluded_areas, "px", 1.05, false, [](const ObjectMeasures& m) { return m.unoccluded_px; });
      each_share(partly_hidden, {0.2, 0.8}, "is not in the picture", [](const ObjectMeasures& m) {
        return Share{m.unoccluded_px - m.visible_px, m.unoccluded_px};
      });
    }
    silhouettes();
    return std::move(results_);
  }

 private:
  using Measure = std::function<double(const ObjectMeasures&)>;
  struct Share {
    double part = 0, of = 0;
  };
  struct Bounds {
    double least = 0, most = 0;
  };

  [[nodiscard]] bool left_out(std::size_t object, bool shape_rule) const {
    return shape_rule && scene_.definition.objects[object].exempt_from_shape_rules;
  }

  [[nodiscard]] bool has_sun() const { return !scene_.light.suns.empty(); }

  void add(const std::string& rule, const std::string& found, bool met) {
    results_.push_back({scene_.definition.name, rule, found, met});
  }

  void equal(const std::string& rule, const char* unit, double largest_ratio, bool shape_rule,
             const Measure& measure) {
    double least = 1e300, most = 0;
    int compared = 0;
    std::string found;
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      if (left_out(i, shape_rule)) continue;
      const double value = measure(measures_[i]);
      least = std::min(least, value);
      most = std::max(most, value);
      found += fmt::format("{} {:.4g} {}, ", measures_[i].name, value, unit);
      ++compared;
    }
    if (compared < 2) return;
    if (least > 0)
      add(rule, found + fmt::format("ratio {:.3f}", most / least), most <= largest_ratio * least);
    else
      add(rule, found + (rule == shadow_areas && !has_sun() ? "there is no sun" : "nothing to compare with"),
          false);
  }

  /// `nothing` says of an object what is the matter where there is nothing to have a share of.
  void each_share(const std::string& rule, const Bounds& wanted, const char* nothing,
                  const std::function<Share(const ObjectMeasures&)>& share_of) {
    for (const ObjectMeasures& object : measures_) {
      const Share share = share_of(object);
      const double value = share.part / share.of;
      if (share.of > 0)
        add(rule, fmt::format("{} {:.3g}", object.name, value),
            value >= wanted.least && value <= wanted.most);
      else
        add(rule, fmt::format("{} {}", object.name, nothing), false);
    }
  }

  void silhouettes() {
    for (std::size_t i = 0; i < measures_.size(); ++i) {
      if (left_out(i, true)) continue;
      const ObjectMeasures& object = measures_[i];
      if (object.unoccluded_px > 0)
        add(rich_silhouette, fmt::format("{} {:.3g}", object.name, object.silhouette_complexity),
            object.silhouette_complexity >= 4);
      else
        add(rich_silhouette, object.name + " is not in the picture", false);
    }
  }

  void shadows_on_surfaces() {
    for (const ObjectMeasures& object : measures_) {
      int surfaces = 0;
      double largest = 0;
      std::string found = object.name + ":";
      for (const auto& [surface, px] : object.shadow_px_by_surface) {
        const double share = px / object.shadow_px;  // there is one
        surfaces += share >= least_share_of_a_surface ? 1 : 0;
        largest = std::max(largest, share);
        if (share >= least_share_of_a_surface)
          found += fmt::format(" {} {:.0f} %", surface.empty() ? "(no name)" : surface, 100 * share);
      }
      if (object.shadow_px_by_surface.empty())
        found =
            object.name + (has_sun() ? " casts no shadow that is seen" : " casts no shadow: there is no sun");
      add(several_surfaces, found, surfaces >= 3 && largest <= 0.7);
    }
  }

  void bodies_in_shadow() {
    each_share(half_in_shadow, {0.3, 0.7}, has_sun() ? "shows no side towards the sun" : "has no sun",
               [](const ObjectMeasures& m) {
                 return Share{m.in_real_shadow_px, m.sun_facing_px};
               });
    each_share(crossing_shadow, {least_crossing_share, 1 - least_crossing_share},
               has_sun() ? "casts no shadow that is seen" : "casts no shadow: there is no sun",
               [](const ObjectMeasures& m) {
                 return Share{m.shadow_on_shadow_px, m.shadow_px + m.shadow_on_shadow_px};
               });
  }

  const TruthScene& scene_;
  Measures measures_;
  std::vector<RuleResult> results_;
};

}  // namespace

std::vector<std::string> scene_rules() {
  return {equal_distances, object_areas,     shadow_areas,  several_surfaces, half_in_shadow,
          crossing_shadow, unoccluded_areas, partly_hidden, rich_silhouette};
}

std::vector<RuleResult> check_scene(const TruthScene& scene) {
  return SceneChecker(scene).check();
}

}  // namespace seamline::renderer
