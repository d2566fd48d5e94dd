#include "study/online/serving/tokens.h"

#include <fmt/core.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "study/online/messages/message_reader.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

template <std::size_t size>
std::array<std::uint8_t, size> random_bytes() {
  static_assert(size <= 256);  // then the system gives all of them or none
  std::array<std::uint8_t, size> bytes = {};
  ssize_t got = -1;
  do got = ::getrandom(bytes.data(), bytes.size(), 0);
  while (got < 0 && errno == EINTR);
  if (got != static_cast<ssize_t>(size))
    throw input_error(
        {.field = "seamline serve", .wanted = "random bytes from the system", .found = std::strerror(errno)});
  return bytes;
}

template <std::size_t size>
std::string base32(const std::array<std::uint8_t, size>& bytes) {
  static_assert(size % 5 == 0);
  std::string text;
  std::uint32_t bits = 0;
  int count = 0;
  for (const std::uint8_t byte : bytes) {
    bits = bits << 8 | byte;
    for (count += 8; count >= 5; count -= 5)
      text += "abcdefghijklmnopqrstuvwxyz234567"[bits >> (count - 5) & 31];
  }
  return text;
}

}  // namespace

std::string random_secret() {
  std::string text;
  for (const std::uint8_t byte : random_bytes<32>()) text += fmt::format("{:02x}", byte);
  return text;
}

std::string random_letters() {
  return base32(random_bytes<10>());
}

std::vector<std::string> make_tokens(int count, const fs::path& file) {
  std::string text = fs::exists(file) ? read_file(file) : std::string();
  if (!text.empty()) (void)read_token_hashes(file);
  std::vector<std::string> tokens;
  for (int i = 0; i < count; ++i) {
    tokens.push_back(base32(random_bytes<20>()));
    text += sha256(tokens.back()) + "\n";
  }
  write_file_atomically(file, text, Readers::owner);
  return tokens;
}

std::set<std::string> read_token_hashes(const fs::path& file) {
  const std::string text = read_file(file);
  std::set<std::string> hashes;
  std::size_t at = 0;
  for (int line = 1; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string hash = text.substr(at, end - at);
    at = end + 1;
    if (!is_sha256(hash))
      throw input_error({.file = fmt::format("{}:{}", file.string(), line),
                         .wanted = "the hash of an invitation (seamline serve --make-tokens N --tokens FILE)",
                         .found = "\"" + printable(hash, 80) + "\""});
    hashes.insert(hash);
  }
  return hashes;
}

}  // namespace seamline::study::online
