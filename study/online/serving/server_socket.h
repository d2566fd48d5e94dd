#pragma once
#include <sys/socket.h>

#include <string>

namespace seamline::study::online {

/// An open socket that listens at an address of this computer (IPv4 or IPv6) and a port (0: any that is
/// free). Throws InputError when it cannot.
[[nodiscard]] int listen_at(const std::string& address, int port);

/// The port that it got.
[[nodiscard]] int port_of(int listener);

/// A client's address in letters; empty for this computer itself.
[[nodiscard]] std::string address_text(const sockaddr& address);

/// Raises the number of open files to what the system lets a program have, and says how many connections
/// leave some for others: `wanted` at most.
[[nodiscard]] unsigned connections_of(unsigned wanted);

}  // namespace seamline::study::online
