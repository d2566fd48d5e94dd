#include "study/online/serving/tokens.h"

#include <fmt/core.h>
#include <sys/random.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

#include "study/log/online/invitation_codes.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

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

/// Changes with every write of a file, and when another takes its place; empty: there is none.
std::string stamp_of(const fs::path& file) {
  struct stat entry = {};
  if (::stat(file.c_str(), &entry) != 0) return {};
  return fmt::format("{} {} {} {}.{:09} {}.{:09}", entry.st_dev, entry.st_ino, entry.st_size,
                     entry.st_mtim.tv_sec, entry.st_mtim.tv_nsec, entry.st_ctim.tv_sec,
                     entry.st_ctim.tv_nsec);
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

std::vector<std::string> make_tokens(int count, const fs::path& file,
                                     const std::function<void(const std::vector<std::string>&)>& tell) {
  std::string text = fs::exists(file) ? read_file(file) : std::string();
  if (!text.empty()) (void)read_token_hashes(file);
  std::vector<std::string> tokens;
  for (int i = 0; i < count; ++i) {
    tokens.push_back(base32(random_bytes<20>()));
    text += sha256(tokens.back()) + "\n";
  }
  if (tell) tell(tokens);
  write_file_atomically(file, text, Readers::owner);
  return tokens;
}

namespace {

std::vector<std::string> read_token_lines(const fs::path& file) {
  const std::string text = read_file(file);
  std::vector<std::string> hashes;
  std::size_t at = 0;
  for (int line = 1; at < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string hash = text.substr(at, end - at);
    at = end + 1;
    if (!is_sha256(hash))
      throw input_error({.file = fmt::format("{}:{}", file.string(), line),
                         .wanted = "the hash of an invitation (seamline serve --make-tokens N --tokens FILE)",
                         .found = "\"" + printable(hash, 80) + "\""});
    hashes.push_back(hash);
  }
  return hashes;
}

}  // namespace

std::set<std::string> read_token_hashes(const fs::path& file) {
  const std::vector<std::string> lines = read_token_lines(file);
  return {lines.begin(), lines.end()};
}

std::vector<ListedInvitation> list_invitations(const fs::path& file, const std::set<std::string>& used) {
  std::vector<ListedInvitation> listed;
  for (const std::string& hash : read_token_lines(file))
    listed.push_back({.token_sha256 = hash, .used = used.contains(hash)});
  return listed;
}

std::string secret_of_file(const fs::path& file) {
  if (!fs::exists(file)) write_file_atomically(file, random_secret() + "\n", Readers::owner);
  std::string secret = read_file(file);
  if (!secret.empty() && secret.back() == '\n') secret.pop_back();
  if (is_sha256(secret)) return secret;  // 64 hexadecimal digits, as `random_secret` has them
  throw input_error({.file = file.string(),
                     .wanted = "a secret of 64 hexadecimal digits, or no file (one is made)",
                     .found = "something else"});
}

std::string code_of_invitation(const fs::path& file, const std::string& invitation) {
  const InvitationCodes codes = read_invitation_codes(file);
  const std::string before = "token=";
  const std::size_t at = invitation.find(before);
  const std::string token = at == std::string::npos ? invitation : invitation.substr(at + before.size());
  const auto found = codes.find(sha256(token.substr(0, token.find_first_of("&#"))));
  if (found != codes.end()) return found->second;
  throw input_error({.file = file.string(),
                     .field = request_name("code_of"),
                     .wanted = "an invitation by which somebody came",
                     .found = "\"" + printable(invitation, 120) + "\""});
}

Invitations::Invitations(fs::path file, std::function<void(const std::string&)> say, fs::path codes)
    : file_(std::move(file)),
      codes_(std::move(codes)),
      say_(std::move(say)),
      seen_(stamp_of(file_)),
      hashes_(read_token_hashes(file_)) {
  if (!codes_.empty() && fs::exists(codes_)) (void)read_invitation_codes(codes_);
}

void Invitations::note(const std::string& token_sha256, const std::string& code) {
  if (codes_.empty()) return;
  const std::lock_guard guard(lock_);
  InvitationCodes codes;
  if (fs::exists(codes_)) codes = read_invitation_codes(codes_);  // a line may have been taken out by hand
  codes[token_sha256] = code;
  write_invitation_codes(codes_, codes);
}

void Invitations::look() {
  const std::string state = stamp_of(file_);
  if (state == seen_) return;
  seen_ = state;
  try {
    hashes_ = read_token_hashes(file_);
  } catch (const InputError& error) {
    say_(fmt::format("{} (the invitations read before still count)", error.what()));
  }
}

bool Invitations::has(const std::string& token_sha256) {
  const std::lock_guard guard(lock_);
  look();
  return hashes_.contains(token_sha256);
}

}  // namespace seamline::study::online
