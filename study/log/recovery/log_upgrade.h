#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace seamline::study {

/// What an upgrade brought over.
struct LogUpgrade {
  int from_version = 0, to_version = 0;
  std::map<std::string, std::int64_t> rows;  ///< by table, every one of them
};

/// Makes a log of today's schema version out of one of an older version, with every row of every table. The
/// old log is not touched, also not its write-ahead log; the new one is compared with it row by row, and is
/// then there whole, for its owner alone (0600), or not at all. Throws InputError when `out` exists, when the
/// old log is damaged (`recover_log` saves what can be read), is of today's version, or somebody is in a
/// session of it now.
LogUpgrade upgrade_log(const std::filesystem::path& old, const std::filesystem::path& out);

/// The same in words.
[[nodiscard]] std::string upgrade_text(const LogUpgrade& upgrade, const std::filesystem::path& old,
                                       const std::filesystem::path& out);

}  // namespace seamline::study
