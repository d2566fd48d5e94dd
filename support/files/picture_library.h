#pragma once
#include "support/codec/picture_codec.h"

namespace seamline {

/// Loads the codec at the first call: from `lib/seamline` of an installation, else from beside the program,
/// else from where it was built. Throws InputError when it is missing or another version's.
[[nodiscard]] const PictureCodec& picture_codec();

}  // namespace seamline
