#pragma once
#include <string>

namespace seamline::inline stimuli {

/// What a participant reads before anything else, and the two answers.
struct ConsentDefinition {
  std::string text;  ///< paragraphs are separated by an empty line
  std::string accept = "I agree";
  std::string decline = "I do not agree";
  bool operator==(const ConsentDefinition&) const = default;
};

/// The shipped text: a frame that says what has to be filled in. Nobody but a pilot participant may be shown
/// it.
[[nodiscard]] ConsentDefinition default_consent();

/// Whether the text is the shipped one, whatever its layout: words are compared, spaces and line ends are
/// not.
[[nodiscard]] bool is_default_consent(const ConsentDefinition& consent);

}  // namespace seamline::inline stimuli
