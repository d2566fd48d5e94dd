#include "registration/errors/error_report.h"

#include <fmt/core.h>

#include <cmath>
#include <limits>

namespace seamline::registration {
namespace {

using Codes = std::array<std::uint8_t, 3>;

/// Colours that people who see fewer colours tell apart, too (Okabe and Ito 2008), and white and greys.
Codes colour_of(ErrorClass error_class) {
  switch (error_class) {
    case ErrorClass::right:
      return {0, 0, 0};
    case ErrorClass::border:
      return {0, 114, 178};
    case ErrorClass::near:
      return {240, 228, 66};
    case ErrorClass::far:
      return {86, 180, 233};
    case ErrorClass::occluded:
      return {213, 94, 0};
    case ErrorClass::nothing:
      return {230, 159, 0};
    case ErrorClass::unmeasured:
      return {255, 255, 255};
    case ErrorClass::gap:
      return {150, 150, 150};
    case ErrorClass::edge:
      return {0, 158, 115};
    case ErrorClass::noise:
      return {204, 121, 167};
  }
  return {};
}

std::string hex_of(const Codes& codes) {
  return fmt::format("#{:02x}{:02x}{:02x}", codes[0], codes[1], codes[2]);
}

double share_of(std::int64_t part, std::int64_t whole) {
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                    : static_cast<double>(part) / static_cast<double>(whole);
}

std::int64_t all_pixels_of(const ErrorClassMap& map) {
  return static_cast<std::int64_t>(map.classes.size());
}

std::int64_t wrong_of(const ErrorClassMap& map) {
  return all_pixels_of(map) - map.of(ErrorClass::right).pixels;
}

}  // namespace

CsvTable errors_table(const ErrorClassMap& map) {
  CsvTable table{.name = "errors",
                 .columns = {{"class", "", "why the depth is wrong (documentation/how-to/registration.md)"},
                             {"colour", "", "in errors.png, red, green and blue in hexadecimal; right: none"},
                             {"pixels", "", "of the photograph"},
                             {"share", "", "of all pixels"},
                             {"share_of_wrong", "", "of the pixels that are wrong"},
                             {"without_depth", "", "of the pixels: those that have no depth"},
                             {"median_error", "m", "of the others where the truth has a surface"}},
                 .rows = {}};
  const std::int64_t all = all_pixels_of(map), wrong = wrong_of(map);
  std::int64_t holes = 0;
  for (std::size_t i = 0; i < error_class_count; ++i) {
    const auto one = static_cast<ErrorClass>(i);
    const ErrorClassMap::Tally& tally = map.of(one);
    const bool right = one == ErrorClass::right;
    holes += tally.without_depth;
    table.rows.push_back({std::string(word(one)), right ? std::string() : hex_of(colour_of(one)),
                          tally.pixels, share_of(tally.pixels, all),
                          right ? CsvValue{} : CsvValue{share_of(tally.pixels, wrong)}, tally.without_depth,
                          tally.median_error_m});
  }
  table.rows.push_back({std::string("all"), std::string(), all, 1.0, 1.0, holes, std::monostate{}});
  return table;
}

std::string errors_text(const ErrorClassMap& map) {
  const std::int64_t all = all_pixels_of(map), wrong = wrong_of(map);
  const auto line = [&](const std::string& what, std::int64_t count) {
    return fmt::format("  {:<34}{:>10}  {:5.1f} %\n", what, count, 100 * share_of(count, all));
  };
  std::string text = "beside the true depth:\n" + line("right", map.of(ErrorClass::right).pixels);
  text += line("wrong", wrong);
  for (std::size_t i = 1; i < error_class_count; ++i) {
    const auto one = static_cast<ErrorClass>(i);
    if (map.of(one).pixels > 0) text += line(std::string("  ") + word(one), map.of(one).pixels);
  }
  return text;
}

ByteImage errors_over_photograph(const ErrorClassMap& map, const Image& photograph) {
  const ByteImage picture = display_image(photograph);
  ByteImage errors{picture.width_px, picture.height_px, 3, {}};
  errors.values.reserve(map.classes.size() * 3);
  for (std::size_t at = 0; at < map.classes.size(); ++at) {
    const ErrorClass one = map.classes[at];
    const Codes colour = colour_of(one);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int code = picture.values[at * static_cast<std::size_t>(picture.channels) + channel];
      errors.values.push_back(one == ErrorClass::right ? static_cast<std::uint8_t>(code / 3)
                                                       : colour[channel]);
    }
  }
  return errors;
}

}  // namespace seamline::registration
