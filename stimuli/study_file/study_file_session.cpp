#include "stimuli/study_file/study_file_session.h"

#include <algorithm>

#include "stimuli/study_file/people/study_file_language.h"
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

std::string read_language(const TomlTable& table, const std::string& usual) {
  const std::string language = table.text("language", usual);
  if (!is_language_tag(language))
    throw table.complaint("language", "a tag such as \"en\" or \"pt-BR\"", "\"" + language + "\"");
  return language;
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
  session.language = read_language(table, session.language);
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

AnalysisDefinition read_analysis(const TomlTable& analysis) {
  AnalysisDefinition read;
  read.joint = one_of<bool>(analysis, "model", true, {{"joint", true}, {"paper", false}});
  if (analysis.has("share")) {
    if (!read.joint)
      throw analysis.complaint("share", "model = \"joint\" beside it (straight lines share nothing)",
                               "model = \"paper\"");
    const std::vector<std::string> words = analysis.texts("share");
    read.sharing_tested = words.size() == 1 && words[0] == "tested";
    for (const SharedBlock& block : shared_blocks) read.*block.shared = read.sharing_tested;
    for (const std::string& word : words) {
      if (words.size() == 1 && (word == "nothing" || word == "tested")) break;
      const SharedBlock* block = shared_block(word);
      if (block == nullptr || read.*block->shared)
        throw analysis.complaint("share",
                                 "each of \"scale\", \"criteria\", \"lapse\", \"guess_ratings\" at most once",
                                 "\"" + word + "\"");
      read.*block->shared = true;
    }
  }
  if (analysis.has("compare")) read.compare = analysis.texts("compare");
  analysis.finish();
  return read;
}

}  // namespace seamline::inline stimuli
