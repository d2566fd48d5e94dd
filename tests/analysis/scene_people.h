#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "analysis/over_scenes/scene_curves.h"
#include "support/arithmetic/random.h"
#include "tests/analysis/true_people.h"

namespace seamline::test {

/// How thresholds of scenes are spread about their mean; all have the standard deviation asked for.
enum class SceneSpreadForm { normal, uniform, skewed };

/// A study of one artifact in several scenes, each drawn anew. People see and rate as `TruePeople` say;
/// `artifact_sd` is of a person's threshold in one scene, and curves of scenes differ in steepness, too.
struct ScenePeople {
  TruePeople people = {.name = "unlike scenes",
                       .scale_octaves = 0.5,
                       .people_sd = 0.5,
                       .artifact_sd = 0.3,
                       .slope_sd = 0.2,
                       .object_octaves = 0.3};
  double scene_sd = 0.5;        ///< octaves, between scenes
  double scene_slope_sd = 0.2;  ///< of the logarithm of a scene's scale
  SceneSpreadForm form = SceneSpreadForm::normal;
  int scenes = 5, count = 20;
  double mean_x = 8.7;
  std::vector<double> level_x = {6, 7, 8, 9, 10, 11, 12};
};

/// In standard deviations, of mean 0.
inline double draw_scene(SceneSpreadForm form, Random& random) {
  switch (form) {
    case SceneSpreadForm::normal:
      return random.normal();
    case SceneSpreadForm::uniform:
      return std::sqrt(12.0) * (random.uniform() - 0.5);
    case SceneSpreadForm::skewed:
      return -std::log(1 - random.uniform()) - 1;
  }
  return 0;
}

/// The answers as `curves_by_scene` counts them.
inline analysis::SceneCurves answer_in_scenes(const ScenePeople& of, std::uint64_t seed) {
  analysis::SceneCurves curves{.artifact = Artifact::receiver, .condition = {}, .scenes = {}, .data = {}};
  analysis::JointData& data = curves.data;
  Random random(mix_bits(seed ^ 0x7363656e));
  std::vector<double> scene_x, scene_scale;
  for (int scene = 0; scene < of.scenes; ++scene) {
    curves.scenes.push_back("scene " + std::to_string(scene + 1));
    scene_x.push_back(of.mean_x + of.scene_sd * draw_scene(of.form, random));
    scene_scale.push_back(of.people.scale_octaves * std::exp(of.scene_slope_sd * random.normal()));
    for (const double x : of.level_x) data.cells.push_back({.curve = scene, .x = x, .chance = 1.0 / 3});
  }
  data.curves = curves.scenes;
  data.answers = Eigen::MatrixXd::Zero(of.count, std::ssize(data.cells) * data.cell_counts());
  data.references = Eigen::MatrixXd::Zero(of.count, data.ratings);
  for (int person = 0; person < of.count; ++person) {
    data.people.push_back("p" + std::to_string(person + 1));
    const double shift = of.people.people_sd * random.normal();
    const double slope = std::exp(of.people.slope_sd * random.normal());
    std::vector<double> own;
    for (int scene = 0; scene < of.scenes; ++scene) own.push_back(of.people.artifact_sd * random.normal());
    for (std::size_t c = 0; c < data.cells.size(); ++c) {
      const auto scene = static_cast<std::size_t>(data.cells[c].curve);
      for (int object = 0; object < true_objects; ++object) {
        const double x = scene_x[scene] + shift + own[scene] + of.people.object_octaves * (object - 1);
        const double d = (x - data.cells[c].x) / (scene_scale[scene] * slope);
        const double u = random.uniform();
        int rating = 1;
        bool right = true;
        if (u < detail::seen_share(of.people.seeing, d))
          for (int k = 1; k < 4; ++k) rating += u < detail::seen_and_rated(of.people, d, d, k) ? 1 : 0;
        else
          right = random.below(true_objects) == 0;
        const Eigen::Index outcome = (right ? 0 : data.ratings) + rating - 1;
        data.answers(person, static_cast<Eigen::Index>(c) * data.cell_counts() + outcome) += 1;
      }
    }
  }
  return curves;
}

/// How far above a scene's place its threshold lies: people and slopes (of scenes, too) integrated out. The
/// mean over scenes of a threshold is `mean_x` and this.
inline double true_scene_offset(const ScenePeople& of, double level, bool corrected) {
  double sum = 0;
  for (const detail::TrueNode& slope : detail::normal_nodes(of.scene_slope_sd, 0.5)) {
    TruePeople people = of.people;
    people.scale_octaves *= std::exp(slope.value);
    sum += slope.weight * true_crossing_octaves(people, level, corrected);
  }
  return sum;
}

}  // namespace seamline::test
