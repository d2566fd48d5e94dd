#include "study/online/serving/http_server.h"

#include "study/online/serving/http_responses.h"
#include "study/online/serving/server_socket.h"
#include "support/text/error.h"

#ifdef SEAMLINE_HAS_SERVER

#include <microhttpd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <new>
#include <thread>
#include <unordered_set>

namespace seamline::study::online {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t memory_a_connection = 16U << 10;

/// A connection that a client has open.
struct Connection {
  int descriptor = -1;
  Clock::time_point since = Clock::now();  ///< of waiting for a request, or of sending an answer
  bool sending = false;
};

/// A request on its way in or out.
struct Exchange {
  HttpRequest request;
  std::optional<HttpResponse> response;  ///< what `later` was answered with
  bool is_late = false;                  ///< `later` was asked
  std::int64_t held_bytes = 0;           ///< of its body
  std::size_t target_bytes = 0;          ///< of its first line: path and query
  bool is_begun = false;                 ///< its first lines were read
};

/// No name of ours needs an escape, and one that has a zero would end there.
std::size_t keep_as_it_is(void*, MHD_Connection*, char* text) {
  return std::strlen(text);
}

MHD_Result take_field(void* fields, MHD_ValueKind, const char* key, const char* value) {
  static_cast<HeaderFields*>(fields)->emplace_back(key == nullptr ? "" : key, value == nullptr ? "" : value);
  return MHD_YES;
}

std::string address_of(MHD_Connection* connection) {
  const MHD_ConnectionInfo* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
  return info == nullptr || info->client_addr == nullptr ? "?" : address_text(*info->client_addr);
}

}  // namespace

bool has_http_server() {
  return true;
}

struct HttpServer::State {
  HttpHandler handler;
  HttpLimits limits;
  MHD_Daemon* daemon = nullptr;
  int listener = -1;
  int port = 0;
  std::mutex lock;
  std::unordered_set<Connection*> connections;
  std::atomic<std::int64_t> bodies_bytes = 0;
  std::atomic<int> exchanges = 0;  ///< requests between their first line and their answer's last byte
  std::atomic<int> suspended = 0;  ///< that wait for `later`
  HttpResponses responses;

  MHD_Result send(MHD_Connection* connection, const HttpResponse& response, bool close);
  MHD_Result begin(MHD_Connection* connection, const char* url, const char* method, Exchange& exchange);
  MHD_Result proceed(MHD_Connection* connection, Exchange& exchange, const char* data, std::size_t* bytes);
  MHD_Result refuse(MHD_Connection* connection, const Exchange& exchange, HttpResponse response);

  static void* on_target(void* self, const char* target, MHD_Connection* connection);
  static MHD_Result on_request(void* self, MHD_Connection* connection, const char* url, const char* method,
                               const char* version, const char* data, std::size_t* bytes, void** context);
  static void on_completed(void* self, MHD_Connection* connection, void** context,
                           MHD_RequestTerminationCode reason);
  static void on_connection(void* self, MHD_Connection* connection, void** context,
                            MHD_ConnectionNotificationCode code);
  void mark(MHD_Connection* connection, bool sending);
};

void HttpServer::State::mark(MHD_Connection* connection, bool sending) {
  const MHD_ConnectionInfo* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
  if (info == nullptr || info->socket_context == nullptr) return;
  const std::lock_guard guard(lock);
  auto* open = static_cast<Connection*>(info->socket_context);
  open->since = Clock::now();
  open->sending = sending;
}

MHD_Result HttpServer::State::send(MHD_Connection* connection, const HttpResponse& response, bool close) {
  MHD_Response* made = responses.of(response);
  if (close && !response.file) MHD_add_response_header(made, "Connection", "close");
  mark(connection, true);
  const MHD_Result queued = MHD_queue_response(connection, static_cast<unsigned>(response.status), made);
  if (!response.file) MHD_destroy_response(made);
  return queued;
}

/// Before the body is read: the connection ends with the answer.
MHD_Result HttpServer::State::refuse(MHD_Connection* connection, const Exchange& exchange,
                                     HttpResponse response) {
  handler.refused(exchange.request.head.path, response.status);
  return send(connection, response, true);
}

MHD_Result HttpServer::State::begin(MHD_Connection* connection, const char* url, const char* method,
                                    Exchange& exchange) {
  exchange.is_begun = true;
  ++exchanges;
  HeaderFields fields;
  MHD_get_connection_values(connection, MHD_HEADER_KIND, take_field, &fields);
  const MHD_ConnectionInfo* head_size =
      MHD_get_connection_info(connection, MHD_CONNECTION_INFO_REQUEST_HEADER_SIZE);
  if (head_size == nullptr ||
      head_size->header_size != plain_head_bytes(std::strlen(method), exchange.target_bytes, fields))
    return refuse(connection, exchange,
                  {.status = 400,
                   .body = "{\"error\":\"headers: wanted lines like Name: value that end with CR LF, found "
                           "others\"}"});
  auto head = read_head(method, url, fields);
  if (const auto* fault = std::get_if<HeadFault>(&head))  // its sentence is of our own words alone
    return refuse(connection, exchange,
                  {.status = fault->status, .body = "{\"error\":\"" + fault->sentence + "\"}"});
  exchange.request.head = std::move(std::get<RequestHead>(head));
  exchange.request.address = address_of(connection);
  if (std::optional<HttpResponse> no = handler.admit(exchange.request.head))
    return refuse(connection, exchange, *std::move(no));
  return MHD_YES;
}

/// The first that is heard of a request: what its first line asks for, as it came.
void* HttpServer::State::on_target(void*, const char* target, MHD_Connection*) {
  auto* exchange = new (std::nothrow) Exchange;
  if (exchange != nullptr) exchange->target_bytes = std::strlen(target);
  return exchange;
}

MHD_Result HttpServer::State::proceed(MHD_Connection* connection, Exchange& exchange, const char* data,
                                      std::size_t* bytes) {
  HttpRequest& request = exchange.request;
  if (*bytes > 0) {
    const std::int64_t more = *bytes;
    if (static_cast<std::int64_t>(request.body.size()) + more > request.head.content_bytes) return MHD_NO;
    exchange.held_bytes += more;
    if (bodies_bytes.fetch_add(more) + more > limits.bodies_bytes) return MHD_NO;  // sent again later
    request.body.append(data, *bytes);
    *bytes = 0;
    return MHD_YES;
  }
  if (exchange.is_late) {
    if (!exchange.response) return MHD_NO;
    return send(connection, *exchange.response, false);
  }
  if (static_cast<std::int64_t>(request.body.size()) != request.head.content_bytes) return MHD_NO;
  if (const std::optional<HttpResponse> at_once = handler.now(request))
    return send(connection, *at_once, false);
  exchange.is_late = true;
  mark(connection, true);
  MHD_suspend_connection(connection);  // before anybody can resume it
  ++suspended;
  const Reply reply = [this, connection, &exchange](HttpResponse response) {
    exchange.response = std::move(response);
    MHD_resume_connection(connection);
    --suspended;
  };
  try {
    handler.later(std::move(request), reply);
  } catch (const std::exception&) {  // before it was given to anybody
    reply({.status = 503, .body = "{\"error\":\"server: wanted memory, found none: send it again later\"}"});
  }
  return MHD_YES;
}

MHD_Result HttpServer::State::on_request(void* self, MHD_Connection* connection, const char* url,
                                         const char* method, const char*, const char* data,
                                         std::size_t* bytes, void** context) {
  auto& state = *static_cast<State*>(self);
  try {
    if (*context == nullptr) return MHD_NO;
    auto& exchange = *static_cast<Exchange*>(*context);
    return exchange.is_begun ? state.proceed(connection, exchange, data, bytes)
                             : state.begin(connection, url, method, exchange);
  } catch (const std::exception&) {
    return MHD_NO;  // out of memory: the connection is closed
  }
}

void HttpServer::State::on_completed(void* self, MHD_Connection* connection, void** context,
                                     MHD_RequestTerminationCode) {
  auto& state = *static_cast<State*>(self);
  auto* exchange = static_cast<Exchange*>(*context);
  if (exchange == nullptr) return;
  state.bodies_bytes -= exchange->held_bytes;
  if (exchange->is_begun) {
    --state.exchanges;
    state.mark(connection, false);
  }
  delete exchange;
  *context = nullptr;
}

void HttpServer::State::on_connection(void* self, MHD_Connection* connection, void** context,
                                      MHD_ConnectionNotificationCode code) {
  auto& state = *static_cast<State*>(self);
  if (code == MHD_CONNECTION_NOTIFY_STARTED) {
    const MHD_ConnectionInfo* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
    auto* open = new Connection{.descriptor = info == nullptr ? -1 : info->connect_fd};
    const std::lock_guard guard(state.lock);
    state.connections.insert(open);
    *context = open;
  } else if (auto* open = static_cast<Connection*>(*context)) {
    const std::lock_guard guard(state.lock);
    state.connections.erase(open);
    delete open;
    *context = nullptr;
  }
}

HttpServer::HttpServer(const std::string& address, int port, HttpHandler handler, const HttpLimits& limits)
    : state_(std::make_unique<State>()) {
  State& state = *state_;
  state.handler = std::move(handler);
  state.limits = limits;
  const unsigned connections = connections_of(limits.connections);
  state.listener = listen_at(address, port);
  state.port = port_of(state.listener);
  state.daemon = MHD_start_daemon(
      MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME, 0, nullptr, nullptr, &State::on_request,
      &state, MHD_OPTION_LISTEN_SOCKET, state.listener, MHD_OPTION_THREAD_POOL_SIZE, limits.threads,
      MHD_OPTION_CONNECTION_LIMIT, connections, MHD_OPTION_CONNECTION_TIMEOUT, limits.idle_s,
      MHD_OPTION_CONNECTION_MEMORY_LIMIT, memory_a_connection, MHD_OPTION_STRICT_FOR_CLIENT, 1,
      MHD_OPTION_UNESCAPE_CALLBACK, &keep_as_it_is, nullptr, MHD_OPTION_URI_LOG_CALLBACK, &State::on_target,
      &state, MHD_OPTION_NOTIFY_COMPLETED, &State::on_completed, &state, MHD_OPTION_NOTIFY_CONNECTION,
      &State::on_connection, &state, MHD_OPTION_END);
  if (state.daemon != nullptr) return;
  ::close(state.listener);
  throw input_error({.field = "seamline serve",
                     .wanted = "threads and open files for a server",
                     .found = std::strerror(errno)});
}

HttpServer::~HttpServer() {
  stop(0);
}

int HttpServer::port() const {
  return state_->port;
}

void HttpServer::close_slow_ones() {
  const Clock::time_point now = Clock::now();
  const std::lock_guard guard(state_->lock);
  for (const Connection* open : state_->connections) {
    const std::chrono::seconds patience(open->sending ? state_->limits.sending_s : state_->limits.slow_s);
    if (now - open->since > patience) ::shutdown(open->descriptor, SHUT_RDWR);
  }
}

void HttpServer::stop(double patience_s) {
  State& state = *state_;
  if (state.daemon == nullptr) return;
  MHD_quiesce_daemon(state.daemon);
  const Clock::time_point until =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(patience_s));
  while (state.suspended > 0 || (state.exchanges > 0 && Clock::now() < until))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  MHD_stop_daemon(state.daemon);
  state.daemon = nullptr;
  ::close(state.listener);
}

}  // namespace seamline::study::online

#else

namespace seamline::study::online {

bool has_http_server() {
  return false;
}

struct HttpServer::State {};

HttpServer::HttpServer(const std::string&, int, HttpHandler, const HttpLimits&) {
  throw input_error({.field = "seamline serve",
                     .wanted = "a seamline that was built with libmicrohttpd-dev",
                     .found = "one without (seamline import needs none)"});
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const {
  return 0;
}

void HttpServer::close_slow_ones() {}

void HttpServer::stop(double) {}

}  // namespace seamline::study::online

#endif
