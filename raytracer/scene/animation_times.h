#pragma once
#include <cstdint>
#include <set>
#include <vector>

#include "raytracer/scene/gltf/gltf_accessor.h"
#include "raytracer/scene/gltf/gltf_json.h"

namespace seamline::renderer {

/// The nodes that an animation of a glTF file moves, turns or scales; some may not exist.
[[nodiscard]] std::set<std::int64_t> animated_nodes(const GltfJson& animation);

/// When it has a key. Between them values go along lines or turns the shorter way; where it goes by steps or
/// splines, there is a time every sixtieth of a second besides. Throws InputError where its times cannot be
/// read.
[[nodiscard]] std::vector<double> animation_times_s(const GltfJson& animation, const GltfReader& reader);

}  // namespace seamline::renderer
