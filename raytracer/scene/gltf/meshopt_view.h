#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::renderer {

/// What EXT_meshopt_compression says of a buffer view.
struct MeshoptView {
  std::string mode;    ///< ATTRIBUTES, TRIANGLES or INDICES
  std::string filter;  ///< NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL; empty: none
  std::size_t count = 0, stride = 0;
};

/// Whether Seamline was built with meshoptimizer (Debian: libmeshoptimizer-dev).
[[nodiscard]] bool has_meshopt();

/// `count` elements of `stride` bytes, in these bytes; none where they are damaged, mode, filter and stride
/// do not fit each other, or Seamline was built without meshoptimizer.
[[nodiscard]] std::optional<std::vector<unsigned char>> decode_meshopt(std::string_view bytes,
                                                                       const MeshoptView& view);

}  // namespace seamline::renderer
