#include "support/codec/plain_pictures.h"

#include "support/codec/plain_exr.h"
#include "support/codec/plain_png.h"

namespace seamline {

std::unique_ptr<PictureReader> plain_reader(const std::string& format) {
  if (format == "png") return plain_png_reader();
  if (format == "openexr") return plain_exr_reader();
  return nullptr;
}

bool is_plain(const PictureToEncode& picture) {
  const bool grey_or_rgb = picture.channels == 1 || picture.channels == 3;
  const bool known =
      (picture.codes && picture.extension == ".png") || (picture.floats && picture.extension == ".exr");
  return grey_or_rgb && known && picture.width_px >= 1 && picture.height_px >= 1;
}

std::vector<unsigned char> encode_plain(const PictureToEncode& picture, bool (*stop)(),
                                        std::string& complaint) {
  return picture.codes ? encode_plain_png(picture, stop, complaint)
                       : encode_plain_exr(picture, stop, complaint);
}

}  // namespace seamline
