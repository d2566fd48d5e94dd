// A client that sends exactly the bytes that it is told to.
#pragma once
#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "tests/online/online_people.h"

namespace seamline::study::online {

struct HttpAnswer {
  int status = 0;
  std::string head, body;
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(body); }
};

class HttpClient {
 public:
  explicit HttpClient(int port, int patience_ms = 20000) : port_(port), patience_ms_(patience_ms) {}
  ~HttpClient() { close(); }
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  void close() {
    if (socket_ >= 0) ::close(socket_);
    socket_ = -1;
    rest_.clear();
  }
  void use_port(int port) {
    if (port != port_) close();
    port_ = port;
  }
  bool open() {
    if (socket_ >= 0) return true;
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int yes = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return true;
    close();
    return false;
  }
  bool send(const std::string& bytes) {
    if (!open()) return false;
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return false;
      sent += static_cast<std::size_t>(count);
    }
    return true;
  }
  /// Waits until the server has read every byte that was sent: the receive queue of its end is empty.
  void wait_until_read() const {
    sockaddr_in own = {};
    socklen_t size = sizeof own;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
    const std::string end = fmt::format(":{:04X} 0100007F:{:04X} ", port_, ntohs(own.sin_port));
    for (int look = 0; look < 20000; ++look) {
      std::ifstream table("/proc/net/tcp");
      for (std::string line; std::getline(table, line);) {
        const std::size_t at = line.find(end);  // then "state sent:received", in hexadecimal
        if (at != std::string::npos && line.substr(at + end.size() + 11, 10) == ":00000000 ") return;
      }
      ::usleep(1000);
    }
    throw std::runtime_error("the server does not read");
  }
  /// The next answer; none when the connection ended before it was whole, or nothing came in time.
  std::optional<HttpAnswer> receive(bool has_body = true) {
    std::size_t end = std::string::npos;
    while ((end = rest_.find("\r\n\r\n")) == std::string::npos)
      if (!more()) return std::nullopt;
    HttpAnswer answer{.head = rest_.substr(0, end + 4), .body = {}};
    rest_.erase(0, end + 4);
    if (answer.head.size() > 12) answer.status = std::atoi(answer.head.c_str() + 9);
    std::size_t bytes = 0;
    const std::size_t at = answer.head.find("Content-Length: ");
    if (at != std::string::npos && has_body) bytes = std::stoul(answer.head.substr(at + 16));
    while (rest_.size() < bytes)
      if (!more()) return std::nullopt;
    answer.body = rest_.substr(0, bytes);
    rest_.erase(0, bytes);
    if (answer.head.find("Connection: close") != std::string::npos) close();
    return answer;
  }
  std::optional<HttpAnswer> exchange(const std::string& bytes) {
    if (send(bytes))
      if (std::optional<HttpAnswer> answer = receive()) return answer;
    close();
    return std::nullopt;
  }
  /// A request as a browser's; kept open.
  std::optional<HttpAnswer> request(const std::string& method, const std::string& path,
                                    const std::string& body = {}, const std::string& secret = {}) {
    std::string bytes = method + " " + path + " HTTP/1.1\r\nHost: localhost\r\n";
    if (!secret.empty()) bytes += "Authorization: Bearer " + secret + "\r\n";
    if (method == "POST") bytes += "Content-Length: " + std::to_string(body.size()) + "\r\n";
    return exchange(bytes + "\r\n" + body);
  }
  std::optional<HttpAnswer> enrol(const Message& message, const std::string& token = {}) {
    const std::string quoted = token.empty() ? "null" : "\"" + token + "\"";
    return request("POST", "/api/enrol",
                   "{\"token\":" + quoted + ",\"message\":" + message_line(message) + "}");
  }

 private:
  bool more() {
    pollfd ready = {.fd = socket_, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, patience_ms_) <= 0) return false;
    char block[65536];
    const ssize_t count = ::recv(socket_, block, sizeof block, 0);
    if (count <= 0) return false;
    rest_.append(block, static_cast<std::size_t>(count));
    return true;
  }

  int port_, patience_ms_;
  int socket_ = -1;
  std::string rest_;
};

}  // namespace seamline::study::online
