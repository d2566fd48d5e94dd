#pragma once
#include <span>
#include <string>
#include <string_view>

namespace seamline {

/// The known word nearest to what was typed (edit distance), or empty when none is near enough to be meant.
[[nodiscard]] std::string nearest_word(std::string_view typed, std::span<const std::string> known);

}  // namespace seamline
