#include "support/text/number_range.h"

#include <fmt/format.h>

#include <cmath>

namespace seamline {

namespace {

/// As people write it: all digits of the largest seed.
std::string limit_text(double limit) {
  constexpr double largest_seed = 18446744073709551615.0;
  return limit == largest_seed ? "18446744073709551615" : fmt::format("{}", limit);
}

}  // namespace

std::string range_text(const char* kind, NumberRange range) {
  const std::string unit = range.unit.empty() ? std::string() : fmt::format(" {}", range.unit);
  if (std::isinf(range.most)) return fmt::format("{} of at least {}{}", kind, range.least, unit);
  return fmt::format("{} from {} to {}{}", kind, range.least, limit_text(range.most), unit);
}

}  // namespace seamline
