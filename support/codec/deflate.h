#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace seamline {

/// A zlib stream (RFC 1950) of these bytes, the same for the same bytes.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// The bytes of a zlib stream; nothing unless it is whole and has exactly `size` of them.
[[nodiscard]] std::optional<std::string> inflated(std::string_view stream, std::size_t size);

}  // namespace seamline
