#include "support/codec/deflate.h"

#include <zlib.h>

#include <stdexcept>

namespace seamline {
namespace {

/// zlib's level: the sizes of higher ones differ by a few per cent, their times many times.
constexpr int deflate_level = 6;

}  // namespace

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), deflate_level) != Z_OK)
    throw std::runtime_error("zlib has no memory");
  out.resize(size);
  return out;
}

std::optional<std::string> inflated(std::string_view stream, std::size_t size) {
  std::string out(size, '\0');
  uLongf written = size;
  uLong read = stream.size();
  const int result = uncompress2(reinterpret_cast<Bytef*>(out.data()), &written,
                                 reinterpret_cast<const Bytef*>(stream.data()), &read);
  if (result != Z_OK || written != size || read != stream.size()) return std::nullopt;
  return out;
}

}  // namespace seamline
