#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "support/files/image.h"

namespace seamline::inline stimuli {

// A clip file: `seamline clip 1`, a line of JSON (width_px, height_px, channels, frames_per_s, and of each
// frame its bytes in the file and the SHA-256 of its pixels), then the frames, each a zlib stream. The first
// frame is whole; every other is its difference to the one before, modulo 256. Nothing is lost.

inline constexpr std::int64_t largest_clip_bytes = std::int64_t{1} << 32;

struct ClipShape {
  int width_px = 0, height_px = 0;
  int channels = 3;  ///< 1: a click map
  double frames_per_s = 0;

  bool operator==(const ClipShape&) const = default;
};

/// Collects frames, and writes them whole.
class ClipWriter {
 public:
  explicit ClipWriter(const ClipShape& shape) : shape_(shape) {}
  void add(const ByteImage& frame);  ///< of the clip's shape
  [[nodiscard]] std::string bytes() const;

 private:
  struct Frame {
    std::string stream, sha256;
  };
  ClipShape shape_;
  std::vector<std::uint8_t> last_;
  std::vector<Frame> frames_;
};

/// Decodes a clip frame by frame, in order. Holds the file's bytes and one frame.
class ClipReader {
 public:
  /// Throws InputError when the file is not there or is no clip.
  explicit ClipReader(const std::filesystem::path& path);
  [[nodiscard]] const ClipShape& shape() const { return shape_; }
  [[nodiscard]] int frames() const { return static_cast<int>(frames_.size()); }
  [[nodiscard]] int next_frame() const { return next_; }  ///< that `decode` gives
  /// The next frame, the first one after the last. Throws InputError when it has not the pixels that were
  /// written.
  [[nodiscard]] const ByteImage& decode();

 private:
  struct Frame {
    std::size_t begin = 0, bytes = 0;
    std::string sha256;
  };
  std::filesystem::path path_;
  std::string bytes_;
  ClipShape shape_;
  std::vector<Frame> frames_;
  int next_ = 0;
  ByteImage frame_;
};

}  // namespace seamline::inline stimuli
