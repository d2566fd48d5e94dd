#pragma once
#include <filesystem>
#include <set>
#include <string>

#include "raytracer/scene/gltf/gltf_json.h"

namespace seamline::renderer {

/// What a file has and no picture shows, in plain words, for a sentence: "2 animations", "sheen of
/// materials".
using LeftOut = std::set<std::string>;

/// Throws InputError for a file of another version of glTF than 2.0, and for one that requires an extension
/// which Seamline cannot read, with the way round where there is one.
void require_readable(const GltfJson& json, const std::filesystem::path& path);

/// Adds what the file's tables have and nobody will look at: animations, further scenes, variants of
/// materials, extensions that Seamline does not know.
void note_unread(const GltfJson& json, LeftOut& left_out);

}  // namespace seamline::renderer
