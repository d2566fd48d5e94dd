#pragma once
#include <span>
#include <string>
#include <string_view>

namespace seamline {

/// The known word nearest to what was typed (edit distance); else the first that holds all of it, as
/// "horizontal_fov_deg" holds "fov_deg"; empty when none is near enough to be meant.
[[nodiscard]] std::string nearest_word(std::string_view typed, std::span<const std::string> known);

}  // namespace seamline
