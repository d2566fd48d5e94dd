#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::renderer {

/// One attribute of a mesh that was compressed by Draco, as an accessor of glTF has it.
struct DracoAttribute {
  int component_type = 5126;  ///< glTF's code
  int components = 0;
  std::string bytes;  ///< of every vertex, without gaps
};

struct DracoMesh {
  std::vector<std::uint32_t> corners;  ///< three a triangle
  std::uint32_t vertices = 0;
  std::map<int, DracoAttribute> attributes;  ///< by Draco's own number
};

/// Whether Seamline was built with Draco (Debian: libdraco-dev).
[[nodiscard]] bool has_draco();

/// The mesh in these bytes; none where they hold none, it has more than so many vertices or triangles, or
/// Seamline was built without Draco.
[[nodiscard]] std::optional<DracoMesh> decode_draco(std::string_view bytes, std::uint32_t most_vertices,
                                                    std::uint32_t most_triangles);

}  // namespace seamline::renderer
