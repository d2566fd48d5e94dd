#pragma once
#include <span>

#include "stimuli/definition/artifact.h"

namespace seamline::renderer {

/// Who answers a question that light asks of the real world.
enum class Who { truth, depth };

/// The table of documentation/developers/design.md, section 1: an artifact is a choice of who answers each of
/// six questions.
struct Answers {
  Who receiver = Who::truth;    ///< 1: on which surface does the virtual shadow land
  Who real_lit = Who::truth;    ///< 2: is the real surface lit by sun and sky
  Who object_lit = Who::truth;  ///< 3: is the virtual object lit past real things
  Who occlusion = Who::truth;   ///< 4: does the real world hide the virtual object
  Who bounce = Who::truth;      ///< 5: bounce light
  Who mirrored = Who::truth;    ///< 6: what is mirrored in the virtual object, asked of glossy ones only

  [[nodiscard]] bool asks_depth_for_light() const { return receiver == Who::depth || traces_depth(); }
  /// Whether rays go through the depth mesh that do not start at the panorama's centre: as a receiver it only
  /// lends the points that the camera sees, and needs no good search tree.
  [[nodiscard]] bool traces_depth() const {
    return real_lit == Who::depth || object_lit == Who::depth || bounce == Who::depth ||
           mirrored == Who::depth;
  }
  [[nodiscard]] bool needs_depth() const { return asks_depth_for_light() || occlusion == Who::depth; }
};

/// Whether the depth mesh answers anything about light on the real surfaces that the object does not cover.
[[nodiscard]] inline bool asks_depth_off_object(const Answers& answers) {
  return answers.receiver == Who::depth || answers.real_lit == Who::depth || answers.bounce == Who::depth;
}

/// Whether the depth mesh changes only sun and sky on the object: what it adds to the truth's light there is
/// nothing for most samples. (Its bounce light has little in common with the truth's.)
[[nodiscard]] inline bool adds_to_object(const Answers& answers) {
  return answers.object_lit == Who::depth && answers.bounce == Who::truth;
}

/// Whether the depth mesh decides how much light a real surface gets, so that its sheets can seal one in. As
/// a receiver alone it only lends its points and normals.
[[nodiscard]] inline bool depth_lights_uncovered(const Answers& answers) {
  return answers.real_lit == Who::depth || answers.bounce == Who::depth;
}

/// Whether one geometry answers for all diffuse light, so that sky and bounce light need not be kept apart.
[[nodiscard]] inline bool light_of_one_geometry(const Answers& answers) {
  return answers.receiver == answers.bounce && answers.real_lit == answers.bounce &&
         answers.object_lit == answers.bounce;
}

/// Whose pixels a stimulus shows; the others come from the reference.
enum class Keep { everything, object_only, all_but_object };

struct Recipe {
  Answers answers;
  Keep keep = Keep::everything;
};

/// `query`: the table. `mask`: everything from the depth mesh, then for `shadow` only the object is
/// kept and for `overlap` only what it leaves uncovered (the paper's section 4.1.1); the reserved artifacts
/// are as in `query`.
[[nodiscard]] Recipe recipe(Artifact artifact, Isolation isolation);

/// What any of the recipes asks of the depth mesh.
[[nodiscard]] Answers asked_by_any(std::span<const Recipe> recipes);

}  // namespace seamline::renderer
