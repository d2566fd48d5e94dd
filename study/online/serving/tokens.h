#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace seamline::study::online {

/// 256 bits from the system's generator, as 64 hexadecimal digits. Throws InputError when it has none.
[[nodiscard]] std::string random_secret();
/// 80 bits, as 16 letters a-z and digits 2-7.
[[nodiscard]] std::string random_letters();

/// Makes invitations, each good for one participant, and adds their hashes to a file (for its owner alone),
/// which is made when it is missing. Returns the invitations: they are stored nowhere.
[[nodiscard]] std::vector<std::string> make_tokens(int count, const std::filesystem::path& file);

/// The hashes of a file of invitations. Throws InputError when it cannot be read or holds something else.
[[nodiscard]] std::set<std::string> read_token_hashes(const std::filesystem::path& file);

}  // namespace seamline::study::online
