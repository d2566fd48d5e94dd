#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/support/colour.h"

namespace seamline {

/// A float picture, rows from the top, channels interleaved. Linear unless a name says otherwise.
struct Image {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  std::vector<float> values;  ///< height_px * width_px * channels

  Image() = default;
  Image(int width, int height, int channel_count, float fill = 0.0F)
      : width_px(width),
        height_px(height),
        channels(channel_count),
        values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                   static_cast<std::size_t>(channel_count),
               fill) {}

  [[nodiscard]] std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
  }
  [[nodiscard]] float at(int x, int y, int channel = 0) const {
    return values[index(x, y) + static_cast<std::size_t>(channel)];
  }
  float& at(int x, int y, int channel = 0) { return values[index(x, y) + static_cast<std::size_t>(channel)]; }
  [[nodiscard]] Rgb rgb(int x, int y) const {
    const float* pixel = &values[index(x, y)];
    return {pixel[0], pixel[1], pixel[2]};
  }
  void set_rgb(int x, int y, const Rgb& colour) {
    float* pixel = &values[index(x, y)];
    pixel[0] = colour[0];
    pixel[1] = colour[1];
    pixel[2] = colour[2];
  }
};

/// An 8-bit picture with 1 or 3 channels: what people see (sRGB codes), or object ids.
struct ByteImage {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  std::vector<std::uint8_t> values;
};

/// Linear to sRGB 8-bit after multiplying by 2^exposure_ev: sRGB curve, clip at 1, round to nearest, no
/// dither.
[[nodiscard]] ByteImage display_image(const Image& linear, double exposure_ev = 0.0);

/// Reads EXR, HDR, PNG or JPEG as float. 8- and 16-bit pictures are decoded from sRGB to linear.
/// Throws InputError naming the file.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

/// Reads a file that holds floating-point values (EXR, HDR); anything else, whatever its name, is an
/// InputError.
[[nodiscard]] Image read_float_image(const std::filesystem::path& path);

struct PictureShape {
  int width_px = 0, height_px = 0, channels = 0;

  bool operator==(const PictureShape&) const = default;
};

/// What the file's header says, which is all that is read. Throws InputError naming the file.
[[nodiscard]] PictureShape picture_shape(const std::filesystem::path& path);

/// Reads an 8-bit PNG without any conversion. Throws InputError naming the file.
[[nodiscard]] ByteImage read_bytes_image(const std::filesystem::path& path);

/// Writes a 32-bit float EXR (1 channel: Y, 3 channels: R G B), atomically.
void write_exr(const std::filesystem::path& path, const Image& image);

/// Draws one line of text, its baseline starting at (x, y), in a grey code. Without the font (Debian:
/// fonts-dejavu-core) nothing is drawn.
void draw_text(ByteImage& image, int x, int y, const std::string& text, int height_px, std::uint8_t code);

/// Writes an 8-bit PNG, atomically; the same picture always gives the same bytes.
void write_png(const std::filesystem::path& path, const ByteImage& image);

}  // namespace seamline
