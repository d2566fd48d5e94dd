#include "analysis/log_analysis/participant_rows.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "analysis/log_analysis/participant_facts.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

std::string why_not(const ParticipantUse& person, const std::string& screens) {
  switch (person.use) {
    case Use::used:
      return "";
    case Use::excluded:
      return "excluded by the researcher";
    case Use::pilot:
      return "pilot";
    case Use::incomplete:
      return fmt::format("did not finish: {} of {} trials", person.answers, person.record.stimulus_trials);
    case Use::screened:
      return "named by " + screens;
    case Use::vision:
      return "vision neither normal nor corrected";
  }
  return "";
}

}  // namespace

std::vector<ParticipantRow> participant_rows(const Analysis& analysis) {
  std::map<std::string, int> rating_sum;
  for (const study::Answer& answer : analysis.log.answers) rating_sum[answer.participant] += answer.rating;
  std::map<std::string, std::string> screens;
  for (const ScreenedPerson& person : analysis.screening.people)
    for (ScreeningRule rule : every_screening_rule) {
      std::string& text = screens[person.code];
      if (person.named_by(rule)) text += (text.empty() ? "" : ", ") + std::string(word(rule));
    }
  const std::vector<std::string> questions = answered_questions(analysis.log);
  std::vector<ParticipantRow> rows;
  for (const ParticipantUse& person : analysis.people) {
    const std::string& code = person.record.code;
    const std::string named = screens.contains(code) ? screens[code] : "";
    rows.push_back(
        {.code = code,
         .kind = person.record.simulated ? "simulated: " + person.record.observer : "person",
         .use = person.use,
         .why = why_not(person, named),
         .pilot = person.record.pilot,
         .answers = person.answers,
         .stimulus_trials = person.record.stimulus_trials,
         .correct = person.correct,
         .mean_rating = person.answers > 0 ? rating_sum[code] / static_cast<double>(person.answers) : nan,
         .screens = named,
         .screened = screens.contains(code),
         .median_choice_s = person.median_choice_s,
         .form = {},
         .display = {}});
    if (const auto shown = analysis.options.displays.find(code); shown != analysis.options.displays.end())
      rows.back().display = shown->second;
    for (const std::string& question : questions)
      rows.back().form.push_back(answer_to(person.record, question));
  }
  return rows;
}

}  // namespace seamline::analysis
