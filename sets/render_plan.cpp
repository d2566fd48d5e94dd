#include "sets/render_plan.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "raytracer/scene/truth_scene.h"
#include "renderer/estimators/mesh_albedo.h"
#include "sets/set_work.h"

namespace seamline::renderer {
namespace {

constexpr const char* no_change = "none";
constexpr const char* noise_only = "within the estimated errors (no bias)";

std::string in_words(int number) {
  constexpr std::array<const char*, 5> words = {"none", "one", "two", "three", "four"};
  const std::size_t n = number;
  return n < words.size() ? words[n] : std::to_string(number);
}

/// Says of one scene what its estimator's choices leave out.
class ScenePlanner {
 public:
  ScenePlanner(const std::vector<Stimulus>& stimuli, const SceneDefinition& scene, const LightFacts& light,
               const RenderSettings& settings)
      : scene_(scene),
        options_(estimate_options(stimuli, settings, 1)),
        light_(with_mesh_albedo(light, options_)),
        settings_(settings) {
    plan_ = {.scene = truth_of(scene), .light = light_};
    plan_.choices = estimator_choices(settings.estimator, light_, scene.exposure_ev, options_);
    std::set<std::pair<std::size_t, Isolation>> asking;
    for (const Stimulus& stimulus : stimuli) {
      ++stimuli_;
      const auto place = std::find(scene.artifacts.begin(), scene.artifacts.end(), stimulus.artifact);
      asking.insert({static_cast<std::size_t>(place - scene.artifacts.begin()), stimulus.isolation});
      meshes_.insert({stimulus.object_index, stimulus.depth});
    }
    for (const auto& [artifact, isolation] : asking)
      plan_.answers.push_back({scene.artifacts[artifact], recipe(scene.artifacts[artifact], isolation)});
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
    plan_.omissions.push_back({name, scene_.truth, std::move(why), std::move(saves), no_change, true});
  }

  /// An omission with a switch, which the choices make or not; `needed_because` says why not, when it is for
  /// the scene's sake.
  void omit(bool made, const PlannedOmission& what, const std::string& needed_because) {
    if (choices().estimator == Estimator::path) {
      plan_.not_omitted.push_back({what.name, "the path estimator leaves nothing out"});
    } else if (made) {
      plan_.omissions.push_back(what);
      plan_.omissions.back().where = scene_.truth;
    } else {
      plan_.not_omitted.push_back({what.name, needed_because.empty() ? "turned off" : needed_because});
    }
  }
  [[nodiscard]] const EstimatorChoices& choices() const { return plan_.choices; }

  template <class Asks>
  [[nodiscard]] bool any(Asks asks) const {
    return std::any_of(plan_.answers.begin(), plan_.answers.end(),
                       [&](const PlannedAnswers& one) { return asks(one.recipe); });
  }
  [[nodiscard]] bool bounces() const { return choices().bounces > 0 || light_.emits; }

  void shared_truth() {
    const std::size_t stimuli = stimuli_;
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
    const std::size_t widths = meshes_.size();
    const auto asking = static_cast<std::size_t>(
        std::count_if(plan_.answers.begin(), plan_.answers.end(),
                      [](const PlannedAnswers& one) { return one.recipe.answers.needs_depth(); }));
    if (asking > 1)
      always("one_mesh", "all artifacts of an object and width ask the same depth mesh",
             fmt::format("{} of {} depth meshes", (asking - 1) * widths, asking * widths));
  }

  void path_tails() {
    omit(choices().tail_every > 1,
         {.name = "path_tails",
          .why = fmt::format(
              "what follows the sun at a path's second surface is faint, so every {}th sample stands for {}",
              choices().tail_every, in_words(choices().tail_every)),
          .saves = fmt::format("{} of {} path tails", choices().tail_every - 1, choices().tail_every),
          .change = noise_only},
         choices().bounces > 0 ? "" : "paths end before a tail begins");
  }

  void bounce_filter() {
    const bool ratio = any([](const Recipe& r) { return asks_depth_off_object(r.answers); });
    const bool made = choices().filters.size() > 1 || (ratio && choices().ratio_filter != no_filter);
    omit(made,
         {.name = "bounce_filter",
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
    omit(choices().first_ratio_spp && lights,
         {.name = "ratio_samples",
          .why =
              "with and without the object are nearly the same light, and so are truth and depth mesh on the "
              "object: ratio and difference need fewer samples than the photograph",
          .saves = "most questions to the depth mesh",
          .change = noise_only},
         needed);
  }

  void untouched_tiles() {
    const bool somewhere =
        any([](const Recipe& r) { return r.keep == Keep::object_only || !asks_depth_off_object(r.answers); });
    omit(!choices().asks_untouched_tiles && somewhere,
         {.name = "untouched_tiles",
          .why = "the depth mesh is asked about the object only, so tiles without it need no answer",
          .saves = "blocks of 16 x 16 px where nothing asks it for light",
          .change = no_change},
         somewhere ? "" : "an artifact's light may differ in every tile");
  }

  void who_is_in_front() {
    omit(!choices().keeps_who_is_in_front,
         {.name = "who_is_in_front",
          .why = "the truth decides what hides the object, so what lies behind it is not kept",
          .saves = "a byte a sample in the object's tiles",
          .change = no_change},
         any([](const Recipe& r) { return r.answers.occlusion == Who::depth; })
             ? "the depth mesh decides what hides the object"
             : "");
  }

  void late_bounces() {
    const BounceLimit limit = needed_bounces(light_, scene_.exposure_ev, settings_.error);
    std::string needed;
    if (limit.bounces == light_.bounces)
      needed = is_unbounded(light_)  ? "surfaces that emit or mirror, and lamps, bound no bounce"
               : light_.bounces == 0 ? "there are no bounces"
                                     : fmt::format("all {} bounces may matter", light_.bounces);
    omit(choices().bounces < light_.bounces,
         {.name = "late_bounces",
          .why = fmt::format("surfaces reflect at most {:.2f} of the light, so later bounces are too dark",
                             light_.brightest_albedo),
          .saves = fmt::format("{} of {} bounces", light_.bounces - choices().bounces, light_.bounces),
          .change = fmt::format("at most {:.1e} of the display range", limit.change)},
         needed);
  }

  void dark_sky() {
    omit(choices().skips_sky,
         {.name = "dark_sky",
          .why = "the environment has no light, so no ray is traced only to reach it",
          .saves = "the last ray of each path",
          .change = no_change},
         light_.sky_is_dark ? "" : "the sky shines");
  }

  const SceneDefinition& scene_;
  const EstimateOptions options_;
  const LightFacts light_;
  const RenderSettings& settings_;
  std::size_t stimuli_ = 0;
  std::set<std::pair<int, DepthSettings>> meshes_;  ///< of each object
  ScenePlan plan_;
};

/// By all stimuli of the truth, as everything else that its estimator decides.
double most_mesh_albedo(const std::vector<Stimulus>& of_truth) {
  for (const Stimulus& stimulus : of_truth)
    if (stimulus.depth.albedo == MeshAlbedo::photograph) return most_photographed_albedo;
  return 0;
}

bool light_of_one_geometry(const std::vector<Stimulus>& of_truth) {
  return std::all_of(of_truth.begin(), of_truth.end(), [](const Stimulus& stimulus) {
    return light_of_one_geometry(recipe(stimulus.artifact, stimulus.isolation).answers);
  });
}

}  // namespace

EstimateOptions estimate_options(const std::vector<Stimulus>& of_truth, const RenderSettings& settings,
                                 int threads) {
  const Answers asked = asked_of_depth(of_truth);
  return {.spp = settings.spp,
          .error = settings.error,
          .seed = settings.seed,
          .threads = threads,
          .who_is_in_front = asked.occlusion == Who::depth,
          .depth_bounces = asked.bounce == Who::depth,
          .most_mesh_albedo = most_mesh_albedo(of_truth),
          .omit = settings.omit,
          .light_of_one_geometry = light_of_one_geometry(of_truth)};
}

RenderPlan render_plan(const StudyDefinition& study, const std::map<std::string, LightFacts>& lights,
                       const RenderSettings& settings) {
  RenderPlan plan{.settings = settings, .isolation = study.isolation, .scenes = {}};
  StimuliOfTruths stimuli = stimuli_of_truths(study);
  for (const SceneDefinition& scene : list_truths(study))
    if (const auto light = lights.find(scene.truth); light != lights.end())
      plan.scenes.push_back(ScenePlanner(stimuli[truth_of(scene)], scene, light->second, settings).plan());
  return plan;
}

std::map<std::string, LightFacts> lights_of(const StudyDefinition& study) {
  std::map<std::string, LightFacts> lights;
  for (const SceneDefinition& scene : list_truths(study))
    lights.emplace(scene.truth, light_facts(load_truth_scene(scene, study.width_px, study.height_px)));
  return lights;
}

std::vector<std::string> sentences(const RenderPlan& plan) {
  const auto any = [&](bool LightFacts::*fact) {
    return std::any_of(plan.scenes.begin(), plan.scenes.end(),
                       [&](const ScenePlan& scene) { return scene.light.*fact; });
  };
  std::vector<std::string> out;
  if (!any(&LightFacts::is_glossy)) out.emplace_back("textures: materials are diffuse base colours");
  if (!any(&LightFacts::sky_is_mapped))
    out.emplace_back(
        "environment sampling: the environment is constant, so cosine-weighted rays sample it exactly");
  for (const ScenePlan& scene : plan.scenes)
    for (const PlannedOmission& one : scene.omissions)
      out.push_back(fmt::format("{}: {}: {}; saves {}; change of the picture: {}", one.where, one.name,
                                one.why, one.saves, one.change));
  return out;
}

}  // namespace seamline::renderer
