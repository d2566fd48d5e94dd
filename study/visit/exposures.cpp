#include "study/visit/exposures.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace seamline::study {
namespace {

int frames_in(std::int64_t time_ns, std::int64_t refresh_ns) {
  return static_cast<int>(std::llround(static_cast<double>(time_ns) / static_cast<double>(refresh_ns)));
}

/// Takes "WORD NUMBER" from the front, and the blank behind it; false where something else stands there.
bool take(std::string_view& text, std::string_view word, int& number) {
  if (!text.starts_with(word) || text.size() <= word.size() || text[word.size()] != ' ') return false;
  text.remove_prefix(word.size() + 1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.starts_with(' ')) text.remove_prefix(1);
  return true;
}

}  // namespace

std::string text_of(const Exposure& exposure) {
  return fmt::format("picture {} frames {} wanted {}", exposure.picture, exposure.frames, exposure.wanted);
}

std::optional<Exposure> exposure_of(const std::string& text) {
  std::string_view left = text;
  Exposure read;
  const bool is_whole = take(left, "picture", read.picture) && take(left, "frames", read.frames) &&
                        take(left, "wanted", read.wanted) && left.empty();
  return is_whole && read.picture >= 1 ? std::optional(read) : std::nullopt;
}

int wanted_frames(std::int64_t exposure_ns, std::int64_t refresh_ns) {
  return std::max(1, frames_in(exposure_ns, refresh_ns));
}

std::optional<Exposure> ExposureCounter::note_shown(std::optional<int> picture, std::int64_t shown_ns,
                                                    std::int64_t exposure_ns, std::int64_t refresh_ns) {
  if (picture == seen_) return std::nullopt;
  std::optional<Exposure> ended;
  if (seen_)
    ended = Exposure{.picture = *seen_ + 1,
                     .frames = frames_in(shown_ns - since_ns_, refresh_ns),
                     .wanted = wanted_frames(exposure_ns, refresh_ns)};
  seen_ = picture;
  since_ns_ = shown_ns;
  return ended;
}

}  // namespace seamline::study
