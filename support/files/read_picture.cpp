#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "support/codec/colour_profile.h"
#include "support/files/image.h"
#include "support/files/open_picture.h"
#include "support/files/picture_file.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

/// The chosen channels of a picture that has `channels`.
Image selected(const Image& all, const std::vector<int>& indices) {
  Image out(all.width_px, all.height_px, static_cast<int>(indices.size()));
  const auto from = static_cast<std::size_t>(all.channels), to = indices.size();
  for (std::size_t pixel = 0; pixel * to < out.values.size(); ++pixel)
    for (std::size_t c = 0; c < to; ++c)
      out.values[pixel * to + c] = all.values[pixel * from + static_cast<std::size_t>(indices[c])];
  return out;
}

bool are_all(const Image& image, const std::vector<int>& indices) {
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] != static_cast<int>(i)) return false;
  return static_cast<int>(indices.size()) == image.channels;
}

void note_alpha(const Image& all, int alpha, PictureFile& file) {
  std::size_t clear = 0;
  for (std::size_t i = static_cast<std::size_t>(alpha); i < all.values.size();
       i += static_cast<std::size_t>(all.channels))
    clear += all.values[i] < 1.0F ? 1 : 0;
  if (clear > 0)
    file.notes.push_back(fmt::format(
        "{} of its pixels are not opaque and are taken as they lie over black: alpha is not used", clear));
}

/// Radiance of what a Radiance file stores.
void undo_exposure(const HdrHeader& hdr, PictureFile& file) {
  if (hdr.exposure == 1 && hdr.colour_correction == std::array<double, 3>{1, 1, 1}) return;
  for (std::size_t i = 0; i < file.image.values.size(); ++i)
    file.image.values[i] = static_cast<float>(static_cast<double>(file.image.values[i]) /
                                              (hdr.exposure * hdr.colour_correction[i % 3]));
  file.notes.push_back(fmt::format("radiance is its pixels divided by its EXPOSURE, {:g}", hdr.exposure));
}

/// Linear light of three channels in the primaries that a file states, in those of sRGB.
void convert_primaries(const std::array<float, 8>& stated, const std::string& what, PictureFile& file) {
  constexpr std::array<float, 8> srgb = {0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F};
  bool usual = true;
  for (std::size_t i = 0; i < srgb.size(); ++i) usual = usual && std::abs(stated[i] - srgb[i]) < 1e-3F;
  if (usual || file.image.channels != 3) return;
  std::array<double, 9> m{};
  if (!ColourProfile::matrix_of(stated, m)) {
    file.notes.push_back(fmt::format("its {} are no colours and are not used", what));
    return;
  }
  std::vector<float>& values = file.image.values;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    const std::array<double, 3> from = {values[i], values[i + 1], values[i + 2]};
    for (std::size_t c = 0; c < 3; ++c)
      values[i + c] =
          static_cast<float>(m[3 * c] * from[0] + m[3 * c + 1] * from[1] + m[3 * c + 2] * from[2]);
  }
  file.converted = true;
  file.notes.push_back(fmt::format(
      "its {} (red {:.4g} {:.4g}, green {:.4g} {:.4g}, blue {:.4g} {:.4g}, white {:.4g} {:.4g}) are converted to "
      "those of sRGB",
      what, stated[0], stated[1], stated[2], stated[3], stated[4], stated[5], stated[6], stated[7]));
}

/// CIE XYZ as light of sRGB's primaries.
void convert_primaries_of(const HdrHeader& hdr, PictureFile& file) {
  if (hdr.xyz) {
    // XYZ are primaries at the corners of the diagram; the white is sRGB's, so that no colour is adapted.
    constexpr std::array<double, 9> srgb_from_xyz = {3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108,
                                                     0.0415560, 0.0556434,  -0.2040259, 1.0572252};
    std::vector<float>& values = file.image.values;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
      const std::array<double, 3> from = {values[i], values[i + 1], values[i + 2]};
      for (std::size_t c = 0; c < 3; ++c)
        values[i + c] =
            static_cast<float>(srgb_from_xyz[3 * c] * from[0] + srgb_from_xyz[3 * c + 1] * from[1] +
                               srgb_from_xyz[3 * c + 2] * from[2]);
    }
    file.converted = true;
    file.notes.emplace_back("its CIE XYZ are converted to sRGB's primaries; Y is the unit of light");
  } else if (hdr.primaries) {
    convert_primaries(*hdr.primaries, "PRIMARIES", file);
  }
}

/// Codes as linear light: by the embedded profile where there is another one than sRGB.
void decode_codes(const CodedPicture& picture, PictureFile& file) {
  std::vector<float>& values = file.image.values;
  std::string complaint;
  if (!picture.profile.empty() && file.image.channels == 3)
    file.profile = ColourProfile::of(picture.profile, complaint);
  if (!complaint.empty()) file.notes.push_back("it has " + complaint + ": it is taken as sRGB");
  if (!file.profile) {
    for (float& value : values) value = linear_from_srgb(value);
    return;
  }
  file.profile->to_linear(values.data(), values.size() / 3);
  const auto outside =
      std::count_if(values.begin(), values.end(), [](float value) { return value < -1e-4F; });
  file.notes.push_back(fmt::format("its colours are those of its ICC profile, {}{}",
                                   printable(file.profile->name()),
                                   outside > 0 ? "; some are beyond sRGB" : ""));
}

std::string window_note(const CodedPicture& picture) {
  return fmt::format(
      "its pixels, {} x {} at ({}, {}), are brought into its display window, {} x {}: what is missing is "
      "black, what is beyond is left out",
      picture.width_px, picture.height_px, picture.left_px, picture.top_px, picture.shown_width_px,
      picture.shown_height_px);
}

}  // namespace

Image in_window(const Image& image, int left_px, int top_px, int width_px, int height_px, float beyond) {
  if (left_px == 0 && top_px == 0 && width_px == image.width_px && height_px == image.height_px) return image;
  Image out(width_px, height_px, image.channels, beyond);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const std::int64_t from_x = std::int64_t{x} - left_px, from_y = std::int64_t{y} - top_px;
      if (from_x < 0 || from_x >= image.width_px || from_y < 0 || from_y >= image.height_px) continue;
      for (int c = 0; c < image.channels; ++c)
        out.at(x, y, c) = image.at(static_cast<int>(from_x), static_cast<int>(from_y), c);
    }
  return out;
}

Image upright(const Image& image, int orientation) {
  if (orientation < 2 || orientation > 8) return image;
  // What the file's rows and columns are, by EXIF: row 0 is the visual top, or right, or so.
  const bool turned = orientation >= 5;
  const int width = turned ? image.height_px : image.width_px,
            height = turned ? image.width_px : image.height_px;
  Image out(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int from_x = turned ? y : x, from_y = turned ? x : y;
      if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
        from_x = image.width_px - 1 - from_x;
      if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
        from_y = image.height_px - 1 - from_y;
      for (int c = 0; c < image.channels; ++c) out.at(x, y, c) = image.at(from_x, from_y, c);
    }
  return out;
}

PictureFile read_picture(const fs::path& path, const std::function<void(const ImageHeader&)>& accept,
                         const std::string& layer) {
  return with_picture_errors(path, [&] {
    OpenedPicture opened = open_picture(path);
    const ChosenChannels chosen = colour_channels(channels_of(opened, path), layer, path.string());
    if (chosen.part != 0) open_part(opened, chosen.part, path);
    const CodedPicture& picture = opened.picture;
    PictureFile file;
    file.floating_point = picture.values == CodedPicture::Values::floats;
    file.orientation = picture.orientation;
    file.notes = chosen.notes;
    const bool turned = picture.orientation >= 5 && picture.orientation <= 8;
    ImageHeader header{picture.shown_width_px, picture.shown_height_px,
                       static_cast<int>(chosen.indices.size()), file.floating_point, picture.orientation};
    if (turned) std::swap(header.width_px, header.height_px);
    if (accept) accept(header);
    file.image = Image(picture.width_px, picture.height_px, picture.channels);
    decode(opened, file.image.values.data(), path);
    if (chosen.alpha >= 0) note_alpha(file.image, chosen.alpha, file);
    if (!are_all(file.image, chosen.indices)) file.image = selected(file.image, chosen.indices);
    if (!file.floating_point) decode_codes(picture, file);
    if (picture.chromaticities) convert_primaries(*picture.chromaticities, "chromaticities", file);
    if (picture.format == "hdr") {
      undo_exposure(opened.hdr, file);
      convert_primaries_of(opened.hdr, file);
    }
    if (picture.left_px != 0 || picture.top_px != 0 || picture.width_px != picture.shown_width_px ||
        picture.height_px != picture.shown_height_px) {
      file.image = in_window(file.image, picture.left_px, picture.top_px, picture.shown_width_px,
                             picture.shown_height_px);
      file.notes.push_back(window_note(picture));
    }
    if (picture.orientation != 1) file.image = upright(file.image, picture.orientation);
    return file;
  });
}

namespace {

/// Of colours that other primaries can make and sRGB's cannot.
void drop_negative_parts(PictureFile& file) {
  constexpr float rounding = -1e-4F;
  std::vector<float>& values = file.image.values;
  const auto beyond = std::count_if(values.begin(), values.end(), [](float v) { return v < rounding; });
  for (float& value : values)
    if (value < 0) value = 0;
  if (beyond > 0)
    file.notes.push_back(fmt::format(
        "{:.2g} % of its numbers are negative in sRGB's primaries, which cannot make these colours: they are 0",
        100.0 * static_cast<double>(beyond) / static_cast<double>(values.size())));
}

}  // namespace

Image read_image(const fs::path& path, const std::function<void(const ImageHeader&)>& accept) {
  PictureFile file = read_picture(path, accept);
  if (file.converted) drop_negative_parts(file);
  for (const std::string& note : file.notes)
    fmt::print(stderr, "note: {}: {}\n", printable(path.string()), note);
  return std::move(file.image);
}

namespace {

std::uint8_t code_of_share(float share) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0F, 1.0F)));
}

}  // namespace

void write_png(const fs::path& path, const Image& linear, double exposure_ev, const ColourProfile* profile) {
  if (!profile || linear.channels != 3) return write_png(path, display_image(linear, exposure_ev));
  require_numbers(linear);
  const float gain = static_cast<float>(std::exp2(exposure_ev));
  std::vector<float> codes = linear.values;
  for (float& value : codes) value *= gain;
  profile->from_linear(codes.data(), codes.size() / 3);
  ByteImage picture{linear.width_px, linear.height_px, linear.channels, {}};
  picture.values.reserve(codes.size());
  for (const float code : codes) picture.values.push_back(code_of_share(code));
  write_png(path, picture, profile->bytes());
}

}  // namespace seamline
