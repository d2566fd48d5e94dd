#include "study/log/participant_code.h"

#include "support/text/error.h"

namespace seamline::study {

bool is_code(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
  return !text.empty() && text.size() <= 64 && text.find_first_not_of(letters) == std::string_view::npos;
}

void check_participant_code(const std::string& code) {
  if (is_code(code)) return;
  throw input_error(
      {.field = "participant",
       .wanted = "a code of 1 to 64 letters A-Z a-z, digits, dots, dashes and underscores (never a name)",
       .found = "\"" + code + "\""});
}

}  // namespace seamline::study
