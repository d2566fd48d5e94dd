#include "study/exchange/dataset.h"

#include <fmt/core.h>

#include <algorithm>

#include "stimuli/definition/parts/task_definition.h"
#include "study/exchange/answer_tables.h"
#include "support/files/assets.h"
#include "support/text/counted.h"
#include "support/text/csv.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace {

bool ascii_letter_or_figure(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::vector<DatasetFile> plain_files(const LogContents& log, const std::optional<Anonymity>& anonymity) {
  std::vector<DatasetFile> files;
  for (const CsvTable& table : answer_tables(log, anonymity))
    files.push_back({table.name + ".csv", csv_text(table)});
  return files;
}

}  // namespace

std::string file_label(const std::string& name) {
  std::string label;
  std::copy_if(name.begin(), name.end(), std::back_inserter(label), ascii_letter_or_figure);
  return label.empty() ? "study" : label;
}

namespace {

/// What a trial asks.
std::string trial_sentence(const LogContents& log) {
  if (!log.own_tasks.empty()) return "What a trial asks follows from its condition, as `task` says.";
  const TaskFacts task = facts_of(log.task.get());
  if (task.kind != TaskKind::object) return "A trial asks: " + usual_texts(*log.task).question;
  return fmt::format(
      "A trial is a picture with {} objects; the participant says which one\n  was inserted by a "
      "computer{}.",
      number_word(task.objects),
      task.rates ? ", and how noticeable that is, from 1 (slightly) to 4 (extremely)" : "");
}

}  // namespace

std::string dataset_readme(const LogContents& log, const std::string& layout,
                           const std::optional<Anonymity>& anonymity) {
  const auto simulated = std::count_if(log.participants.begin(), log.participants.end(),
                                       [](const ParticipantRecord& p) { return p.simulated; });
  std::string text = fmt::format(
      "# {}\n\nAnswers to the study \"{}\", written by Seamline {} in the layout of {}.\n\n"
      "- People: {}{}. {}, each marked.\n"
      "- Answers: {} to stimuli, {} to catch trials. {}\n"
      "- Study file: SHA-256 of its settings {}. Stimuli: SHA-256 of their manifest {}.\n",
      clean_text(log.study_name), clean_text(log.study_name), program_version(), layout,
      log.participants.size(), simulated > 0 ? fmt::format(", {} of them simulated", simulated) : "",
      anonymity ? "The excluded and trial runs are among them"
                : "Everybody is in it, also the excluded and trial runs",
      log.answers.size(), log.catches.size(), trial_sentence(log), log.study_hash, log.set_hash);
  text += anonymity
              ? fmt::format(
                    "- Anonymised: codes are new, times are rounded to a tenth of a second, answers stand in "
                    "an order that\n  nobody saw, and of everybody at least {} people have the same row in "
                    "the table of participants (answers of the\n  form are \"other\" or \"withheld\" where "
                    "they would tell who it is).\n"
                    "- Left out: {}, because fewer than {} had finished, been excluded or made a trial "
                    "run as they had,\n  and the answers of {} who did not finish.\n",
                    anonymity->k, counted(anonymity->left_out_people, "person", "people"), anonymity->k,
                    anonymity->unfinished_people)
              : "- Not anonymised: codes are those of the log, and answers of the form are as given.\n";
  return text +
         "- Not said here, because the program does not know it: authors, licence, ethics approval. Add them "
         "before\n  you share this folder.\n";
}

std::vector<DatasetFile> dataset_files(const LogContents& log, TableLayout layout,
                                       const std::optional<Anonymity>& anonymity) {
  switch (layout) {
    case TableLayout::plain:
      return plain_files(log, anonymity);
    case TableLayout::psych_ds:
      return psych_ds_files(log, anonymity);
    case TableLayout::bids:
      return bids_files(log, anonymity);
  }
  return {};
}

}  // namespace seamline::study
