#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace seamline::study {

/// In which language each participant read the study, by code, where it has several: of their latest sitting
/// that says so. Whoever said nothing is not there.
[[nodiscard]] std::map<std::string, std::string> reading_languages(const std::filesystem::path& log);

}  // namespace seamline::study
