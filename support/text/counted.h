#pragma once
#include <fmt/core.h>

#include <concepts>
#include <string>
#include <string_view>

namespace seamline {

/// "1 answer", "2 answers", "0 answers"; `many` where more is said than an s: counted(3, "person", "people").
[[nodiscard]] std::string counted(std::integral auto count, std::string_view one,
                                  std::string_view many = {}) {
  if (count == 1) return fmt::format("1 {}", one);
  return many.empty() ? fmt::format("{} {}s", count, one) : fmt::format("{} {}", count, many);
}

}  // namespace seamline
