#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sensors/files/depth_file.h"
#include "sensors/files/estimated_depth.h"
#include "sensors/files/raw_depth.h"

namespace seamline::sensors {

/// What a file's values mean, beside `DepthFileForm`.
struct DepthMeaning {
  std::vector<double> nothing = {};            ///< values that stand for no depth, beside 0
  std::optional<DepthEstimate> estimate = {};  ///< values are no distances yet
  bool of_request = false;                     ///< form and meaning are a request's own, not a file's
};

/// Why pixels have no depth.
struct DepthHoles {
  std::int64_t zero = 0, negative = 0, no_number = 0, infinite = 0;  ///< infinity: what we write for a hole
  std::int64_t coded = 0;                                            ///< of a value that stands for nothing
  std::int64_t beyond_file = 0;                                      ///< outside of an EXR file's data window
  std::int64_t out_of_range = 0;                                     ///< nearer or farther than is stated
  std::int64_t beyond_line = 0;  ///< an estimate's, whose line gives them no distance
};

struct DepthFromValues {
  DepthFile file;
  DepthHoles why;
  std::vector<std::string> notes;  ///< to be said, without the file's name
};

/// Depth of a file's values; `path` is for complaints. Throws InputError as `read_depth_file` does, and for
/// an estimate without a line or one that cannot be found, and for floats from 0 to exactly 1 without a unit,
/// as an estimate has them.
[[nodiscard]] DepthFromValues depth_of_values(const RawDepth& raw, const std::filesystem::path& path,
                                              const DepthFileForm& form, const DepthMeaning& meaning);

}  // namespace seamline::sensors
