#include "renderer/set/render_plan.h"

#include <fmt/core.h>

#include <algorithm>

#include "renderer/scene/truth_scene.h"

namespace seamline::renderer {
namespace {

constexpr const char* no_change = "none";
constexpr const char* noise_only = "within the estimated errors (no bias)";

/// Decides for one scene.
class ScenePlanner {
 public:
  ScenePlanner(const StudyDefinition& study, const SceneDefinition& scene, const LightFacts& light,
               const RenderSettings& settings)
      : study_(study), scene_(scene), light_(light), settings_(settings) {
    limit_ = needed_bounces(light, scene.exposure_ev, settings.error);
    plan_ = {.scene = scene.name, .light = light, .bounces = light.bounces};
    for (const Artifact artifact : scene.artifacts)
      plan_.answers.push_back({artifact, recipe(artifact, study.isolation)});
  }

  ScenePlan plan() {
    shared_truth();
    one_mesh();
    path_tails();
    bounce_filter();
    ratio_samples();
    untouched_tiles();
    who_is_in_front();
    late_bounces();
    dark_sky();
    return std::move(plan_);
  }

 private:
  void always(const char* name, std::string why, std::string saves) {
    plan_.omissions.push_back({name, scene_.name, std::move(why), std::move(saves), no_change, true});
  }

  /// An omission with a switch; `needed_because` says why it is not made here, when it is not.
  bool omit(const PlannedOmission& what, const std::string& needed_because) {
    const auto* known = std::find_if(omission_names.begin(), omission_names.end(),
                                     [&](const OmissionName& one) { return one.name == what.name; });
    std::string why_not = needed_because;
    if (settings_.estimator == Estimator::path) why_not = "the path estimator leaves nothing out";
    if (why_not.empty() && !(settings_.omit.*known->on)) why_not = "turned off";
    if (!why_not.empty()) {
      plan_.not_omitted.push_back({what.name, why_not});
      return false;
    }
    plan_.omissions.push_back(what);
    plan_.omissions.back().where = scene_.name;
    return true;
  }

  template <class Asks>
  [[nodiscard]] bool any(Asks asks) const {
    return std::any_of(plan_.answers.begin(), plan_.answers.end(),
                       [&](const PlannedAnswers& one) { return asks(one.recipe); });
  }
  [[nodiscard]] bool bounces() const { return light_.bounces > 0 || light_.emits; }

  void shared_truth() {
    const std::size_t stimuli =
        scene_.objects.size() * study_.depth_width_px.size() * scene_.artifacts.size();
    const std::size_t done = settings_.estimator == Estimator::fast ? 1 : scene_.objects.size() + 1;
    if (stimuli + 1 > done)
      always("shared_truth",
             "no stimulus changes the photograph, and the backgrounds differ from the reference only where "
             "light meets an object",
             fmt::format("{} of {} passes over the picture", stimuli + 1 - done, stimuli + 1));
    if (bounces() && any([](const Recipe& r) { return r.answers.bounce == Who::truth; }))
      always("truth_bounces", "the truth answers for bounce light, and it has no width",
             "bounce light of the depth mesh");
  }

  void one_mesh() {
    const std::size_t widths = scene_.objects.size() * study_.depth_width_px.size();
    const auto asking = static_cast<std::size_t>(
        std::count_if(plan_.answers.begin(), plan_.answers.end(),
                      [](const PlannedAnswers& one) { return one.recipe.answers.needs_depth(); }));
    if (asking > 1)
      always("one_mesh", "all artifacts of an object and width ask the same depth mesh",
             fmt::format("{} of {} depth meshes", (asking - 1) * widths, asking * widths));
  }

  void path_tails() {
    omit({.name = "path_tails",
          .why =
              "what follows the sun at a path's second surface is faint, so every 4th sample stands for four",
          .saves = "3 of 4 path tails",
          .change = noise_only},
         light_.bounces > 0 ? "" : "paths end before a tail begins");
  }

  void bounce_filter() {
    const bool ratio = any([](const Recipe& r) { return asks_depth_for_rest(r.answers); });
    omit({.name = "bounce_filter",
          .why = bounces() ? "bounce light changes slowly along a surface, so neighbouring pixels share it"
                           : "sky light that only decides a ratio changes slowly, so pixels share it",
          .saves = "samples that would average the same noise",
          .change = "within the estimated errors (noise and bias)"},
         bounces() || ratio ? "" : "there is no bounce light to filter");
  }

  void ratio_samples() {
    const bool lights = any([](const Recipe& r) { return r.answers.asks_depth_for_light(); });
    std::string needed;
    if (!settings_.error) needed = "the number of samples is given";
    if (!lights) needed = "no artifact asks the depth mesh for light";
    omit({.name = "ratio_samples",
          .why =
              "with and without the object are nearly the same light, and so are truth and depth mesh on the "
              "object: ratio and difference need fewer samples than the photograph",
          .saves = "most questions to the depth mesh",
          .change = noise_only},
         needed);
  }

  void untouched_tiles() {
    const bool somewhere =
        any([](const Recipe& r) { return r.keep == Keep::object_layer || !asks_depth_for_rest(r.answers); });
    omit({.name = "untouched_tiles",
          .why = "the depth mesh is asked about the object only, so tiles without it need no answer",
          .saves = "blocks of 16 x 16 px where nothing asks it for light",
          .change = no_change},
         somewhere ? "" : "an artifact's light may differ in every tile");
  }

  void who_is_in_front() {
    omit({.name = "who_is_in_front",
          .why = "the truth decides what hides the object, so what lies behind it is not kept",
          .saves = "a byte a sample in the object's tiles",
          .change = no_change},
         any([](const Recipe& r) { return r.answers.occlusion == Who::depth; })
             ? "the depth mesh decides what hides the object"
             : "");
  }

  void late_bounces() {
    std::string needed;
    if (limit_.bounces == light_.bounces)
      needed = light_.emits          ? "surfaces emit light, which bounds no bounce"
               : light_.bounces == 0 ? "there are no bounces"
                                     : fmt::format("all {} bounces may matter", light_.bounces);
    if (omit(
            {.name = "late_bounces",
             .why = fmt::format("surfaces reflect at most {:.2f} of the light, so later bounces are too dark",
                                light_.brightest_albedo),
             .saves = fmt::format("{} of {} bounces", light_.bounces - limit_.bounces, light_.bounces),
             .change = fmt::format("at most {:.1e} of the display range", limit_.change)},
            needed))
      plan_.bounces = limit_.bounces;
  }

  void dark_sky() {
    omit({.name = "dark_sky",
          .why = "the environment has no light, so no ray is traced only to reach it",
          .saves = "the last ray of each path",
          .change = no_change},
         light_.sky_is_dark ? "" : "the sky shines");
  }

  const StudyDefinition& study_;
  const SceneDefinition& scene_;
  const LightFacts& light_;
  const RenderSettings& settings_;
  BounceLimit limit_;
  ScenePlan plan_;
};

}  // namespace

RenderPlan render_plan(const StudyDefinition& study, const std::map<std::string, LightFacts>& lights,
                       const RenderSettings& settings) {
  RenderPlan plan{.settings = settings, .isolation = study.isolation, .scenes = {}};
  for (const SceneDefinition& scene : study.scenes)
    if (const auto light = lights.find(scene.name); light != lights.end())
      plan.scenes.push_back(ScenePlanner(study, scene, light->second, settings).plan());
  return plan;
}

std::map<std::string, LightFacts> lights_of(const StudyDefinition& study) {
  std::map<std::string, LightFacts> lights;
  for (const SceneDefinition& scene : study.scenes)
    lights.emplace(scene.name, light_facts(load_truth_scene(scene, study.width_px, study.height_px)));
  return lights;
}

std::vector<std::string> sentences(const RenderPlan& plan) {
  std::vector<std::string> out = {
      "textures: materials are diffuse base colours",
      "environment sampling: the environment is constant, so cosine-weighted rays sample it exactly"};
  for (const ScenePlan& scene : plan.scenes)
    for (const PlannedOmission& one : scene.omissions)
      out.push_back(fmt::format("{}: {}: {}; saves {}; change of the picture: {}", one.where, one.name,
                                one.why, one.saves, one.change));
  return out;
}

}  // namespace seamline::renderer
