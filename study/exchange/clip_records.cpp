#include "study/exchange/clip_records.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

#include "stimuli/study_file/moving/study_file_late_frames.h"
#include "study/exchange/trial_events.h"

namespace seamline::study {
namespace {

/// Takes "WORD NUMBER" from the front, and the blank behind it; false where something else stands there.
bool take_count(std::string_view& text, std::string_view word, int& count) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  if (!text.starts_with(' ')) return false;
  text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc() || count < 0) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.starts_with(' ')) text.remove_prefix(1);
  return true;
}

/// Of a trial that was shown twice in one session, as it was shown last.
std::map<TrialOfPerson, ClipCounts> counts_in(const LogContents& log) {
  std::map<TrialOfPerson, ClipCounts> counts;
  read_trial_events(log, "clip", "counts as \"shown 48 late 0 dropped 0\"",
                    [&](const TrialOfPerson& trial, const std::string& detail) {
                      const std::optional<ClipCounts> read = clip_counts_of(detail);
                      if (read) counts[trial] = *read;
                      return read.has_value();
                    });
  return counts;
}

/// The share of late and dropped frames above which the study marks a trial.
double most_late_share(const LogContents& log) {
  return read_late_frames_text(log.study_text, log.file).value_or(LateFrames{}).most_share;
}

}  // namespace

double ClipCounts::late_share() const {
  const double due = static_cast<double>(shown) + dropped;
  return due > 0 ? (static_cast<double>(late) + dropped) / due : 0;
}

std::optional<ClipCounts> clip_counts_of(const std::string& detail) {
  std::string_view text = detail;
  ClipCounts counts;
  const bool is_whole = take_count(text, "shown", counts.shown) && take_count(text, "late", counts.late) &&
                        take_count(text, "dropped", counts.dropped) && text.empty();
  if (!is_whole || counts.late > counts.shown) return std::nullopt;
  return counts;
}

std::vector<std::optional<ClipCounts>> read_clip_counts(const LogContents& log) {
  if (log.study_text.find("clip") == std::string::npos) return {};
  if (!read_late_frames_text(log.study_text, log.file)) return {};
  const std::map<TrialOfPerson, ClipCounts> counts = counts_in(log);
  std::vector<std::optional<ClipCounts>> of_answers;
  of_answers.reserve(log.answers.size());
  for (const Answer& answer : log.answers) {
    const auto found = counts.find({answer.participant, answer.trial_index});
    of_answers.push_back(found == counts.end() ? std::nullopt : std::optional(found->second));
  }
  return of_answers;
}

ClipColumns clip_columns(const LogContents& log, const std::optional<Anonymity>& anonymity) {
  ClipColumns out;
  if (anonymity) {
    if (anonymity->late_clips.empty()) return out;
    out.columns = {{"marked", "",
                    "1 where more of the clip's frames were late or dropped than late_frames_most of the "
                    "study's [analysis]; empty: not counted"}};
    for (const std::optional<bool>& late : anonymity->late_clips)
      out.rows.push_back({late ? CsvValue(std::int64_t{*late ? 1 : 0}) : CsvValue()});
    return out;
  }
  const std::vector<std::optional<ClipCounts>> counts = read_clip_counts(log);
  if (counts.empty()) return out;
  out.columns = {
      {"frames_shown", "frames", "of the clip that stood on the screen until the rating; empty: not counted"},
      {"frames_late", "frames", "of these, those that came more than two refreshes after their time"},
      {"frames_dropped", "frames", "that never stood there, because the next one's time had come"},
      {"late_share", "share 0 to 1", "late and dropped frames, of those that were due"},
      {"marked", "", "1 where that is more than late_frames_most of the study's [analysis]"}};
  const double most = most_late_share(log);
  for (const std::optional<ClipCounts>& one : counts)
    if (one)
      out.rows.push_back({std::int64_t{one->shown}, std::int64_t{one->late}, std::int64_t{one->dropped},
                          one->late_share(), std::int64_t{one->late_share() > most ? 1 : 0}});
    else
      out.rows.emplace_back(out.columns.size());
  return out;
}

void add_clip_columns(const LogContents& log, const std::optional<Anonymity>& anonymity, CsvTable& answers) {
  const ClipColumns clips = clip_columns(log, anonymity);
  answers.columns.insert(answers.columns.end(), clips.columns.begin(), clips.columns.end());
  for (std::size_t i = 0; i < clips.rows.size(); ++i)
    answers.rows[i].insert(answers.rows[i].end(), clips.rows[i].begin(), clips.rows[i].end());
}

std::vector<std::optional<bool>> late_clips(const LogContents& log) {
  std::vector<std::optional<bool>> out;
  const std::vector<std::optional<ClipCounts>> counts = read_clip_counts(log);
  if (counts.empty()) return out;
  const double most = most_late_share(log);
  for (const std::optional<ClipCounts>& one : counts)
    out.push_back(one ? std::optional(one->late_share() > most) : std::nullopt);
  return out;
}

}  // namespace seamline::study
