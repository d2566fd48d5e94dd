#include "study/online/intake/import.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "study/log/log.h"
#include "study/online/intake/intake.h"
#include "study/online/messages/message_reader.h"
#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

struct FiledMessage {
  Message message;
  std::string place;  ///< file and line
};

/// All that files say, by participant; those who declined under the empty code.
struct FiledMessages {
  std::map<std::string, std::vector<FiledMessage>> of_participant;
  int count = 0;
  std::vector<std::string> cut_files;
};

void check_of_set(const RenderedSet& set, const FiledMessage& filed) {
  const auto check = [&](const char* field, const std::string& wanted, const std::string& found) {
    if (wanted == found) return;
    throw input_error({.file = filed.place,
                       .field = field,
                       .wanted = wanted + ", of the log's study and set (nothing was imported)",
                       .found = "\"" + printable(found, 80) + "\""});
  };
  check("study_hash", set.manifest.study_hash, filed.message.study_hash);
  check("set_hash", set.set_hash, filed.message.set_hash);
}

void read_messages(const fs::path& file, const RenderedSet& set, FiledMessages& all) {
  const std::string bytes = read_file(file);
  std::size_t at = 0;
  for (int line = 1; at < bytes.size(); ++line) {
    stop_if_interrupted();
    const std::size_t end = bytes.find('\n', at);
    const bool is_last = end == std::string::npos;
    std::string_view text(bytes.data() + at, (is_last ? bytes.size() : end) - at);
    at = is_last ? bytes.size() : end + 1;
    if (text.ends_with('\r')) text.remove_suffix(1);
    if (text.find_first_not_of(" \t") == std::string_view::npos) continue;
    FiledMessage filed{.message = {}, .place = fmt::format("{}:{}", file.string(), line)};
    try {
      filed.message = read_message(text);
    } catch (const InputError& error) {
      if (is_last) {  // without its line end: the browser, or the network, stopped in the middle
        all.cut_files.push_back(file.string());
        return;
      }
      throw input_error({.file = filed.place, .field = error.what()});
    }
    check_of_set(set, filed);
    ++all.count;
    all.of_participant[filed.message.participant].push_back(std::move(filed));
  }
}

/// The order in which people consented, as far as their enrolments are there; then their codes.
std::vector<std::string> in_order(const FiledMessages& all) {
  std::vector<std::pair<std::int64_t, std::string>> order;
  for (const auto& [code, messages] : all.of_participant) {
    std::int64_t accepted = 0;
    for (const FiledMessage& filed : messages)
      if (const auto* enrol = std::get_if<EnrolBody>(&filed.message.body)) accepted = enrol->accepted_unix_s;
    order.emplace_back(accepted, code);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::string> codes;
  for (auto& [accepted, code] : order) codes.push_back(std::move(code));
  return codes;
}

void import_declines(Intake& intake, const std::vector<FiledMessage>& messages, ImportReport& report) {
  for (const FiledMessage& filed : messages)
    if (std::holds_alternative<DeclineBody>(filed.message.body))
      report.declined += intake.take(filed.message) ? 1 : 0;
}

ImportedPerson import_person(Intake& intake, std::vector<FiledMessage> messages) {
  std::stable_sort(messages.begin(), messages.end(), [](const FiledMessage& one, const FiledMessage& other) {
    return one.message.sequence < other.message.sequence;
  });
  ImportedPerson person{.code = messages.front().message.participant};
  for (const FiledMessage& filed : messages) try {
      stop_if_interrupted();
      ++(intake.take(filed.message) ? person.stored : person.known);
    } catch (const Refusal& refusal) {
      person.refused.push_back(fmt::format("{}: {}", filed.place, refusal.what()));
    }
  try {
    const Whereabouts now = intake.where(person.code);
    person.origin = now.origin;
    person.answered = static_cast<int>(now.answered.size());
    person.trials = now.trials;
    person.completed = now.completed;
    person.gaps = intake.gaps(person.code);
  } catch (const Refusal&) {
    // not enrolled: every message was refused with that sentence
  }
  return person;
}

/// 3, 7-9
std::string ranges(const std::vector<std::int64_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i;
    while (end + 1 < numbers.size() && numbers[end + 1] == numbers[end] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", numbers[i]);
    if (end > i) text += fmt::format("-{}", numbers[end]);
    i = end + 1;
  }
  return text;
}

std::string person_text(const ImportedPerson& person) {
  std::string text =
      fmt::format("{}  {}  {} of {} trials answered, {}", person.code, word(person.origin), person.answered,
                  person.trials, person.completed ? "complete" : "incomplete");
  text += fmt::format("; {} messages new, {} known", person.stored, person.known);
  if (!person.gaps.empty()) text += "; missing messages: " + ranges(person.gaps);
  text += "\n";
  for (const std::string& sentence : person.refused) text += fmt::format("  left out: {}\n", sentence);
  return text;
}

}  // namespace

ImportReport import_messages(const RenderedSet& set, const fs::path& log,
                             const std::vector<fs::path>& files) {
  FiledMessages all;
  for (const fs::path& file : files) read_messages(file, set, all);
  ImportReport report{
      .files = static_cast<int>(files.size()), .messages = all.count, .cut_files = all.cut_files};
  if (all.count == 0)
    throw input_error({.file = files.empty() ? "seamline import" : files.front().string(),
                       .wanted = "lines of messages",
                       .found = "none"});
  Intake intake(set, log, KnownNames::also_of_the_set);
  intake.transaction([&] {
    for (const std::string& code : in_order(all)) {
      std::vector<FiledMessage>& messages = all.of_participant[code];
      if (code.empty())
        import_declines(intake, messages, report);
      else
        report.people.push_back(import_person(intake, std::move(messages)));
    }
  });
  return report;
}

std::string import_text(const ImportReport& report, const fs::path& log) {
  int stored = 0, known = 0, complete = 0;
  std::size_t refused = 0;
  for (const ImportedPerson& person : report.people) {
    stored += person.stored;
    known += person.known;
    refused += person.refused.size();
    complete += person.completed ? 1 : 0;
  }
  std::string text = fmt::format(
      "{}: {} messages of {} participants in {} files: {} new, {} known, {} left out; {} participants "
      "complete, "
      "{} incomplete, {} declined\n",
      log.string(), report.messages, report.people.size(), report.files, stored, known, refused, complete,
      report.people.size() - static_cast<std::size_t>(complete), report.declined);
  for (const std::string& file : report.cut_files)
    text += fmt::format("{}: the last line ends in the middle and was left out\n", file);
  for (const ImportedPerson& person : report.people) text += person_text(person);
  return text;
}

RenderedSet set_for_log(const fs::path& log, const fs::path& given) {
  if (!given.empty()) return load_rendered_set(given);
  if (!fs::exists(log))
    throw input_error({.field = "--set",
                       .wanted = "the rendered set, to make " + log.string() + " of it",
                       .found = "none"});
  const LogContents contents = read_log(log);
  try {
    RenderedSet set = load_rendered_set(contents.set_folder);
    if (set.set_hash == contents.set_hash) return set;
  } catch (const InputError&) {
    // moved or gone: it must be given
  }
  throw input_error(
      {.field = "--set",
       .wanted = "the rendered set of " + log.string() + ", which is no more where the log says",
       .found = "none"});
}

}  // namespace seamline::study::online
