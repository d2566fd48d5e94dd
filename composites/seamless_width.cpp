#include "composites/seamless_width.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "raytracer/light/light_sample.h"
#include "raytracer/scene/seen_surface.h"
#include "stimuli/definition/methods/no_threshold.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/request_name.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace {

constexpr double least_hidden_share = 0.005;  // less is the objects' own foot on the floor
constexpr int smallest_width_px = 64;         // of the paper's panoramas

InputError no_thresholds(const std::filesystem::path& path, const std::string& field,
                         const std::string& wanted, const std::string& found) {
  return input_error({.file = path.string(), .field = field, .wanted = wanted, .found = found});
}

std::optional<double> number_in(const nlohmann::json& json) {
  return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
}

/// Empty where there is none.
std::string text_in(const nlohmann::json& json, const char* key) {
  const nlohmann::json found = json.value(key, nlohmann::json());
  return found.is_string() ? found.get<std::string>() : std::string();
}

/// The smallest width that was tested.
std::optional<double> smallest_tested(const nlohmann::json& artifact) {
  const auto curve = artifact.find("curve");
  if (curve == artifact.end() || !curve->is_array() || curve->empty() || !curve->front().is_object())
    return std::nullopt;
  return number_in(curve->front().value("width_px", nlohmann::json()));
}

/// Whether every width that was tested suffices, or those from the upper end of the interval.
bool lies_below_levels(NoThreshold reason) {
  return reason == NoThreshold::curve_below || reason == NoThreshold::below_level ||
         reason == NoThreshold::open_easiest;
}

/// Of reports of earlier versions, which have sentences alone: those on which a width hangs.
std::optional<NoThreshold> reason_of_sentence(const std::string& sentence) {
  const auto has = [&](const char* words) { return sentence.find(words) != std::string::npos; };
  if (has("guess floor")) return NoThreshold::guess_floor;
  if (has("easiest to see")) return NoThreshold::open_easiest;
  const bool below = sentence.starts_with("below ") || has("lies below it");
  return below ? std::optional(NoThreshold::curve_below) : std::nullopt;
}

/// Why a threshold has no estimate.
std::optional<NoThreshold> reason_of(const nlohmann::json& threshold) {
  const std::string known = text_in(threshold, "reason_word");
  return known.empty() ? reason_of_sentence(text_in(threshold, "reason")) : no_threshold_from_word(known);
}

/// The thresholds of record of one artifact: an object of them by key.
class RecordedThresholds {
 public:
  RecordedThresholds(const nlohmann::json& artifact, bool joint)
      : artifact_(artifact), found_(joint ? artifact.value("joint", nlohmann::json()) : artifact) {}

  [[nodiscard]] bool has(const char* key) const { return found_.is_object() && found_.contains(key); }
  /// A width, the smallest tested where every one suffices, or none.
  [[nodiscard]] std::optional<double> at(const char* key) const {
    if (!has(key) || !found_[key].is_object()) return std::nullopt;
    const nlohmann::json& threshold = found_[key];
    if (const auto estimate = number_in(threshold.value("estimate", nlohmann::json()))) return estimate;
    const std::optional<NoThreshold> reason = reason_of(threshold);
    if (!reason || !lies_below_levels(*reason)) return std::nullopt;
    std::optional<double> width_px = smallest_tested(artifact_);
    const nlohmann::json interval = threshold.value("ci95", nlohmann::json());
    if (width_px && interval.is_array() && interval.size() == 2)
      width_px = std::max(*width_px, number_in(interval[1]).value_or(0));
    return width_px;
  }
  [[nodiscard]] bool lies_in_guess_floor(const char* key) const {
    return has(key) && found_[key].is_object() && reason_of(found_[key]) == NoThreshold::guess_floor;
  }

 private:
  const nlohmann::json& artifact_;
  const nlohmann::json found_;
};

SeamThresholds thresholds_of(Artifact which, const nlohmann::json& artifact, bool joint) {
  const RecordedThresholds recorded(artifact, joint);
  SeamThresholds out{.artifact = which};
  out.rated = recorded.has("perceptual_threshold_px") || recorded.has("slightly_noticeable_px");
  out.corrected = recorded.lies_in_guess_floor("perceptual_threshold_px");
  out.perceptual_px =
      recorded.at(out.corrected ? "perceptual_threshold_corrected_px" : "perceptual_threshold_px");
  out.slightly_px =
      recorded.at(out.corrected ? "slightly_noticeable_corrected_px" : "slightly_noticeable_px");
  out.detection_px = recorded.at("detection_px");
  return out;
}

void require_condition(const nlohmann::json& json, const std::filesystem::path& path,
                       const std::string& condition) {
  std::string names;
  if (const auto found = json.find("conditions"); found != json.end() && found->is_array())
    for (const nlohmann::json& name : *found) {
      if (!name.is_string()) continue;
      if (name.get<std::string>() == condition) return;
      names += (names.empty() ? "" : ", ") + name.get<std::string>();
    }
  if (names.empty() && condition.empty()) return;
  throw no_thresholds(path, request_name("condition"),
                      names.empty() ? "none: the study has no conditions" : "one of " + names,
                      condition.empty() ? "none" : "\"" + condition + "\"");
}

std::optional<Artifact> artifact_named(const std::string& name) {
  for (const Artifact artifact :
       {Artifact::receiver, Artifact::shadow, Artifact::occlusion, Artifact::overlap})
    if (word(artifact) == name) return artifact;
  return std::nullopt;
}

/// Asks what suns and lamps do at a point: past the objects, and past real things.
struct Shades {
  const PhotoScene& scene;

  template <class Take>
  void each_light(const SurfacePoint& point, const Take& take) const {
    const auto ask = [&](const Eigen::Vector3f& direction, float far_m) {
      if (!above_horizon(point, direction)) return;
      const Ray ray = leaving_ray(point, direction, far_m);
      take(scene.objects.occluded(ray), scene.depth.occluded(ray));
    };
    for (const Sun& sun : scene.light.suns) ask(sun.to_sun, endless);
    for (const Lamp& lamp : scene.light.lamps) {
      const Eigen::Vector3f to_lamp = lamp.position_m - point.position_m;
      if (to_lamp.norm() > 0) ask(to_lamp.normalized(), to_lamp.norm() * 0.9999F);
    }
  }
};

}  // namespace

std::vector<SeamThresholds> paper_thresholds() {
  return {{Artifact::receiver, 426, 116},
          {Artifact::shadow, 206, std::nullopt},
          {Artifact::occlusion, std::nullopt, 1126},
          {Artifact::overlap, std::nullopt, 1596}};
}

StudyThresholds read_thresholds(const std::filesystem::path& path, const std::string& condition) {
  if (!std::filesystem::is_regular_file(path))
    throw no_thresholds(path, "", "the thresholds.json of a report", "no such file");
  const std::string text = read_file(path);
  require_bounded_json(text, path.string());
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("format", "") != "seamline thresholds" || !json.contains("artifacts") ||
      !json["artifacts"].is_array())
    throw no_thresholds(path, "", "the thresholds.json of a report", "another kind of file");
  if (json.contains("level"))
    throw no_thresholds(path, "level", "a study of depth widths", "one of another quantity");
  require_condition(json, path, condition);
  const nlohmann::json simulated = json.value("simulated", nlohmann::json());
  StudyThresholds thresholds{.artifacts = {},
                             .joint = text_in(json, "headline") == "joint",
                             .simulated = simulated.is_boolean() && simulated.get<bool>(),
                             .source = text_in(json, "source")};
  for (const nlohmann::json& artifact : json["artifacts"]) {
    if (!artifact.is_object() || artifact.value("condition", condition) != condition) continue;
    const auto which = artifact_named(artifact.value("artifact", ""));
    if (which) thresholds.artifacts.push_back(thresholds_of(*which, artifact, thresholds.joint));
  }
  if (thresholds.artifacts.empty())
    throw no_thresholds(path, "artifacts", "receiver, shadow, occlusion or overlap", "none of them");
  return thresholds;
}

PresentArtifacts present_artifacts(const PhotoScene& scene, bool masked_occlusion, bool matted_shadow) {
  PresentArtifacts present;
  const Shades shades{scene};
  const bool has_points = !scene.light.suns.empty() || !scene.light.lamps.empty();
  const Camera& camera = scene.camera;
  std::size_t on_object = 0, hidden = 0;
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Ray ray = centre_ray(camera, x, y);
      if (ray.direction.isZero()) continue;
      const auto real = seen_surface(camera, scene.depth, x, y);
      const auto object = scene.objects.nearest(ray);
      on_object += object ? 1 : 0;
      if (object && (!real || object->distance_m < real->distance_m)) {
        shades.each_light(*object, [&](bool by_object, bool by_real) {
          present.shadow = present.shadow || (!by_object && by_real);
        });
        continue;
      }
      hidden += object ? 1 : 0;
      if (!real || !scene.shadows) continue;
      shades.each_light(*real, [&](bool by_object, bool by_real) {
        present.receiver = present.receiver || (by_object && !by_real);
        present.overlap = present.overlap || (by_object && by_real);
      });
    }
  // Light from all around is taken a little of by everything that stands in it.
  const bool around = scene.light.environment != nullptr || (scene.light.environment_radiance > 0.0F).any();
  present.receiver = present.receiver || (scene.shadows && around && on_object > 0);
  if (!has_points && around && scene.light.photographed == nullptr) present.shadow = true;
  present.occlusion =
      !masked_occlusion && static_cast<double>(hidden) > least_hidden_share * static_cast<double>(on_object);
  if (matted_shadow) present.overlap = false;
  return present;
}

SeamlessWidth seamless_width(const PresentArtifacts& present, const std::vector<SeamThresholds>& thresholds) {
  SeamlessWidth out;
  int widest = smallest_width_px;
  bool suffices = true;
  const auto need = [&](Artifact artifact, bool is_present, const std::string& instead) {
    if (!is_present) return;
    WidthNeed& one = out.needs.emplace_back(WidthNeed{artifact, std::nullopt, {}});
    const auto known = std::find_if(thresholds.begin(), thresholds.end(),
                                    [&](const SeamThresholds& t) { return t.artifact == artifact; });
    const auto even = [](double width) { return 2 * static_cast<int>(std::ceil(width / 2)); };
    if (known == thresholds.end()) {
      one.rule = "the study did not show it, so that no width is known" + instead;
    } else if (!known->rated && known->detection_px) {
      one.width_px = even(*known->detection_px);
      one.rule = "detection: fewer than half of the people see it; the study asked for no ratings";
    } else if (!known->rated) {
      one.rule = "no detection threshold: no width that was tested suffices" + instead;
    } else if (known->perceptual_px) {
      one.width_px = even(*known->perceptual_px);
      one.rule = fmt::format("PT{}: not noticed", known->corrected ? " corrected for guesses" : "");
    } else if (known->slightly_px) {
      one.width_px = even(*known->slightly_px);
      one.rule = fmt::format("no PT; SN{} instead: slightly noticeable{}",
                             known->corrected ? " corrected for guesses" : "", instead);
    } else {
      one.rule = fmt::format("neither PT nor SN: no width that was tested suffices{}", instead);
    }
    if (!one.width_px) {
      suffices = false;
      return;
    }
    widest = std::max(widest, *one.width_px);
  };
  need(Artifact::receiver, present.receiver, "");
  need(Artifact::shadow, present.shadow, "");
  need(Artifact::occlusion, present.occlusion,
       "; with " + request_name("occlusion_mask") + " it needs no depth");
  need(Artifact::overlap, present.overlap, "; with " + request_name("shadow_matte") + " it needs no depth");
  if (suffices) out.width_px = widest;
  return out;
}

}  // namespace seamline::renderer
