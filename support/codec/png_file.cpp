#include "support/codec/png_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/text/error.h"

namespace seamline {
namespace {

constexpr std::uint64_t deflate_expansion = 1032;  ///< bytes out of each byte of deflate's, at most
constexpr std::size_t block_bytes = 1 << 16;

/// Rows of equal length: a whole picture, or one of the seven passes of an interlaced one.
struct Pass {
  std::uint64_t rows = 0, row_bytes = 0;  ///< with the byte that names the row's filter
};

struct Header {
  std::uint32_t width_px = 0, height_px = 0;
  unsigned bits = 0, colour = 0, interlaced = 0;

  [[nodiscard]] unsigned channels() const {
    return colour == 2 ? 3U : colour == 4 ? 2U : colour == 6 ? 4U : 1U;
  }
  [[nodiscard]] bool has_palette() const { return colour == 3; }
};

/// Which depths a colour type may have: ISO/IEC 15948, table 11.1.
bool is_possible(unsigned colour, unsigned bits) {
  const bool small = bits == 1 || bits == 2 || bits == 4;
  if (colour == 0) return small || bits == 8 || bits == 16;
  if (colour == 3) return small || bits == 8;
  return (colour == 2 || colour == 4 || colour == 6) && (bits == 8 || bits == 16);
}

std::vector<Pass> passes_of(const Header& header) {
  struct Grid {
    std::uint32_t left, top, step_x, step_y;
  };
  static constexpr std::array<Grid, 7> adam7 = {
      {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
  std::vector<Pass> passes;
  const auto add = [&](const Grid& grid) {
    if (header.width_px <= grid.left || header.height_px <= grid.top) return;
    const std::uint64_t columns =
        (std::uint64_t{header.width_px} - grid.left + grid.step_x - 1) / grid.step_x;
    const std::uint64_t rows = (std::uint64_t{header.height_px} - grid.top + grid.step_y - 1) / grid.step_y;
    passes.push_back({rows, 1 + (columns * header.channels() * header.bits + 7) / 8});
  };
  if (header.interlaced == 0)
    add({0, 0, 1, 1});
  else
    for (const Grid& grid : adam7) add(grid);
  return passes;
}

/// The pixels' bytes as they are unpacked: counted, and each row's filter looked at.
class Rows {
 public:
  explicit Rows(std::vector<Pass> passes) : passes_(std::move(passes)) { next_row(); }

  /// What is wrong with the next bytes; empty: nothing.
  std::string take(const unsigned char* bytes, std::size_t count) {
    for (std::size_t at = 0; at < count;) {
      if (row_left_ == 0) return "more pixels than its header says";
      if (row_left_ == passes_[pass_].row_bytes && bytes[at] > 4) return "a row of an unknown filter";
      const std::size_t step = static_cast<std::size_t>(std::min<std::uint64_t>(row_left_, count - at));
      at += step;
      row_left_ -= step;
      if (row_left_ == 0) {
        ++row_;
        next_row();
      }
    }
    return {};
  }
  [[nodiscard]] bool complete() const { return row_left_ == 0; }

 private:
  void next_row() {
    if (pass_ < passes_.size() && row_ == passes_[pass_].rows) {
      ++pass_;
      row_ = 0;
    }
    row_left_ = pass_ < passes_.size() ? passes_[pass_].row_bytes : 0;
  }

  std::vector<Pass> passes_;
  std::size_t pass_ = 0;
  std::uint64_t row_ = 0, row_left_ = 0;
};

/// zlib's stream of pixels, unpacked piece by piece.
class Pixels {
 public:
  explicit Pixels(std::vector<Pass> passes) : rows_(std::move(passes)), out_(block_bytes) {
    // The window that the stream itself names, as libpng has it.
    if (inflateInit2(&stream_, 0) != Z_OK) throw std::bad_alloc();
  }
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;
  ~Pixels() { inflateEnd(&stream_); }

  /// What is wrong with the next packed bytes; empty: nothing.
  std::string take(unsigned char* bytes, std::size_t count) {
    stream_.next_in = bytes;
    stream_.avail_in = static_cast<unsigned>(count);
    while (!ended_) {
      stream_.next_out = out_.data();
      stream_.avail_out = static_cast<unsigned>(out_.size());
      const int status = inflate(&stream_, Z_NO_FLUSH);
      if (const std::string wrong = rows_.take(out_.data(), out_.size() - stream_.avail_out); !wrong.empty())
        return wrong;
      if (status == Z_STREAM_END) ended_ = true;
      if (status == Z_BUF_ERROR) break;  // the next piece is needed
      if (status == Z_MEM_ERROR) throw std::bad_alloc();
      if (status != Z_OK && status != Z_STREAM_END) return "pixels that do not unpack";
    }
    return {};
  }
  [[nodiscard]] bool complete() const { return ended_ && rows_.complete(); }

 private:
  Rows rows_;
  std::vector<unsigned char> out_;
  z_stream stream_{};
  bool ended_ = false;
};

class PngFile {
 public:
  PngFile(std::istream& in, std::uint64_t size, std::string name)
      : name_(std::move(name)), in_(in), left_(size), size_(size), block_(block_bytes) {}

  void check() {
    read(8);  // the signature, which is known
    const Header header = read_header();
    const std::vector<Pass> passes = passes_of(header);
    std::uint64_t raw_bytes = 0;
    for (const Pass& pass : passes) raw_bytes += pass.rows * pass.row_bytes;
    if (raw_bytes / deflate_expansion > size_)
      throw input_error({.file = name_,
                         .wanted = fmt::format("a file that can hold {} x {} pixels with {} channels",
                                               header.width_px, header.height_px, header.channels()),
                         .found = fmt::format("{} bytes", size_)});
    Pixels pixels(passes);
    bool palette = false, begun = false;
    for (begin_chunk(); kind_ != "IEND"; begin_chunk()) {
      if (kind_ == "IDAT") {
        if (begun && before_ != "IDAT") throw damaged("pixels in two places");
        if (header.has_palette() && !palette) throw damaged("no palette");
        begun = true;
        chunk([&](std::size_t count) {
          if (const std::string wrong = pixels.take(block_.data(), count); !wrong.empty())
            throw damaged(wrong);
        });
      } else if (kind_ == "PLTE") {
        if (palette || begun || length_ == 0 || length_ > 768 || length_ % 3 != 0)
          throw damaged("a palette that is none");
        palette = true;
        chunk([](std::size_t) {});
      } else if ((static_cast<unsigned char>(kind_[0]) & 0x20U) == 0) {
        throw damaged("a part of an unknown kind");
      } else {
        skip();
      }
    }
    if (!pixels.complete()) throw damaged("fewer pixels than its header says");
  }

 private:
  [[nodiscard]] InputError damaged(const std::string& found) const {
    return input_error({.file = name_, .wanted = "a whole PNG file", .found = found});
  }

  /// The next bytes into the block's beginning; at most a block.
  void read(std::size_t count) {
    if (count > left_) throw damaged("one that ends early");
    in_.read(reinterpret_cast<char*>(block_.data()), static_cast<std::streamsize>(count));
    if (!in_) throw damaged("one that cannot be read");
    left_ -= count;
  }
  std::uint32_t number() {
    read(4);
    return number_at(0);
  }
  [[nodiscard]] std::uint32_t number_at(std::size_t at) const {
    return std::uint32_t{block_[at]} << 24 | std::uint32_t{block_[at + 1]} << 16 |
           std::uint32_t{block_[at + 2]} << 8 | std::uint32_t{block_[at + 3]};
  }

  void begin_chunk() {
    before_ = kind_;
    length_ = number();
    read(4);
    kind_.assign(reinterpret_cast<const char*>(block_.data()), 4);
    sum_ = crc32(0, block_.data(), 4);
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    if (!std::all_of(kind_.begin(), kind_.end(), is_letter)) throw damaged("a part of an unknown kind");
    if (std::uint64_t{length_} + 4 > left_) throw damaged("one that ends early");
  }

  /// Hands what the chunk holds to `use`, block by block, and checks its sum.
  template <class Use>
  void chunk(const Use& use) {
    for (std::uint32_t rest = length_; rest > 0;) {
      const std::size_t count = std::min<std::size_t>(rest, block_.size());
      read(count);
      sum_ = crc32(sum_, block_.data(), static_cast<unsigned>(count));
      use(count);
      rest -= static_cast<std::uint32_t>(count);
    }
    if (number() != sum_) throw damaged("a part whose sum is wrong");
  }
  void skip() {
    in_.seekg(static_cast<std::streamoff>(length_) + 4, std::ios::cur);
    left_ -= std::uint64_t{length_} + 4;
  }

  Header read_header() {
    begin_chunk();
    if (kind_ != "IHDR" || length_ != 13) throw damaged("no header");
    Header header;
    bool methods = true;
    chunk([&](std::size_t) {
      header = {number_at(0), number_at(4), block_[8], block_[9], block_[12]};
      methods = block_[10] == 0 && block_[11] == 0 && block_[12] <= 1;
    });
    const bool sides = header.width_px >= 1 && header.width_px < (1U << 31) && header.height_px >= 1 &&
                       header.height_px < (1U << 31);
    if (!methods || !sides || !is_possible(header.colour, header.bits))
      throw damaged("a header of no PNG picture");
    return header;
  }

  std::string name_;
  std::istream& in_;
  std::uint64_t left_, size_;
  std::vector<unsigned char> block_;
  std::string kind_, before_;
  std::uint32_t length_ = 0;
  unsigned long sum_ = 0;
};

}  // namespace

void check_png(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  PngFile(in, static_cast<std::uint64_t>(std::filesystem::file_size(path)), path.string()).check();
}

void check_png(std::string_view bytes, const std::string& name) {
  std::istringstream in{std::string(bytes)};
  PngFile(in, bytes.size(), name).check();
}

}  // namespace seamline
