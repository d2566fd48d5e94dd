#include "support/codec/plain_pictures.h"

#include "support/codec/plain_encoders.h"

namespace seamline {

std::optional<std::vector<unsigned char>> encode_plain(const PictureToEncode& picture, bool (*stop)()) {
  const bool grey_or_rgb = picture.channels == 1 || picture.channels == 3;
  if (!grey_or_rgb || picture.width_px < 1 || picture.height_px < 1) return {};
  if (picture.codes && picture.extension == ".png") return encode_plain_png(picture, stop);
  if (picture.floats && picture.extension == ".exr") return encode_plain_exr(picture, stop);
  return {};
}

}  // namespace seamline
