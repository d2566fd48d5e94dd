#pragma once
#include <map>
#include <string>
#include <vector>

#include "renderer/estimators/estimator_choices.h"
#include "sets/set_records.h"

namespace seamline::renderer {

/// Something that is not computed.
struct PlannedOmission {
  std::string name = {};    ///< as in omission_names, or of one that has no switch
  std::string where = {};   ///< the scene
  std::string why = {};     ///< a clause
  std::string saves = {};   ///< with its unit
  std::string change = {};  ///< what the picture differs by at most from one that has it
  bool always = false;      ///< has no switch
};

/// An omission that is not made in a scene.
struct NotOmitted {
  std::string name = {};
  std::string why = {};
};

/// Who answers the five questions of one artifact.
struct PlannedAnswers {
  Artifact artifact = Artifact::none;
  Recipe recipe = {};
};

struct ScenePlan {
  std::string scene = {};
  LightFacts light = {};
  EstimatorChoices choices = {};  ///< what the estimator holds to
  std::vector<PlannedAnswers> answers = {};
  std::vector<PlannedOmission> omissions = {};
  std::vector<NotOmitted> not_omitted = {};
};

/// What a render job computes and what it leaves out.
struct RenderPlan {
  RenderSettings settings = {};
  Isolation isolation = Isolation::query;
  std::vector<ScenePlan> scenes = {};
};

/// What an estimator is asked for in one truth, by all its stimuli (`stimuli_of_truths`), not by those left
/// to render: a set that was interrupted has the same bytes.
[[nodiscard]] EstimateOptions estimate_options(const std::vector<Stimulus>& of_truth,
                                               const RenderSettings& settings, int threads);

/// The plan for the truths of a study whose light is given, by name; others are left out. Depends on nothing
/// measured.
[[nodiscard]] RenderPlan render_plan(const StudyDefinition& study,
                                     const std::map<std::string, LightFacts>& lights,
                                     const RenderSettings& settings);

/// Loads the scenes and looks at their light.
[[nodiscard]] std::map<std::string, LightFacts> lights_of(const StudyDefinition& study);

/// A sentence for each omission, for the manifest.
[[nodiscard]] std::vector<std::string> sentences(const RenderPlan& plan);

}  // namespace seamline::renderer
