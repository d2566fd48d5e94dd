#include "support/arithmetic/colour.h"

#include <cmath>

namespace seamline {

float srgb_from_linear(float linear) {
  if (!(linear > 0.0F)) return 0.0F;
  if (linear >= 1.0F) return 1.0F;
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float linear_from_srgb(float display) {
  return display <= 0.04045F ? display / 12.92F : std::pow((display + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t code_from_display(float display) {
  if (!(display > 0.0F)) return 0;
  if (display >= 1.0F) return 255;
  return static_cast<std::uint8_t>(std::lround(display * 255.0F));
}

}  // namespace seamline
