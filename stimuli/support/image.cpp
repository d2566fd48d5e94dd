// The only file that includes OpenImageIO.
#include "stimuli/support/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <cmath>

#include "stimuli/support/atomic_file.h"
#include "stimuli/support/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t largest_pixel_count = std::int64_t{16384} * 16384;

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
  if (!fs::exists(path))
    throw input_error({.file = path.string(), .wanted = "an image file", .found = "no such file"});
  auto input = OIIO::ImageInput::open(path.string());
  if (!input)
    throw input_error(
        {.file = path.string(), .wanted = "an image that can be decoded", .found = OIIO::geterror()});
  const OIIO::ImageSpec& spec = input->spec();
  if (std::int64_t{spec.width} * spec.height > largest_pixel_count || spec.nchannels < 1 ||
      spec.nchannels > 16 || spec.depth > 1)
    throw input_error({.file = path.string(),
                       .wanted = "a flat image of at most 16384 x 16384 pixels",
                       .found = std::to_string(spec.width) + " x " + std::to_string(spec.height)});
  return input;
}

/// The picture is encoded in memory and then written: image libraries do not notice every write that failed,
/// and a picture that a full disk cut short would pass for a finished one.
void write_image(const fs::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
  OIIO::Filesystem::IOVecOutput bytes;
  const auto output = OIIO::ImageOutput::create(path.string());
  const bool encoded = output && output->set_ioproxy(&bytes) && output->open(path.string(), spec) &&
                       output->write_image(type, pixels) && output->close();
  if (!encoded)
    throw input_error({.file = path.string(),
                       .wanted = "a kind of picture that can be written (png, exr)",
                       .found = output ? output->geterror() : OIIO::geterror()});
  const std::vector<unsigned char>& buffer = bytes.buffer();
  write_file_atomically(path, std::string_view(reinterpret_cast<const char*>(buffer.data()), buffer.size()));
}

}  // namespace

ByteImage display_image(const Image& linear, double exposure_ev) {
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  ByteImage out{linear.width_px, linear.height_px, linear.channels, {}};
  out.values.reserve(linear.values.size());
  for (const float value : linear.values)
    out.values.push_back(code_from_display(srgb_from_linear(value * gain)));
  return out;
}

Image read_float_image(const fs::path& path) {
  if (const auto input = open_image(path); !input->spec().format.is_floating_point())
    throw input_error({.file = path.string(),
                       .wanted = "an image of floating-point values",
                       .found = input->spec().format.c_str()});
  return read_image(path);
}

Image read_image(const fs::path& path) {
  const auto input = open_image(path);
  const OIIO::ImageSpec spec = input->spec();
  Image image(spec.width, spec.height, spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
    throw input_error(
        {.file = path.string(), .wanted = "an image that can be decoded", .found = input->geterror()});
  if (!spec.format.is_floating_point())
    for (float& value : image.values) value = linear_from_srgb(value);
  return image;
}

ByteImage read_bytes_image(const fs::path& path) {
  const auto input = open_image(path);
  const OIIO::ImageSpec spec = input->spec();
  ByteImage image{spec.width, spec.height, spec.nchannels, {}};
  image.values.resize(static_cast<std::size_t>(spec.image_pixels()) *
                      static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.values.data()))
    throw input_error(
        {.file = path.string(), .wanted = "an image that can be decoded", .found = input->geterror()});
  return image;
}

void write_exr(const fs::path& path, const Image& image) {
  OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::FLOAT);
  if (image.channels == 1) spec.channelnames = {"Y"};
  spec.attribute("compression", "zip");
  spec.attribute("oiio:ColorSpace", "Linear");
  write_image(path, spec, OIIO::TypeDesc::FLOAT, image.values.data());
}

void draw_text(ByteImage& image, int x, int y, const std::string& text, int height_px, std::uint8_t code) {
  static const std::string font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  if (!fs::exists(font)) return;
  const OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::UINT8);
  OIIO::ImageBuf buffer(spec, image.values.data());
  const float grey = static_cast<float>(code) / 255.0F;
  const std::vector<float> colour(static_cast<std::size_t>(image.channels), grey);
  OIIO::ImageBufAlgo::render_text(buffer, x, y, text, height_px, font, colour);
}

void write_png(const fs::path& path, const ByteImage& image) {
  OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write_image(path, spec, OIIO::TypeDesc::UINT8, image.values.data());
}

}  // namespace seamline
