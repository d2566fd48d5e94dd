#include "sensors/files/number_arrays.h"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>

#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::sensors {
namespace {

namespace fs = std::filesystem;

/// How the numbers of an array lie in a file.
struct ArrayForm {
  const char* name = "";
  std::int64_t at = 0;  ///< bytes before them
  int width_px = 0, height_px = 0, channels = 1;
  char kind = 'f';  ///< f: floating point, i: whole, u: whole without sign
  int bytes = 4;
  bool big_endian = false;
  bool columns_first = false, from_bottom = false;
};

class ArrayFile {
 public:
  ArrayFile(const fs::path& path, const char* name) : path_(path), name_(name), in_(path, std::ios::binary) {}

  [[nodiscard]] InputError damaged(const std::string& found) const {
    return input_error(
        {.file = path_.string(), .wanted = fmt::format("a whole {} file", name_), .found = found});
  }
  [[nodiscard]] InputError wrong(const std::string& wanted, const std::string& found) const {
    return input_error({.file = path_.string(), .wanted = wanted, .found = found});
  }
  std::string bytes(std::int64_t count) {
    std::string text(count, '\0');
    in_.read(text.data(), count);
    if (in_.gcount() != count) throw damaged("one that ends early");
    return text;
  }
  /// Letters up to white space, of which one letter is taken too.
  std::string word() {
    constexpr std::size_t longest = 64;
    std::string text;
    for (int letter = in_.get(); letter > ' '; letter = in_.get()) {
      text += static_cast<char>(letter);
      if (text.size() > longest) throw damaged("a header without an end");
    }
    if (!in_) throw damaged("one that ends in its header");
    return text;
  }
  [[nodiscard]] std::int64_t at() { return static_cast<std::int64_t>(in_.tellg()); }
  [[nodiscard]] std::int64_t left() { return static_cast<std::int64_t>(fs::file_size(path_)) - at(); }
  int side(std::int64_t px) {
    if (px < 1 || px > limits::largest_picture_side_px)
      throw wrong(fmt::format("sides from 1 to {} pixels", limits::largest_picture_side_px),
                  fmt::format("{}", px));
    return static_cast<int>(px);
  }

 private:
  fs::path path_;
  const char* name_;
  std::ifstream in_;
};

std::optional<double> number_of(const std::string& text) {
  std::istringstream in(text);
  double value = 0;
  if (!(in >> value) || !in.eof()) return std::nullopt;
  return value;
}

ArrayForm pfm_form(ArrayFile& file) {
  ArrayForm form{.name = "PFM", .from_bottom = true};
  form.channels = file.word() == "PF" ? 3 : 1;
  std::array<double, 3> numbers{};
  for (double& number : numbers) {
    std::string text = file.word();
    while (text.empty()) text = file.word();
    const auto value = number_of(text);
    if (!value || !std::isfinite(*value)) throw file.damaged("one whose header has no three numbers");
    number = *value;
  }
  for (const double side : {numbers[0], numbers[1]})
    if (side != std::floor(side) || std::abs(side) > 1e9)
      throw file.damaged("one whose size is no whole number");
  form.width_px = file.side(static_cast<std::int64_t>(numbers[0]));
  form.height_px = file.side(static_cast<std::int64_t>(numbers[1]));
  if (numbers[2] == 0) throw file.damaged("one whose scale, which says the byte order, is 0");
  form.big_endian = numbers[2] > 0;
  return form;
}

/// The text after a key of NPY's header, which is a Python dictionary.
std::string npy_value(ArrayFile& file, const std::string& header, const std::string& key) {
  const std::size_t at = header.find("'" + key + "'");
  const std::size_t colon = at == std::string::npos ? at : header.find(':', at);
  if (colon == std::string::npos) throw file.damaged("a header without " + key);
  const std::size_t from = header.find_first_not_of(' ', colon + 1);
  if (from == std::string::npos) throw file.damaged("a header without " + key);
  const std::size_t end = header[from] == '(' ? header.find(')', from) : header.find_first_of(",}", from);
  if (end == std::string::npos) throw file.damaged("a header that does not end");
  return header.substr(from, end - from);
}

void take_npy_shape(ArrayFile& file, const std::string& text, ArrayForm& form) {
  std::vector<std::int64_t> sides;
  for (std::size_t at = text.find_first_of("0123456789"); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
    if (end - at > 9) throw file.damaged("a size of " + text.substr(at, end - at));
    sides.push_back(std::stoll(text.substr(at, end - at)));
    at = text.find_first_of("0123456789", end);
  }
  std::vector<std::int64_t> longer;
  for (const std::int64_t side : sides)
    if (side != 1) longer.push_back(side);
  if (longer.size() != 2)
    throw file.wrong("an array of two axes, rows and columns", "one of shape " + printable(text) + ")");
  form.height_px = file.side(longer[0]);
  form.width_px = file.side(longer[1]);
}

ArrayForm npy_form(ArrayFile& file) {
  ArrayForm form{.name = "NPY"};
  const std::string start = file.bytes(8);
  const int size_bytes = start[6] == 1 ? 2 : 4;
  if (start[6] < 1 || start[6] > 3) throw file.damaged(fmt::format("version {}", int{start[6]}));
  const std::string size_text = file.bytes(size_bytes);
  std::int64_t size = 0;
  for (int i = size_bytes - 1; i >= 0; --i) size = size << 8 | static_cast<unsigned char>(size_text[i]);
  if (size > file.left()) throw file.damaged("one that ends in its header");
  constexpr std::int64_t longest_header = 65536;
  if (size > longest_header) throw file.damaged("a header without an end");
  const std::string header = file.bytes(size);
  const std::string type = npy_value(file, header, "descr");
  // Such as '<f4': byte order, kind, bytes.
  const bool known = type.size() == 5 && type[0] == '\'' && type[4] == '\'' &&
                     std::string_view("<>|=").find(type[1]) != std::string_view::npos;
  if (known) {
    form.kind = type[2];
    form.bytes = type[3] - '0';
    form.big_endian = type[1] == '>';
  }
  const bool floats = form.kind == 'f' && (form.bytes == 2 || form.bytes == 4 || form.bytes == 8);
  const bool whole = (form.kind == 'i' || form.kind == 'u') &&
                     (form.bytes == 1 || form.bytes == 2 || form.bytes == 4 || form.bytes == 8);
  if (!known || (!floats && !whole))
    throw file.wrong("an array of real numbers (f2, f4, f8, u2, ...)", printable(type));
  form.columns_first = npy_value(file, header, "fortran_order") == "True";
  take_npy_shape(file, npy_value(file, header, "shape"), form);
  return form;
}

ArrayForm dpt_form(ArrayFile& file) {
  ArrayForm form{.name = "DPT"};
  const std::string start = file.bytes(12);
  std::array<std::int32_t, 2> sides{};
  std::memcpy(sides.data(), start.data() + 4, 8);
  form.width_px = file.side(sides[0]);
  form.height_px = file.side(sides[1]);
  return form;
}

double half_of(std::uint16_t bits) {
  const int sign = bits >> 15, exponent = bits >> 10 & 31, part = bits & 1023;
  double value = exponent == 0    ? std::ldexp(part, -24)
                 : exponent == 31 ? (part == 0 ? HUGE_VAL : std::nan(""))
                                  : std::ldexp(part + 1024, exponent - 25);
  return sign ? -value : value;
}

float number_at(const char* bytes, const ArrayForm& form) {
  std::array<char, 8> ordered{};
  const std::size_t count = form.bytes;
  for (std::size_t i = 0; i < count; ++i) ordered[i] = bytes[form.big_endian ? count - 1 - i : i];
  std::uint64_t bits = 0;
  std::memcpy(&bits, ordered.data(), ordered.size());
  if (form.kind == 'f') {
    if (form.bytes == 2) return static_cast<float>(half_of(static_cast<std::uint16_t>(bits)));
    if (form.bytes == 4) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    return static_cast<float>(std::bit_cast<double>(bits));
  }
  const int unused = 64 - 8 * form.bytes;
  if (form.kind == 'u') return static_cast<float>(bits);
  return static_cast<float>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

ArrayKind array_kind(std::string_view start) {
  if (start.starts_with("Pf") || start.starts_with("PF")) return ArrayKind::pfm;
  if (start.starts_with("\x93NUMPY")) return ArrayKind::npy;
  if (start.starts_with("PIEH")) return ArrayKind::dpt;
  return ArrayKind::none;
}

RawDepth read_array(const fs::path& path, ArrayKind kind,
                    const std::function<void(const RawDepth&)>& accept) {
  ArrayFile file(path, kind == ArrayKind::pfm ? "PFM" : kind == ArrayKind::npy ? "NPY" : "DPT");
  const ArrayForm form = kind == ArrayKind::pfm   ? pfm_form(file)
                         : kind == ArrayKind::npy ? npy_form(file)
                                                  : dpt_form(file);
  RawDepth raw{.width_px = form.width_px, .height_px = form.height_px, .values = {}, .notes = {}};
  raw.whole = form.kind != 'f';
  raw.bits = 8 * form.bytes;
  if (accept) accept(raw);
  const std::int64_t count = std::int64_t{form.width_px} * form.height_px;
  if (const std::int64_t wanted = count * form.channels * form.bytes, found = file.left(); wanted != found)
    throw file.damaged(fmt::format("one with {} bytes of numbers where its header says {}", found, wanted));
  const std::string bytes = file.bytes(count * form.channels * form.bytes);
  raw.values.resize(count);
  for (std::int64_t row = 0; row < form.height_px; ++row)
    for (std::int64_t column = 0; column < form.width_px; ++column) {
      const std::int64_t line = form.from_bottom ? form.height_px - 1 - row : row;
      const std::int64_t index =
          form.columns_first ? column * form.height_px + line : line * form.width_px + column;
      const char* at = &bytes[static_cast<std::size_t>(index * form.channels * form.bytes)];
      const float value = number_at(at, form);
      for (int c = 1; c < form.channels; ++c)
        if (const float other = number_at(at + std::ptrdiff_t{c} * form.bytes, form);
            other != value && !std::isnan(value))
          throw file.wrong("one channel, or three of equal values",
                           fmt::format("{:g} and {:g} in ({}, {})", value, other, column, row));
      raw.values[static_cast<std::size_t>(row * form.width_px + column)] = value;
    }
  return raw;
}

}  // namespace seamline::sensors
