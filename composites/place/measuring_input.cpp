#include "composites/place/measuring_input.h"

#include <charconv>

namespace seamline::place {
namespace {

constexpr double nearest_m = 0.01, farthest_m = 10000;
constexpr std::size_t most_characters = 10;

std::optional<double> distance_m(const std::string& typed) {
  double value = 0;
  const char* end = typed.data() + typed.size();
  const auto read = std::from_chars(typed.data(), end, value, std::chars_format::fixed);
  if (read.ec != std::errc() || read.ptr != end || value < nearest_m || value > farthest_m)
    return std::nullopt;
  return value;
}

void type(const std::u32string& characters, Measuring& measuring) {
  for (const char32_t character : characters) {
    const bool is_digit = character >= U'0' && character <= U'9';
    const bool is_point = character == U'.' || character == U',';
    if (!(is_digit || is_point) || measuring.typed.size() >= most_characters) continue;
    measuring.typed += is_point ? '.' : static_cast<char>(character);
    measuring.complaint.clear();
  }
}

MeasuringWish enter(Measuring& measuring) {
  if (!measuring.open) {
    if (measuring.known.size() >= least_known) return MeasuringWish::go_on;
    measuring.complaint = "two places or more are needed: click the next one";
    return MeasuringWish::nothing;
  }
  const auto distance = distance_m(measuring.typed);
  if (!distance) {
    measuring.complaint = "a distance is 0.01 to 10000 metres";
    return MeasuringWish::nothing;
  }
  measuring.open->distance_m = *distance;
  measuring.known.push_back(*measuring.open);
  measuring.open.reset();
  measuring.typed.clear();
  return MeasuringWish::known_changed;
}

MeasuringWish take_back(Measuring& measuring) {
  measuring.typed.clear();
  measuring.complaint.clear();
  if (measuring.open) {
    measuring.open.reset();
    return MeasuringWish::nothing;
  }
  if (measuring.known.empty()) return MeasuringWish::nothing;
  measuring.known.pop_back();
  return MeasuringWish::known_changed;
}

}  // namespace

MeasuringWish measure(const FrameInput& input, const Rect& picture, Measuring& measuring) {
  if (input.close || (input.pressed(Key::escape) && !input.key->repeated)) return MeasuringWish::leave;
  if (input.pressed_letter('z', true) || input.pressed(Key::remove)) return take_back(measuring);
  if (input.pressed(Key::enter) && !input.key->repeated) return enter(measuring);
  if (input.pressed(Key::backspace) && !measuring.typed.empty()) {
    measuring.typed.pop_back();
    measuring.complaint.clear();
  }
  if (measuring.open) type(input.typed, measuring);
  if (input.mouse_pressed && picture.contains(input.mouse)) {
    measuring.open = {.across = (input.mouse.x_px - picture.x_px) / picture.width_px,
                      .down = (input.mouse.y_px - picture.y_px) / picture.height_px};
    measuring.typed.clear();
    measuring.complaint.clear();
  }
  return MeasuringWish::nothing;
}

}  // namespace seamline::place
