#include "study/online/serving/server_socket.h"

#include <arpa/inet.h>
#include <fmt/core.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::study::online {

std::string address_text(const sockaddr& address) {
  char text[INET6_ADDRSTRLEN] = "?";
  if (address.sa_family == AF_INET) {
    sockaddr_in four = {};
    std::memcpy(&four, &address, sizeof four);
    if ((ntohl(four.sin_addr.s_addr) >> 24) == 127) return {};
    ::inet_ntop(AF_INET, &four.sin_addr, text, sizeof text);
  } else if (address.sa_family == AF_INET6) {
    sockaddr_in6 six = {};
    std::memcpy(&six, &address, sizeof six);
    if (IN6_IS_ADDR_LOOPBACK(&six.sin6_addr)) return {};
    ::inet_ntop(AF_INET6, &six.sin6_addr, text, sizeof text);
  }
  return text;
}

unsigned connections_of(unsigned wanted) {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return wanted;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
  ::getrlimit(RLIMIT_NOFILE, &limit);
  return static_cast<unsigned>(std::min<rlim_t>(wanted, limit.rlim_cur / 2));
}

int listen_at(const std::string& address, int port) {
  sockaddr_in four = {};
  four.sin_family = AF_INET;
  four.sin_port = htons(static_cast<std::uint16_t>(port));
  sockaddr_in6 six = {};
  six.sin6_family = AF_INET6;
  six.sin6_port = htons(static_cast<std::uint16_t>(port));
  const bool is_four = ::inet_pton(AF_INET, address.c_str(), &four.sin_addr) == 1;
  if (!is_four && ::inet_pton(AF_INET6, address.c_str(), &six.sin6_addr) != 1)
    throw input_error({.field = request_name("listen"),
                       .wanted = "an address of this computer, like 127.0.0.1 or ::1",
                       .found = "\"" + address + "\""});
  const int descriptor =
      ::socket(is_four ? AF_INET : AF_INET6, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int yes = 1;
  const sockaddr* where =
      is_four ? reinterpret_cast<const sockaddr*>(&four) : reinterpret_cast<const sockaddr*>(&six);
  const socklen_t bytes = is_four ? sizeof four : sizeof six;
  if (descriptor >= 0 && ::setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) == 0 &&
      ::bind(descriptor, where, bytes) == 0 && ::listen(descriptor, SOMAXCONN) == 0)
    return descriptor;
  const std::string found = std::strerror(errno);
  if (descriptor >= 0) ::close(descriptor);
  throw input_error({.field = fmt::format("{} port {}", address, port),
                     .wanted = "an address and a port that are free",
                     .found = found});
}

int port_of(int listener) {
  sockaddr_storage bound = {};
  socklen_t bytes = sizeof bound;
  ::getsockname(listener, reinterpret_cast<sockaddr*>(&bound), &bytes);
  return ntohs(bound.ss_family == AF_INET ? reinterpret_cast<const sockaddr_in*>(&bound)->sin_port
                                          : reinterpret_cast<const sockaddr_in6*>(&bound)->sin6_port);
}

}  // namespace seamline::study::online
