#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace seamline::study {

/// What a participant's pictures were shown on, by the last session that noted it; 0: not known.
struct ShownOn {
  int mode_width_px = 0, mode_height_px = 0;  ///< of the screen
  double viewing_distance_mm = 0;             ///< as entered
  double pixels_per_degree = 0;               ///< at the middle of the screen
};

/// By participant, of those whose sessions noted a display. Throws InputError as `read_log`.
[[nodiscard]] std::map<std::string, ShownOn> read_displays(const std::filesystem::path& log);

}  // namespace seamline::study
