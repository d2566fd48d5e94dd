#pragma once
#include <string>

namespace seamline::inline stimuli {

/// Whether a depth file's name differs between stimuli: `{scene}` or `{object}` is in it.
[[nodiscard]] bool is_named_by_stimulus(const std::string& name);

/// The name with a stimulus's scene and object in place of `{scene}` and `{object}`.
[[nodiscard]] std::string depth_file_name(std::string name, const std::string& scene,
                                          const std::string& object);

}  // namespace seamline::inline stimuli
