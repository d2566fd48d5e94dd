#include "stimuli/definition/interface_texts.h"

namespace seamline::inline stimuli {

const std::vector<PhraseEntry>& every_phrase() {
  static const std::vector<PhraseEntry> table = {
      {Phrase::continue_button, "continue", "Continue"},
      {Phrase::back_button, "back", "Back"},
      {Phrase::left_object, "left_object", "on the left"},
      {Phrase::middle_object, "middle_object", "in the middle"},
      {Phrase::right_object, "right_object", "on the right"},
      {Phrase::consent_title, "consent_title", "Before you begin"},
      {Phrase::form_title, "form_title", "About you"},
      {Phrase::form_submit, "form_submit", "Continue"},
      {Phrase::form_optional, "form_optional", "may be left empty"},
      {Phrase::form_missing, "form_missing", "Please answer this."},
      {Phrase::form_not_a_number, "form_not_a_number", "Please enter a number, such as 33."},
      {Phrase::form_out_of_range, "form_out_of_range", "Please enter a number from {least} to {most}."},
      {Phrase::form_not_an_option, "form_not_an_option", "Please choose one of the answers."},
      {Phrase::display_title, "display_title", "The screen"},
      {Phrase::display_card, "display_card",
       "Hold a bank card against the screen and change the size of the frame until it is as large as the "
       "card."},
      {Phrase::display_distance, "display_distance", "Distance from your eyes to the screen in centimetres"},
      {Phrase::display_gamma, "display_gamma",
       "From where you sit, with your eyes half closed, the striped and the plain fields should look the "
       "same."},
      {Phrase::display_confirm, "display_confirm", "They look the same"},
      {Phrase::display_differ, "display_differ", "They look different"},
      {Phrase::instructions_title, "instructions_title", "Your task"},
      {Phrase::page_of, "page_of", "Page {page} of {pages}"},
      {Phrase::training_hint, "training_hint", "Practice {done} of {all}. These answers do not count."},
      {Phrase::ready_title, "ready_title", "Ready?"},
      {Phrase::ready_text, "ready_text",
       "From now on you will not be told whether you were right. Take the time that you need."},
      {Phrase::ready_button, "ready_button", "Begin"},
      {Phrase::choice_hint, "choice_hint", "Click an object, or press 1, 2 or 3"},
      {Phrase::rating_hint, "rating_hint", "Click an answer, or press 1, 2, 3 or 4"},
      {Phrase::progress, "progress", "{done} of {all}"},
      {Phrase::break_title, "break_title", "Time for a break"},
      {Phrase::break_text, "break_text",
       "{done} of {all} pictures are done. Rest your eyes, and go on when you are ready."},
      {Phrase::pause_title, "pause_title", "Pause"},
      {Phrase::pause_text, "pause_text",
       "Everything that you have answered is stored. The picture will be shown again."},
      {Phrase::pause_continue, "pause_continue", "Go on"},
      {Phrase::pause_leave, "pause_leave", "Leave for now"},
      {Phrase::thanks_title, "thanks_title", "Thank you"},
      {Phrase::thanks_text, "thanks_text",
       "You have seen all the pictures and your answers are stored. Please tell the experimenter that you "
       "are done."},
      {Phrase::declined_title, "declined_title", "Thank you for your time"},
      {Phrase::declined_text, "declined_text",
       "You have chosen not to take part. Nothing about you is stored."},
      {Phrase::stopped_title, "stopped_title", "The session has stopped"},
      {Phrase::stopped_text, "stopped_text",
       "Something could not be stored. Everything that you answered before is safe. Please call the "
       "experimenter.\n\n{message}"},
      {Phrase::close_button, "close", "Close"},
      {Phrase::text_size, "text_size", "Size of the text"},
      {Phrase::online_full_screen, "online_full_screen", "Use the whole screen"},
      {Phrase::online_left, "online_left",
       "You may close this page. The same link, in this browser on this computer, goes on where you "
       "stopped."},
      {Phrase::online_loading, "online_loading", "Pictures are being loaded: {done} of {all}"},
      {Phrase::online_away, "online_away",
       "The connection is lost. What you answered is kept on this computer, and the study goes on by itself "
       "when the connection is back."},
      {Phrase::online_save, "online_save", "Save my answers"},
      {Phrase::online_save_text, "online_save_text",
       "Your answers are on this computer only. Save them as a file, and send it to those who invited you."},
      {Phrase::online_saved, "online_saved", "Saved as {file}."},
      {Phrase::online_refused_title, "online_refused_title", "This does not work here"},
      {Phrase::online_tabs, "online_tabs",
       "The study is already open in another tab or window of this browser. Please go on there, or close it "
       "and load this page again."},
      {Phrase::online_small, "online_small",
       "The pictures and the questions below them need {wanted} pixels, and there are {found}. Please make "
       "this window as large as the screen."},
      {Phrase::online_zoom, "online_zoom",
       "With this zoom of the browser the pictures cannot be shown exactly. Please set it to 100 % (Ctrl and "
       "0)."},
      {Phrase::online_touch, "online_touch",
       "This study needs a computer with its own screen and a mouse or a keyboard. Please open the same link "
       "there."},
      {Phrase::online_browser, "online_browser",
       "This browser cannot show the pictures exactly, or cannot keep your answers ({message}). Please open "
       "the same link in a recent Firefox, Chrome or Edge, and not in a private window."},
      {Phrase::online_code, "online_code",
       "Your code in this study is {code}. Whoever wants their answers deleted quotes it: please note it "
       "down."},
      {Phrase::online_forgotten, "online_forgotten",
       "This study has no answers of yours any more: they were deleted. What this browser still keeps goes "
       "when you clear the data of this site in its settings.\n\nIf you did not ask for that, please tell "
       "those who invited you."},
      {Phrase::online_excluded, "online_excluded",
       "Those who run this study have ended your part in it. Nothing more is asked of you, and nothing "
       "more is stored.\n\nIf you think that this is a mistake, please tell them."},
      {Phrase::online_wait, "online_wait",
       "This page is being loaded. If these words stay, please load it again."},
      {Phrase::online_refusing, "online_refusing",
       "The study waits, because the answer from the network is: {message}. What you answered is kept on "
       "this computer, and the study goes on by itself. If these words stay, please tell those who invited "
       "you."},
      {Phrase::online_stopped, "online_stopped",
       "The study cannot go on: {message}\n\nPlease tell those who invited you."},
      {Phrase::online_unsent, "online_unsent",
       "Some of your answers may not have arrived. All are kept on this computer: save them as a file, "
       "and send it to those who invited you."},
      {Phrase::online_host, "online_host",
       "This page would send your answers elsewhere than to where they belong (wanted {wanted}, found "
       "{found}). Nothing was sent."},
  };
  return table;
}

std::string phrase_text(const InterfaceTexts& texts, Phrase phrase) {
  if (const auto found = texts.find(phrase); found != texts.end()) return found->second;
  return std::string(every_phrase()[static_cast<std::size_t>(phrase)].english);
}

std::string fill_in(std::string text, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string filled;
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool found = false;
    for (const auto& [name, value] : values) {
      const std::string place = "{" + name + "}";
      if (text.compare(i, place.size(), place) != 0) continue;
      filled += value;
      i += place.size() - 1;
      found = true;
      break;
    }
    if (!found) filled += text[i];
  }
  return filled;
}

}  // namespace seamline::inline stimuli
