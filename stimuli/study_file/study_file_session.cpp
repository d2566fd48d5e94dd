#include "stimuli/study_file/study_file_session.h"

#include <algorithm>

#include "stimuli/study_file/study_file_words.h"

namespace seamline::inline stimuli {
namespace {

/// Catch trials of one kind that a session may have; more would be another study.
constexpr double most_catches = 1000;

void read_labels(const TomlTable& table, SessionDefinition& session) {
  if (!table.has("rating_labels")) return;
  const std::vector<std::string> labels = table.texts("rating_labels");
  if (labels.size() != session.rating_labels.size())
    throw table.complaint("rating_labels", "four texts", std::to_string(labels.size()));
  std::copy(labels.begin(), labels.end(), session.rating_labels.begin());
}

}  // namespace

SessionDefinition read_session(const TomlTable& table) {
  SessionDefinition session;
  session.question = table.text("question", session.question);
  session.rating_question = table.text("rating_question", session.rating_question);
  read_labels(table, session);
  session.break_every_trials =
      table.integer("break_every_trials", session.break_every_trials, {1, 100000, "trials"});
  session.minimum_viewing_s = table.number("minimum_viewing_s", session.minimum_viewing_s, {0, 60, "s"});
  session.inter_trial_s = table.number("inter_trial_s", session.inter_trial_s, {0, 60, "s"});
  session.resume = one_of<ResumePolicy>(table, "resume", session.resume,
                                        {{"resume", ResumePolicy::resume},
                                         {"restart", ResumePolicy::restart},
                                         {"refuse", ResumePolicy::refuse}});
  session.orders = table.integer("orders", session.orders, {0, 100000, "orders"});
  session.text_scale = table.number("text_scale", session.text_scale, {0.5, 4});
  session.font = table.text("font", session.font);
  table.finish();
  return session;
}

CatchDefinition read_catches(const TomlTable& table) {
  CatchDefinition catches;
  catches.attention = table.integer("attention", catches.attention, {0, most_catches, "trials"});
  catches.reference = table.integer("reference", catches.reference, {0, most_catches, "trials"});
  table.finish();
  return catches;
}

}  // namespace seamline::inline stimuli
