#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace seamline {

/// What the pixels of a picture file are, as its header says.
struct CodedPicture {
  enum class Values { bytes, words, other_integers, floats };

  int width_px = 0, height_px = 0, channels = 0;
  bool flat = true;  ///< no deep pixels, no third dimension
  Values values = Values::bytes;
  std::string compression;  ///< as the library names it, e.g. "zip"; may be empty
  std::uint64_t bytes = 0;  ///< of all its pixels, as they are in the file
  std::string format;       ///< openexr, png, jpeg, hdr, tiff
  int orientation = 1;      ///< EXIF's, 1 to 8

  std::vector<std::string> channel_names = {};  ///< as the file has them, or as the library calls them
  /// Where the pixels lie in the picture that is to be shown, EXR's display window, and how large that is.
  int left_px = 0, top_px = 0, shown_width_px = 0, shown_height_px = 0;
  std::string profile = {};  ///< an embedded ICC profile; empty: none
  /// x and y of red, green, blue and white that an EXR file states.
  std::optional<std::array<float, 8>> chromaticities = {};
  std::vector<std::string> parts =
      {};  ///< names of a file's parts where it has several, of which one is open

  bool operator==(const CodedPicture&) const = default;
};

/// One picture that is being read. Its functions may throw what image libraries throw at damaged bytes.
class PictureReader {
 public:
  PictureReader() = default;
  PictureReader(const PictureReader&) = delete;
  PictureReader& operator=(const PictureReader&) = delete;
  virtual ~PictureReader() = default;

  /// Reads the header. Returns a complaint, empty when there is none.
  [[nodiscard]] virtual std::string open(const std::string& path) = 0;
  /// The same of bytes in memory, which live longer than the reader.
  [[nodiscard]] virtual std::string open(std::string_view bytes) = 0;
  /// Goes on to another part of an open file. Returns a complaint, empty when there is none.
  [[nodiscard]] virtual std::string open_part(int) { return "a file of one part"; }
  [[nodiscard]] virtual CodedPicture picture() const = 0;
  /// Decodes all pixels: rows from the top, channels interleaved, integers scaled to the type that is wanted.
  /// `stop` is asked between pieces. Returns a complaint, empty when there is none.
  [[nodiscard]] virtual std::string read(float* values, bool (*stop)()) = 0;
  [[nodiscard]] virtual std::string read(std::uint16_t* values, bool (*stop)()) = 0;
  [[nodiscard]] virtual std::string read(std::uint8_t* values, bool (*stop)()) = 0;
};

/// A channel-interleaved picture to be encoded.
struct PictureToEncode {
  std::string extension;  ///< ".exr", ".png"
  int width_px = 0, height_px = 0, channels = 0;
  const float* floats = nullptr;        ///< these,
  const std::uint8_t* codes = nullptr;  ///< or these, which are sRGB, or
  std::string_view profile = {};        ///< of this ICC profile, which a PNG file embeds
};

/// A part of a file of several.
struct NamedPart {
  std::string name;
  PictureToEncode picture;
};

/// What decodes and encodes pictures. It lies in a library of its own, which is loaded by the first picture
/// that is not plain (`plain_pictures.h`): it draws in some 250 others, which take half a second.
class PictureCodec {
 public:
  PictureCodec() = default;
  PictureCodec(const PictureCodec&) = delete;
  PictureCodec& operator=(const PictureCodec&) = delete;
  virtual ~PictureCodec() = default;

  /// `format` is openexr, png, jpeg, hdr or tiff. With `alpha_apart`, colours are not multiplied by alpha.
  [[nodiscard]] virtual std::unique_ptr<PictureReader> reader(const std::string& format,
                                                              bool alpha_apart) const = 0;
  /// The file's bytes: without any date, the same for the same picture. Sets `complaint` when it cannot.
  [[nodiscard]] virtual std::vector<unsigned char> encode(const PictureToEncode& picture, bool (*stop)(),
                                                          std::string& complaint) const = 0;
  /// Writes pictures of floats as the named parts of one EXR file, and reads the last of them again: the
  /// library has no other way for several parts than a file. Without any date. Returns a complaint, empty
  /// when there is none.
  [[nodiscard]] virtual std::string write_parts(const std::string& path, const std::vector<NamedPart>& parts,
                                                bool (*stop)()) const = 0;
  /// Draws one line of text in a grey code, its baseline starting at (x, y).
  virtual void draw_text(const PictureToEncode& picture, std::uint8_t* codes, int x, int y,
                         const std::string& text, int height_px, const std::string& font,
                         std::uint8_t code) const = 0;
};

}  // namespace seamline

/// What the codec's library hands out; null for another version of Seamline.
extern "C" const seamline::PictureCodec* seamline_picture_codec(const char* version);
