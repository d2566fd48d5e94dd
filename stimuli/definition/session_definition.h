#pragma once
#include <array>
#include <optional>
#include <string>

namespace seamline::inline stimuli {

/// What becomes of a participant who comes again before the end.
enum class ResumePolicy {
  resume,   ///< goes on at the first trial without an answer
  restart,  ///< begins again; the earlier answers are set aside in the log and never analysed
  refuse    ///< is refused once anything has been answered
};

/// Questions, pace and orders of a session (paper section 4.2).
struct SessionDefinition {
  std::string question = "Which of the three objects was inserted into the picture?";
  std::string rating_question = "How noticeable was the insertion artifact?";
  std::array<std::string, 4> rating_labels = {"Slightly noticeable", "Moderately noticeable",
                                              "Very noticeable", "Extremely noticeable"};
  int break_every_trials = 28;
  double minimum_viewing_s = 0;  ///< a choice earlier than this after the picture's onset does not count
  double inter_trial_s = 0.5;    ///< grey with a fixation mark before each picture
  ResumePolicy resume = ResumePolicy::resume;
  int orders = 0;  ///< counterbalanced orders that people share; 0: everybody has an order of their own
  double text_scale = 1;        ///< size of the application's texts, 1: as designed
  std::string language = "en";  ///< of the texts, as a tag of BCP 47 ("de", "ar"): for the page in a browser
  std::string font = {};        ///< a TrueType file beside the study file; empty: the application's own
};

}  // namespace seamline::inline stimuli
