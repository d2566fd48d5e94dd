#pragma once
#include <string>

#include "study/online/messages/message.h"

namespace seamline::study::online {

/// A message as one line of JSON, without a line end: what `read_message` reads back as the same value.
[[nodiscard]] std::string message_line(const Message& message);

/// SHA-256 of what a message says, whoever it is from: equal for the same message however it was spaced, and
/// before and after a server gave it its participant and slot.
[[nodiscard]] std::string content_sha256(const Message& message);

}  // namespace seamline::study::online
