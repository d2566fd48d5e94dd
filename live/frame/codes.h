#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "support/arithmetic/colour.h"

namespace seamline::live {

/// sRGB codes and linear light, both ways by table: the curve's powers would be a third of a frame's time.
class CodeTables {
 public:
  CodeTables();
  [[nodiscard]] float linear(std::uint8_t code) const { return linear_[code]; }
  /// Of linear light, clipped to 0..1: the nearest code of a value within 1 / 131,070 of it, which is at most
  /// a thirtieth of a code.
  [[nodiscard]] std::uint8_t code(float value) const {
    const float clipped = value > 0.0F ? (value < 1.0F ? value : 1.0F) : 0.0F;
    return code_[static_cast<std::size_t>(clipped * static_cast<float>(steps) + 0.5F)];
  }

 private:
  static constexpr int steps = 65535;
  std::array<float, 256> linear_;
  std::vector<std::uint8_t> code_;
};

[[nodiscard]] const CodeTables& code_tables();

}  // namespace seamline::live
