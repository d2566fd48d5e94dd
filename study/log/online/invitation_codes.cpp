#include "study/log/online/invitation_codes.h"

#include <fmt/core.h>

#include <algorithm>

#include "study/log/log_writer.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace fs = std::filesystem;

InvitationCodes read_invitation_codes(const fs::path& file) {
  InvitationCodes codes;
  const std::string text = read_file(file);
  std::size_t at = 0;
  for (int number = 1; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    const std::string hash = line.substr(0, std::min<std::size_t>(64, line.size()));
    const std::string code = line.size() > 65 && line[64] == ' ' ? line.substr(65) : "";
    if (!is_sha256(hash) || !is_code(code))
      throw input_error({.file = fmt::format("{}:{}", file.string(), number),
                         .wanted = "the hash of an invitation and a code (seamline serve --codes FILE)",
                         .found = "\"" + printable(line, 80) + "\""});
    codes[hash] = code;
  }
  return codes;
}

void write_invitation_codes(const fs::path& file, const InvitationCodes& codes) {
  std::string text;
  for (const auto& [hash, code] : codes) text += hash + " " + code + "\n";
  write_file_atomically(file, text, Readers::owner);
}

int forget_invitation_of(const fs::path& file, const std::string& code) {
  InvitationCodes codes = read_invitation_codes(file);
  const auto taken = std::erase_if(codes, [&](const auto& line) { return line.second == code; });
  if (taken > 0) write_invitation_codes(file, codes);
  return static_cast<int>(taken);
}

}  // namespace seamline::study
