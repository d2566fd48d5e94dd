#include "support/codec/plain_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <thread>

#include "support/codec/plain_pictures.h"

namespace seamline {
namespace {

using ChannelNames = std::vector<std::string>;

/// Threads that pack or unpack: none beside the caller's for a picture that is done sooner than they start.
int threads_for(std::size_t values) {
  constexpr std::size_t worth_threads = 1U << 21U;
  if (values < worth_threads) return 0;
  static const int threads = [] {
    const int count = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    Imf::setGlobalThreadCount(count);
    return count;
  }();
  return threads;
}

/// One part in scan lines, no deep pixels, no long names: the flags of the file's version field.
bool is_one_part_in_scan_lines(const std::string& path) {
  std::array<char, 8> start{};
  std::ifstream in(path, std::ios::binary);
  in.read(start.data(), start.size());
  return in.good() && start[4] == 2 && start[5] == 0 && start[6] == 0 && start[7] == 0;
}

const char* name_of(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return "none";
    case Imf::RLE_COMPRESSION:
      return "rle";
    case Imf::ZIPS_COMPRESSION:
      return "zips";
    case Imf::ZIP_COMPRESSION:
      return "zip";
    case Imf::PIZ_COMPRESSION:
      return "piz";
    default:
      return nullptr;
  }
}

/// In the order of the picture's channels; none: no plain picture.
ChannelNames plain_channels(const Imf::Header& header) {
  ChannelNames names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
    const Imf::Channel& is = channel.channel();
    if (is.xSampling != 1 || is.ySampling != 1 || is.type == Imf::UINT) return {};
    names.emplace_back(channel.name());
  }
  if (names.size() == 1) return names;
  if (names == ChannelNames{"B", "G", "R"}) return {"R", "G", "B"};
  return {};
}

/// Luminance and chroma of every other pixel, in which OpenEXR has a way to keep pictures small.
bool is_luminance_chroma(const Imf::Header& header) {
  const Imf::ChannelList& channels = header.channels();
  return channels.findChannel("Y") && channels.findChannel("RY") && channels.findChannel("BY");
}

/// Slices of rows from `first` on, which lie at `values`, channels interleaved.
Imf::FrameBuffer slices(const ChannelNames& names, const float* values, const Imath::Box2i& window,
                        int first) {
  const std::size_t channels = names.size();
  const std::size_t width_px =
      static_cast<std::size_t>(window.max.x) - static_cast<std::size_t>(window.min.x) + 1;
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < channels; ++c)
    buffer.insert(names[c], Imf::Slice::Make(Imf::FLOAT, values + c, Imath::V2i(window.min.x, first),
                                             static_cast<std::int64_t>(width_px), 1, sizeof(float) * channels,
                                             sizeof(float) * channels * width_px));
  return buffer;
}

/// As the picture library makes codes of floats: 1 is the last code, and what is no number the first.
template <class Code>
Code code_of(float value) {
  constexpr float last = std::numeric_limits<Code>::max();
  const float scaled = value * last + 0.5F;
  return scaled > 0 ? static_cast<Code>(std::min(scaled, last)) : Code{0};
}

class ExrReader final : public PictureReader {
 public:
  std::string open(const std::string& path) override {
    if (!is_one_part_in_scan_lines(path)) return not_plain;
    header_ = Imf::InputFile(path.c_str(), 0).header();
    chroma_ = is_luminance_chroma(header_);
    names_ = chroma_ ? ChannelNames{"R", "G", "B"} : plain_channels(header_);
    path_ = path;
    const bool turned = header_.findTypedAttribute<Imf::IntAttribute>("Orientation") != nullptr;
    const bool coloured = Imf::hasChromaticities(header_) && !chroma_;
    return names_.empty() || turned || coloured || (!chroma_ && !name_of(header_.compression())) ? not_plain
                                                                                                 : "";
  }
  std::string open(std::string_view) override { return not_plain; }

  CodedPicture picture() const override {
    CodedPicture picture;
    const Imath::Box2i& window = header_.dataWindow();
    picture.width_px = window.max.x - window.min.x + 1;
    picture.height_px = window.max.y - window.min.y + 1;
    picture.channels = static_cast<int>(names_.size());
    picture.values = CodedPicture::Values::floats;
    if (const char* packing = name_of(header_.compression())) picture.compression = packing;
    std::uint64_t pixel_bytes = 0;
    if (chroma_) pixel_bytes = 2;
    for (const std::string& name : chroma_ ? ChannelNames{} : names_)
      pixel_bytes += header_.channels()[name].type == Imf::HALF ? 2 : 4;
    picture.bytes = pixel_bytes * static_cast<std::uint64_t>(picture.width_px) *
                    static_cast<std::uint64_t>(picture.height_px);
    picture.format = "openexr";
    picture.channel_names = names_;
    if (chroma_ && Imf::hasChromaticities(header_)) {
      const Imf::Chromaticities& c = Imf::chromaticities(header_);
      picture.chromaticities = {c.red.x,  c.red.y,  c.green.x, c.green.y,
                                c.blue.x, c.blue.y, c.white.x, c.white.y};
    }
    const Imath::Box2i& shown = header_.displayWindow();
    picture.left_px = window.min.x - shown.min.x;
    picture.top_px = window.min.y - shown.min.y;
    picture.shown_width_px = shown.max.x - shown.min.x + 1;
    picture.shown_height_px = shown.max.y - shown.min.y + 1;
    return picture;
  }

  std::string read(float* values, bool (*stop)()) override {
    const CodedPicture is = picture();
    if (chroma_) return read_luminance_chroma(is, values, stop);
    const std::size_t row_values = static_cast<std::size_t>(is.width_px) * names_.size();
    Imf::InputFile file(path_.c_str(), threads_for(row_values * static_cast<std::size_t>(is.height_px)));
    const Imath::Box2i& window = header_.dataWindow();
    file.setFrameBuffer(slices(names_, values, window, window.min.y));
    for (int row = window.min.y; row <= window.max.y; row += rows_between_questions) {
      if (stop && stop()) return was_stopped;
      file.readPixels(row, std::min(row + rows_between_questions - 1, window.max.y));
    }
    return {};
  }

  std::string read(std::uint16_t* codes, bool (*stop)()) override { return read_codes(codes, stop); }
  std::string read(std::uint8_t* codes, bool (*stop)()) override { return read_codes(codes, stop); }

 private:
  template <class Code>
  std::string read_codes(Code* codes, bool (*stop)()) {
    const CodedPicture is = picture();
    std::vector<float> values(static_cast<std::size_t>(is.width_px) * static_cast<std::size_t>(is.height_px) *
                              names_.size());
    const std::string complaint = read(values.data(), stop);
    std::transform(values.begin(), values.end(), codes, code_of<Code>);
    return complaint;
  }

  /// By OpenEXR's own way, which brings chroma between its pixels.
  std::string read_luminance_chroma(const CodedPicture& is, float* values, bool (*stop)()) {
    Imf::RgbaInputFile file(path_.c_str());
    const Imath::Box2i& window = header_.dataWindow();
    const auto width = static_cast<std::size_t>(is.width_px);
    std::vector<Imf::Rgba> row(width);
    for (int y = window.min.y; y <= window.max.y; ++y) {
      if ((y - window.min.y) % rows_between_questions == 0 && stop && stop()) return was_stopped;
      file.setFrameBuffer(row.data() - window.min.x - static_cast<std::ptrdiff_t>(y) * is.width_px, 1, width);
      file.readPixels(y);
      for (const Imf::Rgba& pixel : row) {
        *values++ = pixel.r;
        *values++ = pixel.g;
        *values++ = pixel.b;
      }
    }
    return {};
  }

  std::string path_;
  Imf::Header header_;
  ChannelNames names_;
  bool chroma_ = false;
};

/// Bytes in memory: a picture that a full disk cut short would pass for a finished one.
class Bytes final : public Imf::OStream {
 public:
  Bytes() : OStream("picture.exr") {}

  void write(const char from[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (at_ + size > bytes.size()) bytes.resize(at_ + size);
    std::memcpy(bytes.data() + at_, from, size);
    at_ += size;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t to) override { at_ = static_cast<std::size_t>(to); }

  std::vector<unsigned char> bytes;

 private:
  std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<PictureReader> plain_exr_reader() {
  return std::make_unique<ExrReader>();
}

std::vector<unsigned char> encode_plain_exr(const PictureToEncode& picture, bool (*stop)(),
                                            std::string& complaint) {
  const ChannelNames names = picture.channels == 1 ? ChannelNames{"Y"} : ChannelNames{"R", "G", "B"};
  Imf::Header header(picture.width_px, picture.height_px);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.insert("capDate", Imf::StringAttribute(""));  // no time of day
  for (const std::string& name : names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  Bytes bytes;
  {
    const std::size_t values = static_cast<std::size_t>(picture.width_px) *
                               static_cast<std::size_t>(picture.height_px) * names.size();
    Imf::OutputFile file(bytes, header, threads_for(values));
    file.setFrameBuffer(slices(names, picture.floats, header.dataWindow(), 0));
    for (int row = 0; row < picture.height_px; row += rows_between_questions) {
      if (stop && stop()) {
        complaint = was_stopped;
        break;
      }
      file.writePixels(std::min(rows_between_questions, picture.height_px - row));
    }
  }
  return std::move(bytes.bytes);
}

}  // namespace seamline
