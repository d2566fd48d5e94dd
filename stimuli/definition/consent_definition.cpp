#include "stimuli/definition/consent_definition.h"

#include <cctype>

namespace seamline::inline stimuli {
namespace {

constexpr const char* shipped_text =
    R"(TEMPLATE: replace this text by the one that your ethics board has approved.

You are invited to take part in a study of how people see pictures. You will be shown pictures of rooms and places, and for each of them you will be asked which of three objects was inserted into it, and how noticeable that was. This takes about [MINUTES] minutes.

Taking part is voluntary. You may stop at any time, without giving a reason and without any disadvantage. You may ask for your answers to be deleted until [DATE].

Your answers are stored under a code and not under your name, together with the answers to a short form about you. They are used for research and may be published without anything that identifies you.

Questions: [NAME], [ADDRESS].

By choosing "I agree" you say that you are at least [AGE] years old, that you have read this text, and that you take part of your own will.)";

/// The words of a text with one space between them.
std::string without_spacing(const std::string& text) {
  std::string words;
  bool gap = false;
  for (const char letter : text) {
    if (std::isspace(static_cast<unsigned char>(letter)) != 0) {
      gap = !words.empty();
      continue;
    }
    if (gap) words += ' ';
    gap = false;
    words += letter;
  }
  return words;
}

}  // namespace

ConsentDefinition default_consent() {
  ConsentDefinition consent;
  consent.text = shipped_text;
  return consent;
}

bool is_default_consent(const ConsentDefinition& consent) {
  return without_spacing(consent.text) == without_spacing(shipped_text);
}

}  // namespace seamline::inline stimuli
