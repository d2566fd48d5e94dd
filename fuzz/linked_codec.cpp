// Pictures for the fuzz targets: the codec is linked, not loaded, so that its bytes are watched as well.
#include "support/files/picture_library.h"

namespace seamline {

const PictureCodec& picture_codec() {
  return *seamline_picture_codec(SEAMLINE_VERSION_TEXT);
}

}  // namespace seamline
