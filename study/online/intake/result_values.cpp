#include "study/online/intake/result_values.h"

#include <algorithm>

#include "study/online/messages/message.h"

namespace seamline::study::online {
namespace {

constexpr std::string_view spaces = " \t\r\n";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::size_t skip_spaces(std::string_view text, std::size_t at) {
  return std::min(text.find_first_not_of(spaces, at), text.size());
}

/// Behind the brace that closes the one at `at`; npos when it is not before `limit`.
std::size_t end_of_object(std::string_view text, std::size_t at, std::size_t limit) {
  int depth = 0;
  bool in_text = false;
  for (; at < limit; ++at) {
    const char letter = text[at];
    if (in_text) {
      if (letter == '\\') ++at;
      if (letter == '"') in_text = false;
    } else if (letter == '"') {
      in_text = true;
    } else if (letter == '{') {
      ++depth;
    } else if (letter == '}' && --depth == 0) {
      return at + 1;
    }
  }
  return std::string_view::npos;
}

constexpr std::string_view format_begins = "\"seamline-online-";
static_assert(message_format.starts_with(format_begins.substr(1)));

/// Whether `text` at `at` goes on with `"format": "seamline-online-`, as every page begins its messages.
bool is_format(std::string_view text, std::size_t at) {
  for (const std::string_view word : {std::string_view("\"format\""), std::string_view(":"), format_begins}) {
    at = skip_spaces(text, at);
    if (!text.substr(at).starts_with(word)) return false;
    at += word.size();
  }
  return true;
}

}  // namespace

std::size_t ResultValues::next_message(std::size_t from) {
  if (known_message_ >= from) return known_message_;
  for (std::size_t at = bytes_.find('{', from); at != std::string_view::npos; at = bytes_.find('{', at + 1))
    if (is_format(bytes_, at + 1)) return known_message_ = at;
  return known_message_ = bytes_.size();
}

void ResultValues::pass(std::size_t end) {
  const auto lines = std::count(bytes_.begin() + at_, bytes_.begin() + end, '\n');
  if (lines > 0) value_in_line_ = 0;
  line_ += static_cast<int>(lines);
  at_ = end;
}

void ResultValues::skip_space() {
  for (;;) {
    pass(skip_spaces(bytes_, at_));
    const std::string_view rest = bytes_.substr(at_);
    const std::size_t behind = skip_spaces(bytes_, at_ + 1);
    if (rest.starts_with(byte_order_mark)) {
      pass(at_ + byte_order_mark.size());
    } else if (!in_array_ && rest.starts_with('[') && behind < bytes_.size() && bytes_[behind] == '{') {
      in_array_ = true;
      pass(at_ + 1);
    } else if (in_array_ && (rest.starts_with(',') || rest.starts_with(']'))) {
      in_array_ = !rest.starts_with(']');
      pass(at_ + 1);
    } else {
      return;
    }
  }
}

bool ResultValues::next(ResultValue& value) {
  skip_space();
  if (at_ >= bytes_.size()) return false;
  value.line = line_;
  value.value_in_line = ++value_in_line_;
  const std::size_t begin = at_, message = next_message(begin + 1);
  std::size_t end = std::string_view::npos;
  if (bytes_[begin] == '{') {
    end = end_of_object(bytes_, begin, message);
    value.kind = end != std::string_view::npos ? ResultValue::Kind::whole : ResultValue::Kind::foreign;
    if (end == std::string_view::npos) end = message;
  } else {
    value.kind = ResultValue::Kind::foreign;
    end = std::min({bytes_.find('\n', begin), message, bytes_.size()});
  }
  value.text = bytes_.substr(begin, end - begin);
  value.text = value.text.substr(0, value.text.find_last_not_of(spaces) + 1);
  if (value.kind == ResultValue::Kind::foreign && bytes_[begin] == '{' && end == bytes_.size() &&
      value.text.find('\n') == std::string_view::npos)
    value.kind = ResultValue::Kind::cut;
  value.last_line = line_ + static_cast<int>(std::count(value.text.begin(), value.text.end(), '\n'));
  pass(end);
  return true;
}

}  // namespace seamline::study::online
