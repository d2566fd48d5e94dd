#include "study/log/one_computer.h"

#include <fcntl.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "support/files/hash.h"
#include "support/files/held/byte_lock.h"
#include "support/text/error.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

constexpr off_t first_byte = off_t{1} << 40;  ///< no log has so many participants
constexpr std::uint64_t computers = std::uint64_t{1} << 40;

/// NFS, SMB (three), Ceph, Lustre, GPFS, AFS, BeeGFS, 9P, and whatever a program mounts (sshfs): statfs(2).
constexpr std::array<std::uint32_t, 11> network_file_systems = {
    0x6969,     0x517b,     0xff534d42, 0xfe534d42, 0x00c36400, 0x0bd00bd0,
    0x47504653, 0x5346414f, 0x19830326, 0x01021997, 0x65735546};

off_t byte_of(const std::string& host) {
  return first_byte + static_cast<off_t>(std::stoull(sha256(host).substr(0, 15), nullptr, 16) % computers);
}

}  // namespace

ComputerPlace computer_place(const fs::path& path) {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
  struct statfs facts = {};
  const bool known = ::statfs(path.c_str(), &facts) == 0;
  const auto type = static_cast<std::uint32_t>(facts.f_type);
  return {.host = host.data(),
          .shared = known && std::find(network_file_systems.begin(), network_file_systems.end(), type) !=
                                 network_file_systems.end()};
}

void claim_for_computer(int descriptor, const fs::path& lock_file, const ComputerPlace& place) {
  if (!place.shared) return;
  const off_t own = byte_of(place.host);
  if (lock_bytes(descriptor, {.begin = own}, F_RDLCK, F_OFD_SETLK) != Lock::taken)
    throw input_error({.file = lock_file.string(),
                       .wanted = "a file system that has locks (give each computer a log of its own)",
                       .found = std::strerror(errno)});
  const off_t end = first_byte + static_cast<off_t>(computers);
  if (!is_locked(descriptor, {.begin = first_byte, .count = own - first_byte}) &&
      !is_locked(descriptor, {.begin = own + 1, .count = end - own - 1}))
    return;
  lock_bytes(descriptor, {.begin = own}, F_UNLCK, F_OFD_SETLK);
  throw input_error({.file = lock_file.string(),
                     .wanted =
                         "a log that one computer has open at a time, because it lies on a network file "
                         "system (give each computer a log of its own, then `seamline merge`)",
                     .found = "another computer that has it open"});
}

}  // namespace seamline::study
