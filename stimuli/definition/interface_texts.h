#pragma once
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace seamline::inline stimuli {

/// Every text of the application that a study file can translate in [texts]. The table in interface_texts.cpp
/// holds the key and the English text of each; `{word}` in a text is a place that is filled in.
enum class Phrase {
  continue_button,
  back_button,
  left_object,
  middle_object,
  right_object,
  consent_title,
  form_title,
  form_submit,
  form_optional,
  form_missing,
  form_not_a_number,
  form_out_of_range,
  form_not_an_option,
  display_title,
  display_card,
  display_distance,
  display_gamma,
  display_confirm,
  display_differ,
  instructions_title,
  page_of,
  training_hint,
  ready_title,
  ready_text,
  ready_button,
  choice_hint,
  rating_hint,
  progress,
  break_title,
  break_text,
  pause_title,
  pause_text,
  pause_continue,
  pause_leave,
  thanks_title,
  thanks_text,
  declined_title,
  declined_text,
  stopped_title,
  stopped_text,
  close_button,
  text_size,
  // Of the page in a browser alone (study/online/page).
  online_full_screen,
  online_left,
  online_loading,
  online_away,
  online_save,
  online_save_text,
  online_saved,
  online_refused_title,
  online_tabs,
  online_small,
  online_zoom,
  online_touch,
  online_browser,
  online_code,
  online_forgotten,
  online_excluded,
  online_wait,
  online_refusing,
  online_stopped,
  online_unsent,
  online_host,
};

struct PhraseEntry {
  Phrase phrase;
  std::string_view key;      ///< in [texts]
  std::string_view english;  ///< default
};

/// Every phrase once, in the order of the enumeration.
[[nodiscard]] const std::vector<PhraseEntry>& every_phrase();

/// The translations of a study; empty: English.
using InterfaceTexts = std::map<Phrase, std::string>;

/// The text to show.
[[nodiscard]] std::string phrase_text(const InterfaceTexts& texts, Phrase phrase);

/// Puts a value into each `{name}`; a place without a value stays as it is.
[[nodiscard]] std::string fill_in(std::string text,
                                  const std::vector<std::pair<std::string, std::string>>& values);

}  // namespace seamline::inline stimuli
