#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "raytracer/scene/gltf/gltf_json.h"

namespace seamline::renderer {

/// Takes the table `buffers` out of the JSON and reads what it names: the binary chunk of a GLB, data URIs,
/// and files in the folder of the glTF file or below it. A buffer that is only the place of what compressed
/// bytes of another one will be (EXT_meshopt_compression) is empty. Throws InputError naming the buffer: too
/// many or too large (limits.h), outside the folder, not there, shorter than it says.
[[nodiscard]] GltfBuffers take_buffers(GltfJson& json, const std::optional<std::string>& chunk,
                                       const std::filesystem::path& path);

}  // namespace seamline::renderer
