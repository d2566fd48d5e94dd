#include "support/files/picture_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/files/open_picture.h"

namespace seamline {
namespace {

int bits_of(const CodedPicture& picture) {
  switch (picture.values) {
    case CodedPicture::Values::bytes:
      return 8;
    case CodedPicture::Values::words:
      return 16;
    case CodedPicture::Values::other_integers:
    case CodedPicture::Values::floats:
      return 32;
  }
  return 0;
}

template <class Value>
void take_whole(const OpenedPicture& opened, const std::filesystem::path& path, std::vector<float>& values) {
  std::vector<Value> whole(opened.values());
  decode(opened, whole.data(), path);
  values.assign(whole.begin(), whole.end());
}

void take_values(const OpenedPicture& opened, const std::filesystem::path& path, std::vector<float>& values) {
  if (opened.picture.values == CodedPicture::Values::bytes)
    return take_whole<std::uint8_t>(opened, path, values);
  if (opened.picture.values == CodedPicture::Values::words)
    return take_whole<std::uint16_t>(opened, path, values);
  values.resize(opened.values());
  decode(opened, values.data(), path);
  if (opened.picture.values != CodedPicture::Values::other_integers) return;
  // The library scales them so that the largest is 1.
  for (float& value : values)
    value = static_cast<float>(
        std::round(static_cast<double>(value) * std::numeric_limits<std::uint32_t>::max()));
}

}  // namespace

RawPicture read_raw_picture(const std::filesystem::path& path, const std::string& channel,
                            const std::function<void(const RawPicture&)>& accept) {
  return with_picture_errors(path, [&] {
    OpenedPicture opened = open_picture(path, true);
    const ChosenChannels chosen = depth_channel(channels_of(opened, path), channel, path.string());
    if (chosen.part != 0) open_part(opened, chosen.part, path);
    const CodedPicture& picture = opened.picture;
    RawPicture raw;
    raw.whole = picture.values != CodedPicture::Values::floats;
    raw.bits = bits_of(picture);
    raw.format = picture.format;
    raw.notes = chosen.notes;
    raw.image.width_px = picture.shown_width_px;
    raw.image.height_px = picture.shown_height_px;
    raw.image.channels = static_cast<int>(chosen.indices.size());
    if (accept) accept(raw);
    std::vector<float> values;
    take_values(opened, path, values);
    Image image(picture.width_px, picture.height_px, raw.image.channels);
    const auto from = static_cast<std::size_t>(picture.channels), to = chosen.indices.size();
    for (std::size_t pixel = 0; pixel * to < image.values.size(); ++pixel)
      for (std::size_t c = 0; c < to; ++c)
        image.values[pixel * to + c] = values[pixel * from + static_cast<std::size_t>(chosen.indices[c])];
    const int shown_width_px = picture.shown_width_px, shown_height_px = picture.shown_height_px;
    const int covered_x = std::max(
        0, std::min(picture.left_px + picture.width_px, shown_width_px) - std::max(0, picture.left_px));
    const int covered_y = std::max(
        0, std::min(picture.top_px + picture.height_px, shown_height_px) - std::max(0, picture.top_px));
    raw.beyond = static_cast<std::size_t>(shown_width_px) * static_cast<std::size_t>(shown_height_px) -
                 static_cast<std::size_t>(covered_x) * static_cast<std::size_t>(covered_y);
    raw.image = in_window(image, picture.left_px, picture.top_px, shown_width_px, shown_height_px,
                          std::numeric_limits<float>::quiet_NaN());
    return raw;
  });
}

}  // namespace seamline
