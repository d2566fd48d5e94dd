#include "support/codec/plain_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
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
    names_ = plain_channels(header_);
    path_ = path;
    const bool turned = header_.findTypedAttribute<Imf::IntAttribute>("Orientation") != nullptr;
    return names_.empty() || turned || !name_of(header_.compression()) ? not_plain : "";
  }
  std::string open(std::string_view) override { return not_plain; }

  CodedPicture picture() const override {
    CodedPicture picture;
    const Imath::Box2i& window = header_.dataWindow();
    picture.width_px = window.max.x - window.min.x + 1;
    picture.height_px = window.max.y - window.min.y + 1;
    picture.channels = static_cast<int>(names_.size());
    picture.values = CodedPicture::Values::floats;
    picture.compression = name_of(header_.compression());
    std::uint64_t pixel_bytes = 0;
    for (const std::string& name : names_) pixel_bytes += header_.channels()[name].type == Imf::HALF ? 2 : 4;
    picture.bytes = pixel_bytes * static_cast<std::uint64_t>(picture.width_px) *
                    static_cast<std::uint64_t>(picture.height_px);
    picture.format = "openexr";
    return picture;
  }

  std::string read(float* values, bool (*stop)()) override {
    const CodedPicture is = picture();
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

  std::string path_;
  Imf::Header header_;
  ChannelNames names_;
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
