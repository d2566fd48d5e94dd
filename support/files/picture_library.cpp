#include "support/files/picture_library.h"

#include <dlfcn.h>

#include "support/files/assets.h"
#include "support/text/error.h"

namespace seamline {
namespace {

const PictureCodec& load() {
  const std::string path = picture_codec_file().string();
  const auto refuse = [&](const std::string& found) {
    return input_error(
        {.file = path, .wanted = "Seamline's own library for pictures (install it again)", .found = found});
  };
  // Never closed: what it returns lives as long as the program.
  void* library = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!library) {
    const char* why = dlerror();
    throw refuse(why ? why : "none");
  }
  const auto codec =
      reinterpret_cast<decltype(&seamline_picture_codec)>(dlsym(library, "seamline_picture_codec"));
  if (!codec) throw refuse("another library");
  const PictureCodec* loaded = codec(program_version().c_str());
  if (!loaded) throw refuse("one of another version of Seamline");
  return *loaded;
}

}  // namespace

const PictureCodec& picture_codec() {
  static const PictureCodec& codec = load();
  return codec;
}

}  // namespace seamline
