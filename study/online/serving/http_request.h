#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace seamline::study::online {

// What the server knows of a request, and what it answers; no library is named here.

using HeaderFields = std::vector<std::pair<std::string, std::string>>;

/// What is accepted of a request's first lines.
struct RequestHead {
  std::string method;  ///< GET, HEAD or POST
  std::string path;    ///< begins with /, without a query
  std::int64_t content_bytes = 0;
  std::string secret = {};         ///< of `Authorization: Bearer`; empty: none
  std::string known_version = {};  ///< of `If-None-Match`
  std::string host = {};           ///< of `Host`: lower case, without its port; [::1] in its brackets
};

/// Why a request is not answered.
struct HeadFault {
  int status = 400;
  std::string sentence;
};

inline constexpr std::int64_t most_request_bytes = std::int64_t{1} << 20;

/// Checks a request strictly: what two programs could read in two ways (a length twice, or with a sign, or
/// beside a transfer encoding), what comes from a page of another host (`Origin`), and what is too long is a
/// fault. Header names are compared in any case.
[[nodiscard]] std::variant<RequestHead, HeadFault> read_head(const std::string& method,
                                                             const std::string& path,
                                                             const HeaderFields& fields);

/// Whether a browser that says `host` asked for this server: an address in figures, `localhost`, or one of
/// `names`. Under any other name a page from elsewhere could have its name lead here (DNS rebinding), and
/// read what this server tells its own pages.
[[nodiscard]] bool is_own_host(const std::string& host, const std::vector<std::string>& names);

/// Whether a name can stand in `Host` and in a configuration: letters, digits, dots and dashes.
[[nodiscard]] bool is_host_name(const std::string& name);

/// How many bytes a request's first lines have when each ends with CR LF, a field is `Name: value` or
/// `Name:`, and nothing else is between them. A library that cuts values at a NUL, takes a bare LF for the
/// end of a line or joins folded lines understood something else than what another program on the way may
/// have: then as many have not come in.
[[nodiscard]] std::size_t plain_head_bytes(std::size_t method_bytes, std::size_t target_bytes,
                                           const HeaderFields& fields);

struct HttpRequest {
  RequestHead head;
  std::string body = {};
  std::string address = {};  ///< whence; empty: this computer
};

/// A file or text that is sent again and again.
struct SentFile {
  std::string content_type, version;  ///< version: quoted, as ETag has it
  std::string bytes = {};             ///< of a small file
  int descriptor = -1;                ///< of a large one
  std::int64_t size_bytes = 0;
};

struct HttpResponse {
  int status = 200;
  std::string body = {};  ///< JSON
  std::shared_ptr<const SentFile> file = {};
};

}  // namespace seamline::study::online
