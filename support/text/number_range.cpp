#include "support/text/number_range.h"

#include <fmt/format.h>

#include <cmath>

namespace seamline {

std::string range_text(const char* kind, NumberRange range) {
  const std::string unit = range.unit.empty() ? std::string() : fmt::format(" {}", range.unit);
  if (std::isinf(range.most)) return fmt::format("{} of at least {}{}", kind, range.least, unit);
  return fmt::format("{} from {} to {}{}", kind, range.least, range.most, unit);
}

}  // namespace seamline
