#pragma once
#include "study/online/serving/http_request.h"

#ifdef SEAMLINE_HAS_SERVER

#include <microhttpd.h>

#include <map>
#include <mutex>

namespace seamline::study::online {

/// Answers as libmicrohttpd sends them, with what browsers are told of each: its type, who may show it, what
/// may be kept of it. For several threads.
class HttpResponses {
 public:
  HttpResponses() = default;
  ~HttpResponses();
  HttpResponses(const HttpResponses&) = delete;
  HttpResponses& operator=(const HttpResponses&) = delete;

  /// One with a file is made once, sent to everybody and freed at the end; any other is the caller's to free.
  [[nodiscard]] MHD_Response* of(const HttpResponse& response);

 private:
  std::map<const SentFile*, MHD_Response*> files_;
  std::mutex lock_;
};

}  // namespace seamline::study::online

#endif
