#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "support/files/image.h"

namespace seamline {

class ColourProfile;

/// A picture as other people's programs leave it, and what is to be said about it.
struct PictureFile {
  Image image;                  ///< upright; linear
  bool floating_point = false;  ///< EXR, HDR: the values are as they are meant, not sRGB codes
  int orientation = 1;          ///< EXIF's, by which it was turned upright
  std::shared_ptr<const ColourProfile> profile;  ///< embedded, if it is another than sRGB
  bool converted = false;          ///< from other primaries: a colour beyond sRGB's has a negative part
  std::vector<std::string> notes;  ///< sentences without the file's name
};

/// Reads EXR, HDR, PNG, JPEG or TIFF as float. 8- and 16-bit pictures are decoded from sRGB to linear. Of an
/// EXR file the colours of a layer are read (`colour_channels`; `layer`: that one) into its display window;
/// other channels of a picture are left out. A Radiance file's values are divided by its exposure. Pictures
/// are turned upright. `accept` sees the header of what will be returned first and throws InputError at a
/// picture that is not wanted, so that no memory is taken for it. Throws InputError naming the file.
/// `read_image` is the same picture alone, with what is to be said on standard error; there a colour beyond
/// sRGB's primaries has 0 for its negative part, which is said.
[[nodiscard]] PictureFile read_picture(const std::filesystem::path& path,
                                       const std::function<void(const ImageHeader&)>& accept = {},
                                       const std::string& layer = {});

/// What is measured and not looked at: a picture's values as its file has them, without a display curve,
/// scaling, multiplied alpha or turning.
struct RawPicture {
  Image image;         ///< of an EXR file's display window; 1 channel, or 3 where no one is depth by its name
  bool whole = false;  ///< whole numbers
  int bits = 0;        ///< of each
  std::string format;  ///< openexr, png, jpeg, hdr, tiff
  std::size_t beyond = 0;  ///< pixels of the display window that the file does not have: no number
  std::vector<std::string> notes;
};

/// Reads EXR, PNG, JPEG, HDR or TIFF raw. `channel`: its name; empty: the one of depth (`depth_channel`).
/// `accept` sees everything but the values first, and throws InputError at a picture that is not wanted.
/// Throws InputError naming the file.
[[nodiscard]] RawPicture read_raw_picture(const std::filesystem::path& path, const std::string& channel,
                                          const std::function<void(const RawPicture&)>& accept = {});

/// A picture that lies at a place of a larger or smaller one; what is missing there is `beyond`.
[[nodiscard]] Image in_window(const Image& image, int left_px, int top_px, int width_px, int height_px,
                              float beyond = 0.0F);

/// Writes linear light as an 8-bit PNG, atomically: as codes of a profile, which is embedded; null: sRGB, as
/// `display_image` makes it.
void write_png(const std::filesystem::path& path, const Image& linear, double exposure_ev,
               const ColourProfile* profile);
/// Writes codes of the profile whose bytes are given, as an 8-bit PNG that embeds it.
void write_png(const std::filesystem::path& path, const ByteImage& image, const std::string& profile);

}  // namespace seamline
