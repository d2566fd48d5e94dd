#include "study/online/intake/zip_file.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>

#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace {

constexpr std::uint32_t local_signature = 0x04034b50, central_signature = 0x02014b50;
constexpr std::uint32_t end_signature = 0x06054b50, end64_signature = 0x06064b50,
                        locator64_signature = 0x07064b50;
constexpr std::size_t end_bytes = 22, locator64_bytes = 20, longest_comment = 65535;

/// What the table of contents says of a file.
struct ZipEntry {
  std::string name = {};
  unsigned flags = 0, method = 0;
  std::uint32_t crc32 = 0;
  std::uint64_t packed_bytes = 0, bytes = 0, at = 0;
};

class ZipReader {
 public:
  ZipReader(std::string_view bytes, const std::filesystem::path& archive)
      : bytes_(bytes), archive_(archive.string()) {}

  std::vector<ZipEntry> entries() const {
    const auto [count, begin] = contents();
    std::vector<ZipEntry> found;
    std::uint64_t at = begin;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (number(at, 4) != central_signature) throw damaged("no table of contents");
      ZipEntry entry{.flags = static_cast<unsigned>(number(at + 8, 2)),
                     .method = static_cast<unsigned>(number(at + 10, 2)),
                     .crc32 = static_cast<std::uint32_t>(number(at + 16, 4)),
                     .packed_bytes = number(at + 20, 4),
                     .bytes = number(at + 24, 4),
                     .at = number(at + 42, 4)};
      const std::uint64_t name_bytes = number(at + 28, 2);
      entry.name = part(at + 46, name_bytes);
      at += 46 + name_bytes + number(at + 30, 2) + number(at + 32, 2);
      found.push_back(std::move(entry));
    }
    return found;
  }

  std::string unpacked(const ZipEntry& entry) const {
    const std::string what = "\"" + printable(entry.name, 80) + "\"";
    if ((entry.flags & 1U) != 0) throw damaged(what + ", which is encrypted");
    if (entry.method != 0 && entry.method != 8)
      throw damaged(
          fmt::format("{}, packed by method {} (only 0 and 8, deflate, are read)", what, entry.method));
    if (number(entry.at, 4) != local_signature) throw damaged(what + ", which is not where it should be");
    const std::uint64_t begin = entry.at + 30 + number(entry.at + 26, 2) + number(entry.at + 28, 2);
    const std::string_view packed = part(begin, entry.packed_bytes);
    std::string bytes = entry.method == 0 ? std::string(packed) : inflated(packed, entry.bytes, what);
    const uLong sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
    if (bytes.size() != entry.bytes || sum != entry.crc32) throw damaged(what + ", which is damaged");
    return bytes;
  }

  InputError damaged(const std::string& found) const {
    return input_error({.file = archive_, .wanted = "a whole ZIP archive", .found = found});
  }

 private:
  std::string_view part(std::uint64_t at, std::uint64_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at) throw damaged("one that ends too early");
    return bytes_.substr(at, count);
  }

  std::uint64_t number(std::uint64_t at, int bytes) const {
    std::uint64_t value = 0;
    for (int i = bytes; i-- > 0;)
      value = value << 8 | static_cast<unsigned char>(part(at + static_cast<unsigned>(i), 1)[0]);
    return value;
  }

  /// How many files, and where their table begins: at the end of the archive, before a comment.
  std::pair<std::uint64_t, std::uint64_t> contents() const {
    const std::size_t least = bytes_.size() - std::min(bytes_.size(), end_bytes + longest_comment);
    for (std::size_t at = bytes_.size() - std::min(bytes_.size(), end_bytes);; --at) {
      if (bytes_.size() - at >= end_bytes && number(at, 4) == end_signature) {
        if (at >= locator64_bytes && number(at - locator64_bytes, 4) == locator64_signature) {
          const std::uint64_t large = number(at - locator64_bytes + 8, 8);
          if (number(large, 4) == end64_signature) return {number(large + 32, 8), number(large + 48, 8)};
        }
        return {number(at + 10, 2), number(at + 16, 4)};
      }
      if (at <= least) throw damaged("one without its end");
    }
  }

  std::string inflated(std::string_view packed, std::uint64_t size, const std::string& what) const {
    std::string bytes(size, '\0');
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
    // Nothing larger than `largest_text_file_bytes` comes here.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int status = inflate(&stream, Z_FINISH);
    const bool whole = status == Z_STREAM_END && stream.avail_out == 0;
    inflateEnd(&stream);
    if (!whole) throw damaged(what + ", which does not unpack");
    return bytes;
  }

  std::string_view bytes_;
  std::string archive_;
};

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

std::vector<ZippedFile> unzip(std::string_view bytes, const std::filesystem::path& archive,
                              const std::function<bool(const std::string& name)>& wanted) {
  const ZipReader reader(bytes, archive);
  std::vector<ZippedFile> files;
  std::uint64_t all_bytes = 0;
  for (const ZipEntry& entry : reader.entries()) {
    if (entry.name.ends_with('/') || !wanted(entry.name)) continue;
    all_bytes += entry.bytes;
    if (all_bytes > static_cast<std::uint64_t>(limits::largest_text_file_bytes))
      throw input_error(
          {.file = archive.string(),
           .wanted = fmt::format("files of at most {} bytes together", limits::largest_text_file_bytes),
           .found = "more"});
    files.push_back({.name = entry.name, .bytes = reader.unpacked(entry)});
  }
  return files;
}

}  // namespace seamline::study::online
