#pragma once
#include <map>
#include <string>
#include <string_view>

#include "study/online/messages/message.h"

namespace seamline::study::online {

/// Reads one message from one line (without its end). Everything is checked that can be checked without the
/// study: keys, kinds of values, ranges, lengths, UTF-8. Throws InputError with one sentence.
[[nodiscard]] Message read_message(std::string_view line);

/// What a page sends to be enrolled, or to say that somebody declined.
struct EnrolRequest {
  std::string token = {};  ///< of an invitation; empty: none
  Message message;         ///< an enrolment without participant and slot, or a decline
  /// Of the link, by name, where the study names any ([recruitment]).
  std::map<std::string, std::string> identifiers = {};
};

/// Reads {"token": TEXT or null, "message": MESSAGE}, perhaps with "identifiers": {NAME: TEXT, ...}. Throws
/// InputError with one sentence.
[[nodiscard]] EnrolRequest read_enrol_request(std::string_view text);

/// Whether a text is a UUID of version 4, in lower case with dashes.
[[nodiscard]] bool is_uuid4(std::string_view text);

}  // namespace seamline::study::online
