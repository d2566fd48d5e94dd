#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What the answers of a log's task are called in sentences and figures.
struct TaskWords {
  bool rated = true;     ///< means are noticeability, 0 to 4; else shares, 0 to 1
  bool of_three = true;  ///< chance is 1/3 exactly
  double chance = 1.0 / 3;
  std::string mean, Mean;        ///< "mean noticeability"; "share of right answers"; "share of yes"
  std::string title;             ///< "Noticeability"; "Right answers"; "Answers of yes"
  std::string right_choices;     ///< "right choices"; "yes"
  std::string of_right_choices;  ///< "Share of right choices"; "Share of yes"
  std::string choices_title;     ///< "Right choices"; "Answers of yes"
  std::string chance_word;       ///< "chance"; "false alarms"
  std::string chance_text;       ///< "chance, 1/2"; "false alarms, 0.12"
  std::string wrong;             ///< "the wrong object was chosen"
  std::string procedure;         ///< what a trial showed and asked, sentences for a paper; empty: the paper's
  std::string chance_number;     ///< "1/2"; "the share of false alarms"
  std::string guess;             ///< what somebody who sees nothing scores, a sentence for a paper
};
[[nodiscard]] TaskWords task_words(const Analysis& analysis);

/// Whether people rated what they saw: else PT, SN, IP and the paper's way mean nothing.
[[nodiscard]] bool asks_ratings(const study::LogContents& log);

/// Three objects to choose among, and a rating.
[[nodiscard]] bool is_papers_task(const study::LogContents& log);

/// What the way of the paper can say of another task, a sentence each; none of the paper's.
[[nodiscard]] std::vector<std::string> notes_on_task(const study::LogContents& log);

/// Of a task without ratings whose participants are all `threshold` observers: the x of LevelAxis at which
/// they see half, by artifact and condition. Empty otherwise.
using PlantedDetection = std::map<std::pair<Artifact, std::string>, double>;
[[nodiscard]] PlantedDetection planted_detection(const Analysis& analysis);

/// Where people were not asked for a rating: takes out PT, SN and IP of every kind, with the reason in their
/// place, and what is made of them.
void set_aside_unrated(Analysis& analysis);

}  // namespace seamline::analysis
