#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace seamline::study::app {

/// What the display check measured, and how large people like the text: kept for the next session on the same
/// machine and screen, in `$XDG_CONFIG_HOME/seamline/display.json` (else `~/.config/...`).
struct DisplayProfile {
  double mm_per_px = 0;            ///< measured against a bank card
  double viewing_distance_mm = 0;  ///< as entered
  bool gamma_confirmed = false;
  bool operator==(const DisplayProfile&) const = default;
};

/// Which screen: its name and sizes. Another mode of the same monitor has other pixels.
[[nodiscard]] std::string screen_key(const std::string& monitor, int mode_width, int mode_height,
                                     int framebuffer_width_px);

[[nodiscard]] std::filesystem::path display_profile_file();

/// None: never measured, or the file cannot be understood (it is measured again then).
[[nodiscard]] std::optional<DisplayProfile> read_display_profile(const std::filesystem::path& file,
                                                                 const std::string& screen);

/// Keeps the profile beside those of other screens. A file that cannot be written is no reason to stop a
/// session: returns false then.
bool write_display_profile(const std::filesystem::path& file, const std::string& screen,
                           const DisplayProfile& profile);

}  // namespace seamline::study::app
