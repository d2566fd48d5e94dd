#include "stimuli/study_file/study_file_session.h"

#include <algorithm>

#include "stimuli/settings/people/analysis_settings.h"
#include "stimuli/settings/people/session_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/moving/study_file_late_frames.h"
#include "stimuli/study_file/people/study_file_language.h"

namespace seamline::inline stimuli {
namespace {

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
  read_labels(table, session);
  read_settings(table, session);
  table.finish();
  return session;
}

CatchDefinition read_catches(const TomlTable& table) {
  CatchDefinition catches;
  read_settings(table, catches);
  table.finish();
  return catches;
}

AnalysisDefinition read_analysis(const TomlTable& analysis) {
  AnalysisDefinition read;
  read_settings(analysis, read);
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
  static_cast<void>(read_late_frames(analysis));
  analysis.finish();
  return read;
}

}  // namespace seamline::inline stimuli
