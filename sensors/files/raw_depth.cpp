#include "sensors/files/raw_depth.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

#include "sensors/files/number_arrays.h"
#include "sensors/files/pgm.h"
#include "support/files/picture_file.h"
#include "support/files/word_image.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::sensors {
namespace {

namespace fs = std::filesystem;
using AcceptRaw = std::function<void(const RawDepth&)>;

InputError wrong_file(const fs::path& path, const std::string& wanted, const std::string& found) {
  return input_error({.file = path.string(), .wanted = wanted, .found = found});
}

std::string channels_text(int channels) {
  return channels == 1 ? "one channel" : fmt::format("{} channels", channels);
}

/// Of so many pixels, whose values are not read yet.
RawDepth whole_numbers(int width_px, int height_px) {
  return {.width_px = width_px, .height_px = height_px, .values = {}, .whole = true, .notes = {}};
}

RawDepth raw_pgm(const fs::path& path, const RawDepthForm& form, const AcceptRaw& accept) {
  const Pgm pgm = read_pgm(path, [&](const Pgm& header) {
    if (header.largest <= 255 && !form.eight_bits)
      throw wrong_file(path, "depths of 16 bits", fmt::format("8 bits (its maximum is {})", header.largest));
    if (accept) accept(whole_numbers(header.width_px, header.height_px));
  });
  RawDepth raw = whole_numbers(pgm.width_px, pgm.height_px);
  raw.bits = pgm.largest > 255 ? 16 : 8;
  raw.values.assign(pgm.values.begin(), pgm.values.end());
  return raw;
}

RawDepth raw_red_green(const fs::path& path, const AcceptRaw& accept) {
  const WordImage image = read_word_image(path, [&](const WordImage& header) {
    if (header.channels != 3 || header.bits != 8)
      throw wrong_file(path, "an RGB picture of 8 bits, whose red and green hold the depth",
                       fmt::format("{} of {} bits", channels_text(header.channels), header.bits));
    if (accept) accept(whole_numbers(header.width_px, header.height_px));
  });
  RawDepth raw = whole_numbers(image.width_px, image.height_px);
  raw.bits = 16;
  raw.values.reserve(image.values.size() / 3);
  for (std::size_t i = 0; i + 2 < image.values.size(); i += 3)
    raw.values.push_back(static_cast<float>(image.values[i] << 8 | image.values[i + 1]));
  return raw;
}

void require_kind(const fs::path& path, const RawPicture& picture, const RawDepthForm& form) {
  if (picture.format == "jpeg")
    throw wrong_file(path, "depth that was packed without loss (EXR, PNG, PFM, NPY, TIFF)", "a JPEG picture");
  if (picture.format == "hdr")
    throw wrong_file(path, "depth with more than 8 bits (EXR, PNG, PFM, NPY, TIFF)",
                     "a Radiance picture, whose numbers have 8");
  if (picture.whole && picture.bits < 16 && !form.eight_bits)
    throw wrong_file(path, "one channel of 16 bits",
                     fmt::format("{} of {} bits", channels_text(picture.image.channels), picture.bits));
}

/// Of colours whose channels are equal; of one channel itself.
std::vector<float> one_channel(const fs::path& path, Image image) {
  const std::size_t channels = image.channels;
  if (channels == 1) return std::move(image.values);
  std::vector<float> values(image.values.size() / channels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = image.values[i * channels];
    for (std::size_t c = 1; c < channels; ++c)
      if (const float other = image.values[i * channels + c];
          other != values[i] && !(std::isnan(other) && std::isnan(values[i])))
        throw wrong_file(
            path, "one channel of depth, or red, green and blue of equal values",
            fmt::format("{:g} and {:g} in pixel ({}, {}), as of a picture or of colours for depth", values[i],
                        other, i % static_cast<std::size_t>(image.width_px),
                        i / static_cast<std::size_t>(image.width_px)));
  }
  return values;
}

RawDepth raw_picture_depth(const fs::path& path, const RawDepthForm& form, const AcceptRaw& accept) {
  RawPicture picture = read_raw_picture(path, form.channel, [&](const RawPicture& header) {
    require_kind(path, header, form);
    if (accept)
      accept({.width_px = header.image.width_px,
              .height_px = header.image.height_px,
              .values = {},
              .whole = header.whole,
              .notes = {}});
  });
  RawDepth raw{.width_px = picture.image.width_px,
               .height_px = picture.image.height_px,
               .values = {},
               .whole = picture.whole,
               .bits = picture.bits,
               .beyond = picture.beyond,
               .notes = std::move(picture.notes)};
  if (picture.image.channels > 1) raw.notes.emplace_back("its red, green and blue are equal, and depth");
  raw.values = one_channel(path, std::move(picture.image));
  return raw;
}

/// What a file is that holds depth too, but several arrays or in a way that is not read.
std::string other_kind(std::string_view start) {
  if (start.starts_with("PK\x03\x04")) return "a ZIP or NPZ archive: save the one array as .npy";
  if (start.starts_with("\x89HDF")) return "an HDF5 or MATLAB file: save the one array as .npy";
  if (start.starts_with("MATLAB")) return "a MATLAB file: save the one array as .npy";
  if (start.starts_with("P2") || start.starts_with("P6")) return "another kind of PNM than PGM (P5)";
  return "another kind of file";
}

}  // namespace

RawDepth read_raw_depth(const fs::path& path, const RawDepthForm& form, const AcceptRaw& accept) {
  if (fs::is_directory(path))
    throw wrong_file(path, "the file of one depth map (EXR, PNG, PGM, TIFF, PFM, NPY or DPT)", "a folder");
  if (!fs::is_regular_file(path)) throw wrong_file(path, "a depth map", "no such file");
  std::array<char, 8> block{};
  std::ifstream in(path, std::ios::binary);
  in.read(block.data(), block.size());
  const std::string_view start(block.data(), static_cast<std::size_t>(in.gcount()));
  const bool is_pgm = start.starts_with("P5"), is_png = start.starts_with("\x89PNG");
  const ArrayKind kind = array_kind(start);
  if (form.packing == DepthPacking::red_green && !is_png)
    throw input_error({.file = path.string(),
                       .field = "packing",
                       .wanted = "an 8-bit PNG, whose red and green hold the depth",
                       .found = is_pgm                                  ? "a PGM file"
                                : start.starts_with("\x76\x2f\x31\x01") ? "an EXR file"
                                                                        : "another kind of file"});
  if (!form.channel.empty() && (is_pgm || kind != ArrayKind::none))
    throw input_error({.file = path.string(),
                       .field = request_name("depth_channel"),
                       .wanted = "a file whose channels have names",
                       .found = "an array without channels"});
  if (is_pgm) return raw_pgm(path, form, accept);
  if (kind != ArrayKind::none) return read_array(path, kind, accept);
  if (form.packing == DepthPacking::red_green) return raw_red_green(path, accept);
  constexpr std::string_view little("II*\0", 4), big("MM\0*", 4);
  const bool is_picture = is_png || start.starts_with("\x76\x2f\x31\x01") || start.starts_with(little) ||
                          start.starts_with(big) || start.starts_with("\xff\xd8\xff") ||
                          start.starts_with("#?");
  if (!is_picture)
    throw wrong_file(path, "an EXR, PNG, PGM (P5), TIFF, PFM, NPY or DPT file", other_kind(start));
  return raw_picture_depth(path, form, accept);
}

}  // namespace seamline::sensors
