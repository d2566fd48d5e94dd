#include "analysis/log_analysis/participant_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include "analysis/log_analysis/task_words.h"

namespace seamline::analysis {

namespace {

/// Under this many people intervals over participants were seen to fail (documentation/evidence/coverage.md).
constexpr int fewest_for_intervals = 5;

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "21 to 40, mean 30.5".
std::string numbers_range_text(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  double sum = 0;
  for (const double value : values) sum += value;
  if (*low == *high) return fmt::format("{:.4g}", *low);
  return fmt::format("{:.4g} to {:.4g}, mean {:.4g}", *low, *high, sum / values.size());
}

/// "Technical background".
std::string as_title(std::string question) {
  std::replace(question.begin(), question.end(), '_', ' ');
  if (!question.empty() && question[0] >= 'a' && question[0] <= 'z')
    question[0] = static_cast<char>(question[0] - 'a' + 'A');
  return question;
}

/// Numbers as a range, all else as counts, the most frequent first.
std::string sentence_on(const std::string& question, const std::vector<std::string>& answers, int silent) {
  std::vector<double> numbers;
  std::map<std::string, int> count;
  for (const std::string& answer : answers) {
    ++count[answer];
    if (const std::optional<double> number = number_in(answer)) numbers.push_back(*number);
  }
  std::string text;
  if (numbers.size() == answers.size()) {
    text = numbers_range_text(numbers);
  } else {
    std::vector<std::pair<std::string, int>> sorted(count.begin(), count.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](auto& a, auto& b) { return a.second > b.second; });
    for (const auto& [answer, people] : sorted)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", people, answer);
  }
  return fmt::format("{}: {}{}.", as_title(question), text,
                     silent > 0 ? fmt::format("; {} did not say", silent) : "");
}

void add_screens(const std::vector<const study::ParticipantRecord*>& used,
                 const std::map<std::string, study::ShownOn>& displays, std::vector<std::string>& sentences) {
  std::map<std::pair<int, int>, int> modes;
  std::vector<double> distances_mm, pixels_per_degree;
  for (const study::ParticipantRecord* record : used) {
    const auto found = displays.find(record->code);
    if (found == displays.end()) continue;
    const study::ShownOn& display = found->second;
    if (display.mode_width_px > 0) ++modes[{display.mode_width_px, display.mode_height_px}];
    if (display.viewing_distance_mm > 0) distances_mm.push_back(display.viewing_distance_mm);
    if (display.pixels_per_degree > 0) pixels_per_degree.push_back(display.pixels_per_degree);
  }
  if (!modes.empty()) {
    std::string text;
    for (const auto& [mode, people] : modes)
      text += fmt::format("{}{} × {} px ({})", text.empty() ? "" : ", ", mode.first, mode.second, people);
    sentences.push_back("Screens, with the number of participants: " + text + ".");
  }
  if (!distances_mm.empty())
    sentences.push_back(
        fmt::format("Viewing distance, as entered: {} mm.", numbers_range_text(distances_mm)));
  if (!pixels_per_degree.empty())
    sentences.push_back(fmt::format("Pixels a degree at the middle of the screen: {}.",
                                    numbers_range_text(pixels_per_degree)));
}

}  // namespace

std::vector<std::string> answered_questions(const study::LogContents& log) {
  std::set<std::string> questions;
  for (const study::ParticipantRecord& record : log.participants)
    for (const FormAnswer& answer : record.form) questions.insert(answer.field);
  return {questions.begin(), questions.end()};
}

std::string answer_to(const study::ParticipantRecord& record, const std::string& question) {
  for (const FormAnswer& answer : record.form)
    if (answer.field == question) return answer.value;
  return "";
}

std::vector<std::string> participants_described(const Analysis& analysis) {
  std::vector<const study::ParticipantRecord*> used;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) used.push_back(&person.record);
  std::vector<std::string> sentences;
  for (const std::string& question : answered_questions(analysis.log)) {
    std::vector<std::string> answers;
    for (const study::ParticipantRecord* record : used)
      if (std::string answer = answer_to(*record, question); !answer.empty())
        answers.push_back(std::move(answer));
    if (!answers.empty())
      sentences.push_back(sentence_on(question, answers, static_cast<int>(used.size() - answers.size())));
  }
  add_screens(used, analysis.options.displays, sentences);
  return sentences;
}

ParticipantGroups technical_groups(const Analysis& analysis) {
  ParticipantGroups groups;
  for (const ParticipantUse& person : analysis.people) {
    if (person.use != Use::used) continue;
    const std::string answer = answer_to(person.record, technical_question);
    if (answer == "yes" || answer == "no")
      groups[person.record.code] = answer == "yes" ? "technical" : "other";
  }
  return groups;
}

std::string few_people_sentence(const Analysis& analysis) {
  const int used = analysis.counts.used;
  if (used < 2 || used >= fewest_for_intervals) return {};
  if (!asks_ratings(analysis.log))
    return fmt::format(
        "With {} participants little is known of how people differ: intervals over participants are wide, and "
        "each participant's own thresholds (thresholds_people.csv) say more.",
        used);
  return fmt::format(
      "With {} participants the 95 % intervals hold the truth less often than they say: in simulated studies of "
      "two to four people those of IP in 59 to 93 %, those of PT and SN in 82 to 98 %.",
      used);
}

}  // namespace seamline::analysis
