#pragma once
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace seamline::study::app {

/// A frame that was shown.
struct FrameTime {
  std::int64_t swap = 0;                     ///< number of the buffer swap, from 0
  std::string screen;                        ///< and, in a trial, its phase: `trial/choosing`
  std::int64_t begun_ns = 0;                 ///< work on the frame began
  std::int64_t shown_ns = 0;                 ///< the swap was done
  bool late = false;                         ///< it missed at least one refresh of the screen
  std::optional<std::int64_t> turn_ns = {};  ///< a picture's first frame: when its turn came
};

/// Writes the time of every frame as CSV (`--frame-times FILE`).
class FrameTimes {
 public:
  /// Empty: nothing is written. Throws InputError when the file cannot be written to.
  explicit FrameTimes(const std::filesystem::path& file);
  void add(const FrameTime& frame);

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace seamline::study::app
