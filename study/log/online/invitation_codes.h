#pragma once
#include <filesystem>
#include <map>
#include <string>

namespace seamline::study {

/// Which invitation became which participant: code by the SHA-256 of the invitation. Kept in a file apart
/// from the log, and only where a study asks for it (`seamline serve --codes FILE`): a line of hash and code
/// each, sorted by hash, which says nothing of who came first.
using InvitationCodes = std::map<std::string, std::string>;

/// Throws InputError when the file cannot be read or holds something else.
[[nodiscard]] InvitationCodes read_invitation_codes(const std::filesystem::path& file);

/// Readable by its owner alone, on the disk when this returns. Throws InputError when it cannot.
void write_invitation_codes(const std::filesystem::path& file, const InvitationCodes& codes);

/// Takes a participant out, and says how many lines that were (0: the file is not touched). Throws InputError
/// as reading and writing do.
int forget_invitation_of(const std::filesystem::path& file, const std::string& code);

}  // namespace seamline::study
