#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "study/online/serving/http_request.h"

namespace seamline::study::online {

/// Whether this program was built with its server (libmicrohttpd).
[[nodiscard]] bool has_http_server();

/// How much a server takes on.
struct HttpLimits {
  unsigned connections = 8192;
  unsigned slow_s = 60;      ///< for a whole request to arrive, or until an idle connection is closed
  unsigned sending_s = 900;  ///< for a whole answer to leave
  unsigned idle_s = 30;      ///< without a byte in either direction
  std::int64_t bodies_bytes = std::int64_t{256}
                              << 20;  ///< received and not answered, of all requests together
  unsigned threads = 2;
};

/// Answers a request later, from any thread, once. Every one that is given out must be used before the server
/// stops.
using Reply = std::function<void(HttpResponse)>;

/// What a server does with requests that are whole and pass `read_head`.
struct HttpHandler {
  /// Refuses a request by its first lines, before its body is let in; none: it may come. From any thread.
  std::function<std::optional<HttpResponse>(const RequestHead&)> admit;
  /// What can be answered at once; none: `later` is asked.
  std::function<std::optional<HttpResponse>(const HttpRequest&)> now;
  std::function<void(HttpRequest, Reply)> later;
  /// A request that was refused: path (of ours, else "other"), and status. From any thread.
  std::function<void(const std::string&, int)> refused;
};

/// HTTP/1.1 over epoll (libmicrohttpd, which only this and http_responses name).
class HttpServer {
 public:
  /// Listens at `address` (IPv4 or IPv6) and `port` (0: any that is free). Throws InputError when it cannot.
  HttpServer(const std::string& address, int port, HttpHandler handler, const HttpLimits& limits = {});
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] int port() const;
  /// Closes connections that are too slow: to be called every second or so.
  void close_slow_ones();
  /// Accepts nobody any more; requests that have come in are answered, and those that are still coming in may
  /// be for `patience_s`.
  void stop(double patience_s);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace seamline::study::online
