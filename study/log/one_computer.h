#pragma once
#include <filesystem>
#include <string>

namespace seamline::study {

/// Which computer has a log open, and whether others could at the same time.
struct ComputerPlace {
  std::string host;     ///< its name
  bool shared = false;  ///< the log lies on a network file system
};

/// Of this computer and the file system of `path`, which exists.
[[nodiscard]] ComputerPlace computer_place(const std::filesystem::path& path);

/// A log on a network file system is one computer's at a time: its write-ahead log works by memory that the
/// programs of one computer share (sqlite.org/wal.html), so a second computer would damage it. Marks the open
/// lock file of the log (`SessionClaims`) with a shared lock on a byte of this computer's, far behind those
/// of participants, as long as the descriptor lives. Throws InputError when another computer has the log
/// open, or the file system knows no locks. Does nothing where the file system is this computer's own.
void claim_for_computer(int descriptor, const std::filesystem::path& lock_file, const ComputerPlace& place);

}  // namespace seamline::study
