#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::study::online {

/// A unit of systemd that serves with this command line (`program` first): restarted when it fails, stopped
/// as Ctrl-C stops it, able to write to the folder of the log alone. Paths are written whole.
[[nodiscard]] std::string systemd_unit(const std::vector<std::string>& command,
                                       const std::filesystem::path& log);

}  // namespace seamline::study::online
