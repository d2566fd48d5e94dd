// What a browser sends: messages, enrolments, and the first lines of a request. What was read, written again,
// must be read as the same.
#include <algorithm>

#include "fuzz/fuzz_target.h"
#include "study/log/log_writer.h"
#include "study/online/messages/message_reader.h"
#include "study/online/messages/message_writer.h"
#include "study/online/serving/http_request.h"
#include "support/files/hash.h"

namespace {

using namespace seamline;
using namespace seamline::study::online;

void require_same_again(const Message& message) {
  const std::string line = message_line(message);
  if (line.find('\n') != std::string::npos || !(read_message(line) == message)) abort();
  if (content_sha256(read_message(line)) != content_sha256(message)) abort();
  if (!is_uuid4(message.id) || (!message.participant.empty() && !study::is_code(message.participant)))
    abort();
}

/// Method and path on the first line, then `name: value`.
void read_request(std::string_view text) {
  std::string method, path;
  HeaderFields fields;
  for (int line = 0; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t colon = std::min(one.find(line == 0 ? ' ' : ':'), one.size());
    const std::string first(one.substr(0, colon)), second(one.substr(std::min(colon + 1, one.size())));
    if (line == 0) {
      method = first;
      path = second;
    } else {
      fields.emplace_back(first, second);
    }
  }
  const auto head = read_head(method, path, fields);
  if (const auto* good = std::get_if<RequestHead>(&head)) {
    if (good->content_bytes < 0 || good->content_bytes > most_request_bytes || good->path.front() != '/')
      abort();
    if (good->host.empty()) abort();
    if (!good->secret.empty() && !is_sha256(good->secret)) abort();
  } else if (std::get<HeadFault>(head).status < 400) {
    abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  fuzz::only_input_errors([&] { require_same_again(read_message(text)); });
  fuzz::only_input_errors([&] { require_same_again(read_enrol_request(text).message); });
  read_request(text);
  return 0;
}
