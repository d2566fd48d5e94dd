#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace seamline::study {

/// How long one of a trial's pictures stood on the screen, in refreshes of the screen.
struct Exposure {
  int picture = 1;  ///< of those that the trial shows one after another, from 1
  int frames = 0;   ///< from the swap that showed it to the one that took it away
  int wanted = 0;   ///< nearest to the study's `exposure_s`, at least 1
  bool operator==(const Exposure&) const = default;
};

/// "picture 1 frames 30 wanted 30": the detail of an event `exposure`.
[[nodiscard]] std::string text_of(const Exposure& exposure);
/// None where the text is no such detail.
[[nodiscard]] std::optional<Exposure> exposure_of(const std::string& text);

/// The frames that the study asks for on a screen with this time between refreshes.
[[nodiscard]] int wanted_frames(std::int64_t exposure_ns, std::int64_t refresh_ns);

/// Follows the frames that are shown, and tells each exposure that ended by itself.
class ExposureCounter {
 public:
  /// A frame was shown at `shown_ns`, with a picture of the trial (from 0) or none. `refresh_ns`: between two
  /// refreshes of the screen.
  [[nodiscard]] std::optional<Exposure> note_shown(std::optional<int> picture, std::int64_t shown_ns,
                                                   std::int64_t exposure_ns, std::int64_t refresh_ns);
  /// An answer or a pause ends the exposure: it says nothing of the screen.
  void forget() { seen_.reset(); }

 private:
  std::optional<int> seen_ = {};
  std::int64_t since_ns_ = 0;
};

}  // namespace seamline::study
