#include "study/online/serving/http_responses.h"

#ifdef SEAMLINE_HAS_SERVER

#include <unistd.h>

namespace seamline::study::online {
namespace {

/// The first page's own policy, in the page, holds beside this one, and names the script within it by its
/// hash.
constexpr const char* content_security_policy =
    "default-src 'none'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' blob: data:; font-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

}  // namespace

HttpResponses::~HttpResponses() {
  for (const auto& [file, response] : files_) MHD_destroy_response(response);
}

MHD_Response* HttpResponses::of(const HttpResponse& response) {
  const auto header = [](MHD_Response* made, const char* name, const std::string& value) {
    MHD_add_response_header(made, name, value.c_str());
  };
  const auto common = [&](MHD_Response* made, const std::string& type) {
    header(made, "Content-Type", type);
    header(made, "X-Content-Type-Options", "nosniff");
    header(made, "Referrer-Policy", "no-referrer");
    header(made, "Cross-Origin-Resource-Policy", "same-origin");
  };
  if (!response.file) {
    MHD_Response* made = MHD_create_response_from_buffer(
        response.body.size(), const_cast<char*>(response.body.data()), MHD_RESPMEM_MUST_COPY);
    if (response.status == 304) return made;  // says nothing of a type: what the browser has keeps its own
    common(made, "application/json; charset=utf-8");
    header(made, "Cache-Control", "no-store");
    return made;
  }
  const std::lock_guard guard(lock_);
  MHD_Response*& made = files_[response.file.get()];
  if (made == nullptr) {
    const SentFile& file = *response.file;
    if (file.descriptor >= 0)
      made =
          MHD_create_response_from_fd64(static_cast<std::uint64_t>(file.size_bytes), ::dup(file.descriptor));
    else
      made = MHD_create_response_from_buffer(file.bytes.size(), const_cast<char*>(file.bytes.data()),
                                             MHD_RESPMEM_PERSISTENT);
    common(made, file.content_type);
    header(made, "ETag", file.version);
    header(made, "Cache-Control", "no-cache");
    header(made, "Content-Security-Policy", content_security_policy);
    header(made, "X-Frame-Options", "DENY");
  }
  return made;
}

}  // namespace seamline::study::online

#endif
