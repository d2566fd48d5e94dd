#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "renderer/depth/local_scene.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// Depth meshes that several frames of clips have in common: where only the inserted object moves, or depth
/// is held, the depth map stays as it was. A mesh is kept until the last of its frames is rendered. Nothing
/// is kept for a study of stills.
class MeshShare {
 public:
  /// Of a study of frames (`still_study`); `rendered` are the stimuli to be rendered, `traces_rays` says
  /// whether light is asked of the mesh of one, by which its tree is made.
  MeshShare(const StudyDefinition& frames, const std::vector<Stimulus>& rendered,
            const std::function<bool(const Stimulus&)>& traces_rays);

  /// The mesh of one of them; null: nobody made it yet, or it belongs to this frame alone.
  [[nodiscard]] std::shared_ptr<const LocalScene> find(const Stimulus& stimulus) const;
  /// Takes note that a stimulus is rendered, and keeps its mesh while others of that mesh are to come.
  void finish(const Stimulus& stimulus, const std::shared_ptr<const LocalScene>& mesh);

 private:
  struct Mesh {
    std::size_t to_come = 0;  ///< stimuli that are not rendered yet
    std::shared_ptr<const LocalScene> made = nullptr;
  };
  std::map<std::string, Mesh> meshes_;              ///< by what decides them
  std::map<std::string, std::string> of_stimulus_;  ///< what decides the mesh, by the stimulus' id
};

}  // namespace seamline::renderer
