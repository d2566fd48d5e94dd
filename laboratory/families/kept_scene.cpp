#include "laboratory/families/kept_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "raytracer/scene/scene_measures.h"
#include "raytracer/scene/truth_scene.h"
#include "sets/check.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::laboratory {
namespace {

using scenes::GeneratedScene;
using scenes::SceneFamily;

constexpr int most_scenes = 60, most_placements = 16;

std::string singular(SceneFamily family) {
  std::string text(word(family));
  text.pop_back();
  return text;
}

std::string object_text(const scenes::PlacedObject& object) {
  return fmt::format(
      "\n  [[scene.object]]\n  name = \"{}\"\n  file = \"{}\"\n  position_m = [{:.4f}, {:.4f}, {:.4f}]\n"
      "  rotation_deg = [0.0, {:.2f}, 0.0]\n  scale = {:.4f}\n{}",
      object.name, object.file, object.position_m.x(), object.position_m.y(), object.position_m.z(),
      object.yaw_deg, object.scale,
      object.exempt_from_shape_rules ? "  exempt_from_shape_rules = true\n" : "");
}

/// A scene as the program sees it, from the file that it reads.
class LookedAtScene {
 public:
  LookedAtScene(SceneFamily family, const GeneratedScene& scene) : family_(family) {
    write_glb(folder_ / (scene_name(family, 1) + ".glb"), as_shown(scene).background);
  }
  /// The truth with the objects where `scene` has them; its background is the constructor's.
  [[nodiscard]] renderer::TruthScene truth(const GeneratedScene& scene, int width_px) const {
    const std::filesystem::path file = folder_ / "study.toml";
    write_file_atomically(file, family_study_text(family_, {as_shown(scene)}));
    return renderer::load_truth_scene(read_study(file).scenes.front(), width_px, width_px * 9 / 16);
  }
  [[nodiscard]] std::vector<renderer::RuleResult> broken_rules(const GeneratedScene& scene,
                                                               int width_px) const {
    std::vector<renderer::RuleResult> rules = renderer::check_scene(truth(scene, width_px));
    std::erase_if(rules, [](const renderer::RuleResult& rule) { return rule.met; });
    return rules;
  }
  /// Scales so that all objects have the area of their mean if nothing stood before them.
  void equalise_areas(GeneratedScene& scene, int width_px) const {
    const auto measures = renderer::measure_objects(truth(scene, width_px));
    double sum = 0;
    for (const renderer::ObjectMeasures& object : measures) sum += object.unoccluded_px;
    for (std::size_t object = 0; object < measures.size(); ++object)
      if (measures[object].unoccluded_px > 0)
        scene.objects[object].scale *= std::sqrt(sum / 3 / measures[object].unoccluded_px);
  }

 private:
  SceneFamily family_;
  TemporaryFolder folder_;
};

/// The object that a broken rule is about, else any.
std::size_t object_to_move(const GeneratedScene& scene, const std::vector<renderer::RuleResult>& broken,
                           Random& random) {
  const std::size_t any = random.below(3);
  if (broken.empty()) return any;
  const std::string& found = broken[random.below(broken.size())].found;
  if (found.find("ratio") != std::string::npos) return any;
  std::size_t named = any, at = found.size();
  for (std::size_t object = 0; object < scene.objects.size(); ++object)
    if (const std::size_t place = found.find(scene.objects[object].name); place < at) {
      named = object;
      at = place;
    }
  return named;
}

/// Whether the scene keeps the rules in the end.
bool place_until_kept(SceneFamily family, GeneratedScene& scene, Random& random, int& placements) {
  const LookedAtScene look(family, scene);
  const bool equal_areas = family == SceneFamily::arcades;
  if (equal_areas) look.equalise_areas(scene, 480);
  std::vector<renderer::RuleResult> broken = look.broken_rules(scene, 480);
  for (int placement = 0; placement < most_placements; ++placement) {
    stop_if_interrupted();
    if (broken.empty()) broken = look.broken_rules(scene, 960);
    if (broken.empty()) return true;
    GeneratedScene other = scene;
    place_anew(family, other, object_to_move(scene, broken, random), random);
    if (equal_areas) look.equalise_areas(other, 480);
    ++placements;
    std::vector<renderer::RuleResult> broken_there = look.broken_rules(other, 480);
    if (broken_there.size() > broken.size()) continue;
    scene = other;
    broken = std::move(broken_there);
  }
  return false;
}

}  // namespace

KeptScene scene_that_keeps_rules(SceneFamily family, std::uint64_t seed, int number) {
  Random random(seed, number * scenes::every_scene_family.size() + static_cast<std::uint64_t>(family));
  KeptScene kept;
  for (; kept.scenes_drawn <= most_scenes; ++kept.scenes_drawn) {
    kept.scene = generate_scene(family, random);
    if (!place_until_kept(family, kept.scene, random, kept.placements_drawn)) continue;
    kept.scene = as_shown(kept.scene);
    return kept;
  }
  throw input_error({.field = request_name("seed"),
                     .wanted = "a seed whose scenes keep the rules",
                     .found = fmt::format("{}: number {} of {} broke one in {} scenes", seed, number,
                                          word(family), most_scenes)});
}

std::string scene_name(SceneFamily family, int number) {
  return fmt::format("{}_{:02}", singular(family), number);
}

std::string family_study_text(SceneFamily family, const std::vector<GeneratedScene>& scenes) {
  std::string text = fmt::format(
      "# Generated scenes that keep the rules of `seamline check`.\nformat = \"seamline study 1\"\n"
      "name = \"{}\"\nisolation = \"mask\"\nwidth_px = 960\nheight_px = 540\nsamples_per_pixel = 64\nseed = 1\n"
      "mesh = \"adaptive\"\nmesh_tolerance = 1e-4\ndepth_width_px = [64, 128, 256, 512, 1024, 2048, 4096]\n",
      word(family));
  int number = 0;
  for (const GeneratedScene& scene : scenes) {
    const std::string name = scene_name(family, ++number);
    text += fmt::format("\n[[scene]]\nname = \"{}\"\nfile = \"{}.glb\"\n{}", name, name, scene.settings);
    for (const scenes::PlacedObject& object : scene.objects) text += object_text(object);
  }
  return text;
}

}  // namespace seamline::laboratory
