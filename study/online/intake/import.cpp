#include "study/online/intake/import.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>

#include "study/log/log.h"
#include "study/online/intake/intake.h"
#include "study/online/intake/result_values.h"
#include "study/online/intake/zip_file.h"
#include "study/online/messages/message_reader.h"
#include "support/files/atomic_file.h"
#include "support/running/interrupt.h"
#include "support/text/counted.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

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
  std::vector<std::string> cut_files, foreign;
};

InputError of_another(const char* field, const std::string& wanted, const std::string& found) {
  return input_error({.field = field,
                      .wanted = wanted + ", of the log's study and set",
                      .found = "\"" + printable(found, 80) + "\""});
}

Message message_of(const ResultValue& value, const RenderedSet& set) {
  if (value.kind != ResultValue::Kind::whole)
    throw input_error({.wanted = "a message", .found = "\"" + printable(value.text, 60) + "\""});
  Message message = read_message(value.text);
  if (message.study_hash != set.manifest.study_hash)
    throw of_another("study_hash", set.manifest.study_hash, message.study_hash);
  if (message.set_hash != set.set_hash) throw of_another("set_hash", set.set_hash, message.set_hash);
  return message;
}

/// Foreign things that lie side by side, as one sentence.
struct ForeignStretch {
  std::string place, fault;
  int values = 0, last_line = 0;

  [[nodiscard]] std::string sentence() const {
    if (values == 1) return fmt::format("{}: {}", place, fault);
    return fmt::format("{} to line {}, {} values, the first: {}", place, last_line, values, fault);
  }
};

/// `name` is what the bytes are called in sentences.
void read_messages(std::string_view bytes, const std::string& name, const RenderedSet& set, Foreign foreign,
                   FiledMessages& all) {
  ResultValues values(bytes);
  ForeignStretch stretch;
  const auto end_stretch = [&] {
    if (stretch.values > 0) all.foreign.push_back(stretch.sentence());
    stretch = {};
  };
  for (ResultValue value; values.next(value);) {
    stop_if_interrupted();
    if (value.kind == ResultValue::Kind::cut) {  // the browser, or the network, stopped in the middle
      all.cut_files.push_back(name);
      break;
    }
    const std::string place = value.value_in_line == 1
                                  ? fmt::format("{}:{}", name, value.line)
                                  : fmt::format("{}:{} (value {})", name, value.line, value.value_in_line);
    try {
      Message message = message_of(value, set);
      end_stretch();
      ++all.count;
      std::vector<FiledMessage>& theirs = all.of_participant[message.participant];
      theirs.push_back({.message = std::move(message), .place = place});
    } catch (const InputError& error) {
      if (foreign == Foreign::ends_the_import)
        throw input_error(
            {.file = place,
             .field = fmt::format("{} (nothing was imported; {} leaves out what is no message of this "
                                  "study and set)",
                                  error.what(), request_name("skip_foreign"))});
      if (stretch.values++ == 0) stretch.place = place, stretch.fault = error.what();
      stretch.last_line = value.last_line;
    }
  }
  end_stretch();
}

/// In JATOS's archives each result is a file `data.txt`; a ZIP of downloads has files of lines. Other files,
/// as participants may have uploaded them, are no results.
bool is_results(const std::string& name) {
  return (name.ends_with(".txt") || name.ends_with(".jsonl")) && name.find("/files/") == std::string::npos;
}

void read_file_of_messages(const fs::path& file, const RenderedSet& set, Foreign foreign,
                           FiledMessages& all) {
  const std::string bytes = read_file(file);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw input_error(
        {.file = file.string(), .wanted = "text in UTF-8", .found = "UTF-16 (save it as UTF-8)"});
  if (!is_zip(bytes)) return read_messages(bytes, file.string(), set, foreign, all);
  const std::vector<ZippedFile> results = unzip(bytes, file, is_results);
  if (results.empty())
    throw input_error({.file = file.string(),
                       .wanted = "an archive of JATOS's results, with data.txt in it",
                       .found = "one without"});
  for (const ZippedFile& result : results)
    read_messages(result.bytes, file.string() + "/" + printable(result.name), set, foreign, all);
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
  text += fmt::format("; {} new, {} known", counted(person.stored, "message"), person.known);
  if (!person.gaps.empty()) text += "; missing messages: " + ranges(person.gaps);
  text += "\n";
  for (const std::string& sentence : person.refused) text += fmt::format("  left out: {}\n", sentence);
  return text;
}

}  // namespace

ImportReport import_messages(const RenderedSet& set, const fs::path& log, const std::vector<fs::path>& files,
                             Foreign foreign) {
  FiledMessages all;
  for (const fs::path& file : files) read_file_of_messages(file, set, foreign, all);
  ImportReport report{.files = static_cast<int>(files.size()),
                      .messages = all.count,
                      .cut_files = all.cut_files,
                      .foreign = all.foreign};
  if (all.count == 0)
    throw input_error({.file = files.empty() ? "seamline import" : files.front().string(),
                       .wanted = "lines of messages",
                       .found = all.foreign.empty() ? "none" : "none; " + all.foreign.front()});
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
      "{}: {} of {} in {}: {} new, {} known, {} left out; {} complete, {} incomplete, {} declined\n",
      log.string(), counted(report.messages, "message"), counted(report.people.size(), "participant"),
      counted(report.files, "file"), stored, known, refused, counted(complete, "participant"),
      report.people.size() - static_cast<std::size_t>(complete), report.declined);
  for (const std::string& file : report.cut_files)
    text += fmt::format("{}: the last message ends in the middle and was left out\n", file);
  for (const std::string& sentence : report.foreign) text += fmt::format("left out: {}\n", sentence);
  for (const ImportedPerson& person : report.people) text += person_text(person);
  return text;
}

RenderedSet set_for_log(const fs::path& log, const fs::path& given) {
  if (!given.empty()) return load_rendered_set(given);
  if (!fs::exists(log))
    throw input_error({.field = request_name("set"),
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
      {.field = request_name("set"),
       .wanted = "the rendered set of " + log.string() + ", which is no more where the log says",
       .found = "none"});
}

}  // namespace seamline::study::online
