#include "study/app/pictures/display_profile.h"

#include <fmt/core.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::study::app {
namespace fs = std::filesystem;
namespace {

constexpr const char* format_name = "seamline display";
constexpr int format_version = 1;

/// The file's profiles; empty when there is none or it is not ours.
nlohmann::json screens_of(const fs::path& file) {
  if (!fs::is_regular_file(file)) return nlohmann::json::object();
  const nlohmann::json whole = nlohmann::json::parse(read_file(file), nullptr, false);
  if (!whole.is_object() || whole.value("format", "") != format_name ||
      whole.value("version", 0) != format_version || !whole.contains("screens"))
    return nlohmann::json::object();
  return whole["screens"];
}

}  // namespace

std::string screen_key(const std::string& monitor, int mode_width, int mode_height,
                       int framebuffer_width_px) {
  return fmt::format("{} {}x{} {}", monitor, mode_width, mode_height, framebuffer_width_px);
}

fs::path display_profile_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config != nullptr && *config == '/') return fs::path(config) / "seamline" / "display.json";
  const char* home = std::getenv("HOME");
  return fs::path(home == nullptr ? "." : home) / ".config" / "seamline" / "display.json";
}

std::optional<DisplayProfile> read_display_profile(const fs::path& file, const std::string& screen) {
  try {
    const nlohmann::json screens = screens_of(file);
    if (!screens.contains(screen)) return std::nullopt;
    const nlohmann::json& entry = screens[screen];
    const DisplayProfile profile{.mm_per_px = entry.at("mm_per_px").get<double>(),
                                 .viewing_distance_mm = entry.at("viewing_distance_mm").get<double>(),
                                 .gamma_confirmed = entry.at("gamma_confirmed").get<bool>()};
    if (!(profile.mm_per_px > 0) || !(profile.viewing_distance_mm > 0)) return std::nullopt;
    return profile;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool write_display_profile(const fs::path& file, const std::string& screen, const DisplayProfile& profile) {
  try {
    nlohmann::json screens = screens_of(file);
    screens[screen] = {{"mm_per_px", profile.mm_per_px},
                       {"viewing_distance_mm", profile.viewing_distance_mm},
                       {"gamma_confirmed", profile.gamma_confirmed}};
    const nlohmann::json whole = {{"format", format_name}, {"version", format_version}, {"screens", screens}};
    fs::create_directories(file.parent_path());
    write_file_atomically(file, whole.dump(2) + "\n");
    return true;
  } catch (const InputError&) {
    return false;
  } catch (const fs::filesystem_error&) {
    return false;
  }
}

}  // namespace seamline::study::app
