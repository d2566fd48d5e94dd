#pragma once
#include <cstdint>
#include <span>

#include "support/files/image.h"

namespace seamline::inline window {

/// A picture in graphics memory, shown pixel for pixel: 8-bit codes as they are (no sRGB conversion, no
/// mipmaps), nearest sampling. Its storage is used again for the next picture of the same size, so memory
/// stays flat however many pictures are shown.
class WindowTexture {
 public:
  WindowTexture() = default;
  ~WindowTexture();
  WindowTexture(const WindowTexture&) = delete;
  WindowTexture& operator=(const WindowTexture&) = delete;
  WindowTexture(WindowTexture&& other) noexcept;
  WindowTexture& operator=(WindowTexture&& other) noexcept;

  /// Replaces the picture: 3 channels, or 1 shown as grey.
  void upload(const ByteImage& image);
  /// Replaces the picture by white that covers 0 to 255 of each pixel: letters, tinted where they are drawn.
  void upload_coverage(int width_px, int height_px, std::span<const std::uint8_t> coverage);
  /// Linear sampling, for pictures that are shown smaller or larger than they are.
  void smooth(bool on);

  [[nodiscard]] unsigned name() const { return name_; }
  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }

 private:
  unsigned name_ = 0;
  int width_px_ = 0, height_px_ = 0;
};

}  // namespace seamline::inline window
