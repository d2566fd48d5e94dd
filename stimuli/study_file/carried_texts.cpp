#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "stimuli/definition/people/form_kinds.h"
#include "stimuli/study_file/carried_files.h"
#include "support/files/toml_table.h"
#include "support/text/pattern.h"
#include "support/text/printable.h"

namespace seamline::inline stimuli {
namespace {

// What a page says of a whole form is one message, which has bounds (study/online/messages/message.h).
constexpr std::size_t most_form_fields = 200, most_form_bytes = 60'000;
constexpr std::size_t most_name_bytes = 60;  ///< three of them are part of a picture's file name
/// JSON around an answer, and what a message has besides them: far above the truth.
constexpr std::size_t bytes_around_answer = 32, bytes_around_form = 2000;

/// Paragraphs that people read. Every other text is one line.
bool may_have_lines(const std::string& field) {
  static const Pattern paragraphs(
      "consent\\.text|instructions\\.page\\[\\d+\\]\\.text|training\\.feedback_(right|wrong)|"
      "session\\.(rating_)?question|form_field\\[\\d+\\]\\.label|texts\\..*");
  return paragraphs.matches(field);
}

void check_letters(const TomlTable& table, const std::string& field, const std::string& text) {
  constexpr std::size_t whole = std::numeric_limits<std::size_t>::max();
  const bool lines = may_have_lines(field);
  if ((lines ? clean_text(text, whole) : printable(text, whole)) == text) return;
  throw table.complaint(
      field,
      fmt::format("{} without control characters, line separators and marks that turn the direction of text",
                  lines ? "a text" : "a text of one line"),
      "\"" + printable(text, 80) + "\"");
}

void check_name(const TomlTable& table, const std::string& field, const std::string& name) {
  if (name.size() <= most_name_bytes) return;
  throw table.complaint(field, fmt::format("at most {} letters", most_name_bytes),
                        fmt::format("{}", name.size()));
}

/// As JSON has it: a quotation mark and a backslash are two bytes.
std::size_t json_bytes(const std::string& text) {
  return text.size() + static_cast<std::size_t>(std::count(text.begin(), text.end(), '"')) +
         static_cast<std::size_t>(std::count(text.begin(), text.end(), '\\'));
}

std::size_t longest_answer_bytes(const FormField& field) {
  std::size_t longest = 0;
  if (const auto* options = options_of(field))
    for (const std::string& option : *options) longest = std::max(longest, json_bytes(option));
  return longest;
}

void check_form(const TomlTable& table, const std::vector<FormField>& form) {
  if (form.size() > most_form_fields)
    throw table.complaint("form_field", fmt::format("at most {} questions", most_form_fields),
                          fmt::format("{}", form.size()));
  std::size_t bytes = bytes_around_form;
  for (std::size_t i = 0; i < form.size(); ++i) {
    check_name(table, fmt::format("form_field[{}].name", i), form[i].name);
    bytes += form[i].name.size() + longest_answer_bytes(form[i]) + bytes_around_answer;
  }
  if (bytes > most_form_bytes)
    throw table.complaint(
        "form_field",
        fmt::format("options so short that all answers together have at most {} bytes", most_form_bytes),
        fmt::format("up to {}", bytes));
}

}  // namespace

void check_carried_texts(const TomlTable& table, const StudyDefinition& study) {
  table.for_each_text(
      [&](const std::string& field, const std::string& text) { check_letters(table, field, text); });
  for (std::size_t i = 0; i < study.scenes.size(); ++i) {
    check_name(table, fmt::format("scene[{}].name", i), study.scenes[i].name);
    for (std::size_t k = 0; k < study.scenes[i].objects.size(); ++k)
      check_name(table, fmt::format("scene[{}].object[{}].name", i, k), study.scenes[i].objects[k].name);
  }
  check_form(table, study.form);
}

}  // namespace seamline::inline stimuli
