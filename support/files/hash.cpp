#include "support/files/hash.h"

#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>

#include "support/running/interrupt.h"
#include "support/text/error.h"

namespace seamline {
namespace {

using Context = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

Context begin_sha256() {
  Context context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in the cryptographic library");
  return context;
}

std::string finish(EVP_MD_CTX* context) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  EVP_DigestFinal_ex(context, digest.data(), &length);
  static constexpr char digits[] = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < length; ++i) {
    hex += digits[digest[i] >> 4];
    hex += digits[digest[i] & 15];
  }
  return hex;
}

/// Up to here a file is read to its end in less than a tenth of a second, so that a picture which was just
/// written is recorded before a Ctrl-C ends the work: it may have taken minutes.
constexpr std::size_t soon_read_bytes = 16 << 20;

}  // namespace

std::string sha256(std::string_view bytes) {
  const Context context = begin_sha256();
  EVP_DigestUpdate(context.get(), bytes.data(), bytes.size());
  return finish(context.get());
}

bool is_sha256(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path))
    throw input_error({.file = path.string(), .wanted = "a readable file", .found = "none"});
  const Context context = begin_sha256();
  std::array<char, 1 << 16> block{};
  std::size_t read_bytes = 0;
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    const auto count = static_cast<std::size_t>(in.gcount());
    read_bytes += count;
    if (read_bytes > soon_read_bytes) stop_if_interrupted();
    EVP_DigestUpdate(context.get(), block.data(), count);
  }
  return finish(context.get());
}

}  // namespace seamline
