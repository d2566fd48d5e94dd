#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/gltf/gltf_extensions.h"
#include "raytracer/scene/gltf/gltf_json.h"
#include "raytracer/scene/scene_file.h"
#include "stimuli/definition/moving/file_moment.h"
#include "stimuli/definition/study_definition.h"

namespace tinygltf {
class Model;
}

namespace seamline::renderer {

/// As `read_scene_file`, with the nodes, skins and morph weights of one moment of an animation.
[[nodiscard]] SceneFile read_scene_moment(const std::filesystem::path& path, MaterialModel materials,
                                          Transparency transparency, const std::optional<FileMoment>& moment);

/// The file of an object as it stands in a scene, which may give its surfaces another gloss.
[[nodiscard]] SceneFile read_object_file(const ObjectDefinition& object, const SceneDefinition& scene);

/// Moves nodes from where they stand. Throws InputError naming the file and a node that it has not, or has
/// twice.
void place_nodes(const std::vector<PlacedNode>& nodes, const std::string& file, tinygltf::Model& model);

/// Puts a model's nodes where its animation has them (glTF 2.0, 3.11 and appendix C): translation, rotation,
/// scale and morph weights, by steps, lines or cubic splines. Before its first key and after its last one a
/// channel stands. `animations` is the file's table. Throws InputError naming the file and the part that is
/// wrong: an animation that does not exist, times that do not rise, a node with a matrix.
void pose_at(const FileMoment& moment, const GltfJson& animations, const std::string& file,
             tinygltf::Model& model, LeftOut& left_out);

/// Which animation of a file is meant: the first of that name, else the one of that number; without a name
/// the only one. Throws InputError where there is none.
[[nodiscard]] std::size_t animation_index(const std::string& name, const GltfJson& animations,
                                          const std::string& file);

/// Puts nodes where an animation has them at a time, as `pose_at` does.
using NodeMotion = std::function<void(tinygltf::Model& model, double time_s)>;

/// The places, turns and sizes of an animation, whose keys are read once; morph weights stay. Throws
/// InputError as `pose_at` does, some of it only when nodes are put.
[[nodiscard]] NodeMotion node_motion(std::size_t index, const GltfJson& animations, const std::string& file,
                                     const tinygltf::Model& model);

}  // namespace seamline::renderer
