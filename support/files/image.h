#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "support/arithmetic/colour.h"

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

/// An 8-bit picture: what people see (sRGB codes, 1 or 3 channels), object ids, or a texture (1 to 4
/// channels).
struct ByteImage {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  std::vector<std::uint8_t> values;
};

/// Linear to sRGB 8-bit after multiplying by 2^exposure_ev: sRGB curve, clip at 1, round to nearest, no
/// dither. Throws InputError at a picture with a value that is no number.
[[nodiscard]] ByteImage display_image(const Image& linear, double exposure_ev = 0.0);

/// What a picture's header says, before anything is decoded.
struct ImageHeader {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  bool floating_point = false;  ///< EXR, HDR: the values are as they are meant, not sRGB codes
  int orientation = 1;          ///< EXIF's, 1 to 8: how the camera was held; 1 is upright
};

/// Reads EXR, HDR, PNG or JPEG as float. 8- and 16-bit pictures are decoded from sRGB to linear. `accept`
/// sees the header first and throws InputError at a picture that is not wanted, so that no memory is taken
/// for it. Throws InputError naming the file.
[[nodiscard]] Image read_image(const std::filesystem::path& path,
                               const std::function<void(const ImageHeader&)>& accept = {});

/// A picture turned upright, of an EXIF orientation (1 to 8; any other number is taken as 1).
[[nodiscard]] Image upright(const Image& image, int orientation);

struct PictureShape {
  int width_px = 0, height_px = 0, channels = 0;

  bool operator==(const PictureShape&) const = default;
};

/// What the file's header says, which is all that is read. Throws InputError naming the file.
[[nodiscard]] PictureShape picture_shape(const std::filesystem::path& path);

/// What a file's name ends in, from the last dot on, in small letters: ".png" of "A.PNG".
[[nodiscard]] std::string lower_case_ending(const std::filesystem::path& path);

/// Reads an 8-bit PNG without any conversion. Throws InputError naming the file.
[[nodiscard]] ByteImage read_bytes_image(const std::filesystem::path& path);

/// Decodes a PNG or JPEG picture that was read already: 1 to 4 channels, the second or fourth being an alpha
/// that is not multiplied into the colour; 16 bits are rounded to 8. `name` is for complaints: InputError at
/// another kind of picture, one that is cut or damaged, or one larger than the limits, which is seen before
/// memory is taken for it.
[[nodiscard]] ByteImage decode_texture(std::string_view bytes, const std::string& name);

/// Throws InputError unless every value of a picture is a finite number. `what` says which picture, and may
/// be empty. Whatever is written or judged as a picture is looked at first: a pixel that is none would look
/// black.
void require_numbers(const Image& image, const std::string& what = {});

/// `write_exr` of a picture that people or programs look at, all of whose values are numbers
/// (`require_numbers`).
void write_picture_exr(const std::filesystem::path& path, const Image& image);

/// Writes a 32-bit float EXR (1 channel: Y, 3 channels: R G B), atomically; the same picture always gives the
/// same bytes. The values are not looked at.
void write_exr(const std::filesystem::path& path, const Image& image);

/// A part of an EXR file.
struct PictureLayer {
  std::string name;
  const Image* image = nullptr;  ///< 1 or 3 channels
};
/// Writes pictures of one size or several as the parts of one EXR file, 32-bit float, atomically; the same
/// pictures always give the same bytes. The values are not looked at.
void write_layers_exr(const std::filesystem::path& path, const std::vector<PictureLayer>& layers);

/// Grey codes of sheets that are made to be read.
inline constexpr std::uint8_t paper_code = 255, ink_code = 20;

/// Draws one line of text, its baseline starting at (x, y), in a grey code. Without the font (Debian:
/// fonts-dejavu-core) nothing is drawn.
void draw_text(ByteImage& image, int x, int y, const std::string& text, int height_px, std::uint8_t code);

/// Writes an 8-bit PNG, atomically; the same picture always gives the same bytes.
void write_png(const std::filesystem::path& path, const ByteImage& image);

}  // namespace seamline
