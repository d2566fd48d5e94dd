#include "support/codec/hdr_header.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "support/text/error.h"

namespace seamline {
namespace {

constexpr std::size_t longest_hdr_header_bytes = 1U << 20U;

class HdrLines {
 public:
  explicit HdrLines(const std::filesystem::path& path) : path_(path), in_(path, std::ios::binary) {}

  std::string next() {
    std::string line;
    for (int letter = in_.get(); letter != '\n'; letter = in_.get()) {
      if (letter < 0 || ++at_ > longest_hdr_header_bytes)
        throw wrong("a whole HDR file", "one that ends in its header");
      line += static_cast<char>(letter);
    }
    ++at_;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    return line;
  }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] InputError wrong(const std::string& wanted, const std::string& found) const {
    return input_error({.file = path_.string(), .wanted = wanted, .found = found});
  }

 private:
  std::filesystem::path path_;
  std::ifstream in_;
  std::size_t at_ = 0;
};

/// `count` numbers of a line; none: it has others.
template <std::size_t count>
std::optional<std::array<double, count>> numbers_of(const std::string& text) {
  std::istringstream in(text);
  std::array<double, count> values{};
  for (double& value : values)
    if (!(in >> value) || !std::isfinite(value)) return std::nullopt;
  return values;
}

void take_hdr_line(const HdrLines& lines, const std::string& line, HdrHeader& header) {
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos) return;
  const std::string_view key(line.data(), equals);
  const std::string value = line.substr(equals + 1);
  if (key == "FORMAT") {
    if (value.find("32-bit_rle_rgbe") == std::string::npos &&
        value.find("32-bit_rle_xyze") == std::string::npos)
      throw lines.wrong("pixels as 32-bit_rle_rgbe or 32-bit_rle_xyze", value);
    header.xyz = value.find("xyze") != std::string::npos;
  } else if (key == "EXPOSURE") {
    const auto by = numbers_of<1>(value);
    if (!by || !((*by)[0] > 0)) throw lines.wrong("an EXPOSURE above 0", value);
    header.exposure *= (*by)[0];
  } else if (key == "COLORCORR") {
    const auto by = numbers_of<3>(value);
    if (!by || !((*by)[0] > 0 && (*by)[1] > 0 && (*by)[2] > 0))
      throw lines.wrong("a COLORCORR above 0", value);
    for (std::size_t c = 0; c < 3; ++c) header.colour_correction[c] *= (*by)[c];
  } else if (key == "PRIMARIES") {
    const auto places = numbers_of<8>(value);
    if (!places) throw lines.wrong("eight numbers as PRIMARIES", value);
    header.primaries.emplace();
    for (std::size_t i = 0; i < places->size(); ++i)
      (*header.primaries)[i] = static_cast<float>((*places)[i]);
  }
}

/// "-Y 480 +X 640": lines from the top, each from the left.
void take_hdr_size(const HdrLines& lines, const std::string& line, HdrHeader& header) {
  std::istringstream in(line);
  std::string first, second;
  if (!(in >> first >> header.lines >> second >> header.line_px) || header.lines < 1 || header.line_px < 1)
    throw lines.wrong("a size such as -Y 480 +X 640", line);
  // By EXIF: what the first line is, and then the first column.
  constexpr std::array<std::pair<std::string_view, int>, 8> orientations = {{{"-Y+X", 1},
                                                                             {"-Y-X", 2},
                                                                             {"+Y-X", 3},
                                                                             {"+Y+X", 4},
                                                                             {"+X-Y", 5},
                                                                             {"-X-Y", 6},
                                                                             {"-X+Y", 7},
                                                                             {"+X+Y", 8}}};
  for (const auto& [axes, orientation] : orientations)
    if (first + second == axes) {
      header.orientation = orientation;
      return;
    }
  throw lines.wrong("a size such as -Y 480 +X 640", line);
}

}  // namespace

HdrHeader read_hdr_header(const std::filesystem::path& path) {
  HdrLines lines(path);
  HdrHeader header;
  for (std::string line = lines.next(); !line.empty(); line = lines.next())
    take_hdr_line(lines, line, header);
  take_hdr_size(lines, lines.next(), header);
  header.pixels_at = lines.at();
  return header;
}

}  // namespace seamline
