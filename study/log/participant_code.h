#pragma once
#include <string>
#include <string_view>

namespace seamline::study {

/// Whether a text is a participant's code: 1 to 64 of A-Z a-z 0-9 . _ -
[[nodiscard]] bool is_code(std::string_view text);

/// Throws InputError unless the code is one that the log takes (see Enrolment).
void check_participant_code(const std::string& code);

}  // namespace seamline::study
