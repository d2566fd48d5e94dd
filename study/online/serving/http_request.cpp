#include "study/online/serving/http_request.h"

#include <arpa/inet.h>
#include <netinet/in.h>

#include <algorithm>
#include <map>

namespace seamline::study::online {
namespace {

constexpr std::size_t most_fields = 100, most_path_bytes = 512;

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char letter) { return lower(letter); });
  return text;
}

bool is_odd(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) < 0x20 && letter != '\t') || letter == 0x7f;
  });
}

/// Decimal digits, as many as the limit has at most, and nothing else.
std::int64_t length_of(const std::string& text) {
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos) return -1;
  if (text.size() > 1 && text.front() == '0') return -1;
  return std::stoll(text);
}

/// Lower case, without a port and without the dot at the end.
std::string without_port(const std::string& host) {
  std::string name = lower(host);
  const std::size_t colon = name.rfind(':');
  if (colon != std::string::npos && name.find_first_not_of("0123456789", colon + 1) == std::string::npos)
    name.erase(colon);
  if (name.ends_with('.')) name.pop_back();
  return name;
}

bool is_address(int family, const std::string& text) {
  in6_addr bits = {};
  return ::inet_pton(family, text.c_str(), &bits) == 1;
}

/// host[:port] of http://host[:port] or https://...; empty: it is not one.
std::string host_of(const std::string& origin) {
  for (const std::string scheme : {"http://", "https://"})
    if (origin.starts_with(scheme)) return origin.substr(scheme.size());
  return {};
}

}  // namespace

bool is_host_name(const std::string& name) {
  return !name.empty() && name.size() <= 253 && name.find("..") == std::string::npos && name.front() != '.' &&
         name.front() != '-' &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-") ==
             std::string::npos;
}

bool is_own_host(const std::string& host, const std::vector<std::string>& names) {
  if (host == "localhost" || is_address(AF_INET, host)) return true;
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    return is_address(AF_INET6, host.substr(1, host.size() - 2));
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return without_port(name) == host; });
}

std::size_t plain_head_bytes(std::size_t method_bytes, std::size_t target_bytes, const HeaderFields& fields) {
  constexpr std::size_t line_end = 2, version_bytes = 8;  // HTTP/1.1
  std::size_t bytes = method_bytes + 1 + target_bytes + 1 + version_bytes + line_end + line_end;
  for (const auto& [name, value] : fields)
    bytes += name.size() + (value.empty() ? 1 : 2 + value.size()) + line_end;
  return bytes;
}

std::variant<RequestHead, HeadFault> read_head(const std::string& method, const std::string& path,
                                               const HeaderFields& fields) {
  if (method != "GET" && method != "HEAD" && method != "POST")
    return HeadFault{405, "This method is not supported. Use GET, HEAD or POST."};
  if (path.empty() || path.front() != '/' || path.size() > most_path_bytes || is_odd(path))
    return HeadFault{404, "No such path."};
  if (fields.size() > most_fields) return HeadFault{431, "More than 100 header fields."};
  // What may stand once: where it stood twice, two programs on the way could each believe another one.
  std::map<std::string, std::string> once;
  for (const auto& [name, value] : fields) {
    const std::string key = lower(name);
    if (key.empty() || is_odd(name) || is_odd(value))
      return HeadFault{400, "A header field holds control characters."};
    if (key.find_first_of(" \t") != std::string::npos)
      return HeadFault{400, "A header field has a space in its name."};
    if (key == "transfer-encoding")
      return HeadFault{501, "Transfer-Encoding is not supported. Send a Content-Length."};
    if (key == "content-encoding")
      return HeadFault{415, "Content-Encoding is not supported. Send plain text."};
    if (key == "content-length" || key == "host" || key == "authorization" || key == "origin" ||
        key == "expect" || key == "content-type" || key == "if-none-match")
      if (!once.emplace(key, value).second)
        return HeadFault{400, "The header field " + key + " stands twice."};
  }
  RequestHead head{.method = method, .path = path};
  if (const auto host = once.find("host"); host != once.end()) head.host = without_port(host->second);
  if (head.host.empty()) return HeadFault{400, "The header field Host is missing."};
  const auto length = once.find("content-length");
  if (method == "POST") {
    if (length == once.end()) return HeadFault{411, "The header field Content-Length is missing."};
    head.content_bytes = length_of(length->second);
    if (head.content_bytes < 0) return HeadFault{400, "Content-Length is not a number."};
    if (head.content_bytes > most_request_bytes)
      return HeadFault{413, "The body has more than 1048576 bytes."};
  } else if (length != once.end() && length->second != "0") {
    return HeadFault{400, "This request may have no body."};
  }
  if (once.contains("expect")) return HeadFault{417, "The header field Expect is not supported."};
  if (const auto origin = once.find("origin"); origin != once.end()) {
    const auto host = once.find("host");
    if (host == once.end() || lower(host_of(origin->second)) != lower(host->second))
      return HeadFault{403, "Only this server's own page may ask (Origin)."};
  }
  if (const auto authorization = once.find("authorization"); authorization != once.end()) {
    const std::string scheme = "bearer ";
    if (lower(authorization->second.substr(0, scheme.size())) != scheme)
      return HeadFault{401, "Authorization must be Bearer and a secret of 64 hexadecimal digits."};
    head.secret = authorization->second.substr(scheme.size());
    if (head.secret.size() != 64 || head.secret.find_first_not_of("0123456789abcdef") != std::string::npos)
      return HeadFault{401, "Authorization must be Bearer and a secret of 64 hexadecimal digits."};
  }
  if (const auto version = once.find("if-none-match"); version != once.end())
    head.known_version = version->second;
  return head;
}

}  // namespace seamline::study::online
