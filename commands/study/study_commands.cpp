#include "commands/study/study_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "stimuli/set/manifest_pictures.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "stimuli/study_file/study_file.h"
#include "study/log/log_admin.h"
#include "study/log/log_writer.h"
#include "study/log/online/invitation_codes.h"
#include "study/log/online/log_backup.h"
#include "study/log/online/recruits.h"
#include "study/log/recovery/log_recovery.h"
#include "study/log/recovery/log_recovery_text.h"
#include "study/log/recovery/log_upgrade.h"
#include "study/running/quest_plus_results.h"
#include "study/running/simulation.h"
#include "study/trials/rendered_set.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/suggest.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

struct StudyOptions {
  std::string set_folder, log, participant, observer;
  std::string frame_times, trace, language;
  bool print_texts = false;
  bool pilot = false, allow_scaling = false, windowed = false, display_check = false;
  int count = 20;
  std::uint64_t seed = 1;
  double gain = 0;  // 0: the study's
};

struct LogOptions {
  std::string log, exclude, forget, codes, recover, upgrade, set, identifiers, backup;
  bool status = false, tracks = false, forget_identifiers = false;
};

ObserverKind parse_observer(const std::string& text) {
  if (const std::optional<ObserverKind> kind = observer_kind_from_word(text)) return *kind;
  std::vector<std::string> known;
  known.reserve(every_observer_kind.size());
  for (const ObserverKind kind : every_observer_kind) known.emplace_back(word(kind));
  const std::string nearest = nearest_word(text, known);
  throw input_error({.field = "--observer",
                     .wanted = fmt::format("threshold, image, guesser or perfect{}",
                                           nearest.empty() ? "" : " (did you mean " + nearest + "?)"),
                     .found = "\"" + text + "\""});
}

void simulate(const StudyOptions& options) {
  for (const auto& [given, flag] :
       {std::pair(options.pilot, "--pilot"), std::pair(options.allow_scaling, "--allow-scaling"),
        std::pair(!options.frame_times.empty(), "--frame-times"), std::pair(options.windowed, "--windowed"),
        std::pair(options.display_check, "--display-check")})
    if (given)
      throw input_error({.field = flag, .wanted = "a person (--participant)", .found = "--observer"});
  std::optional<double> gain;
  if (options.gain > 0) gain = options.gain;
  const RenderedSet set = load_rendered_set(options.set_folder);
  check_manifest_pictures(set.folder, set.manifest);
  const SimulationSummary summary = run_simulated_study({.set_folder = options.set_folder,
                                                         .log = options.log,
                                                         .observer = parse_observer(options.observer),
                                                         .image_gain = gain,
                                                         .count = options.count,
                                                         .seed = options.seed});
  fmt::print("{}: {} simulated participants run ({} answers), {} were complete before\n", options.log,
             summary.participants_run, summary.answers_added, summary.participants_complete);
  if (summary.tracks_on_edge > 0)
    fmt::print("alarm: in {} tracks the threshold leans on the edge of the grid (seamline log {} --tracks)\n",
               summary.tracks_on_edge, options.log);
}

/// Of a set or a study file, to the standard output; what is missing is counted beside it.
void print_texts(const StudyOptions& options) {
  std::error_code error;
  const fs::path given = options.set_folder;
  const StudyDefinition read = fs::is_directory(given, error) ? load_rendered_set(given).study
                                                              : read_study(given, AssetCheck::not_needed);
  StudyTexts texts{.tag = options.language.empty() ? read.session.language : options.language, .consent = {}};
  if (read.languages)
    for (const LanguageDefinition& language : read.languages->languages)
      if (language.tag == texts.tag) texts = read_study_texts(read, language);
  fmt::print("{}", texts_to_translate(read, texts));
  const std::vector<std::string> missing = missing_texts(read, texts);
  fmt::print(stderr, "{}: {} texts to translate{}{}\n", texts.tag, missing.size(),
             missing.empty() ? "" : ": ", fmt::join(missing, ", "));
}

void study(const StudyOptions& options, const ParticipantRunner& run_participant) {
  if (options.print_texts) return print_texts(options);
  if (options.log.empty())
    throw input_error({.field = "seamline study", .wanted = "--log LOG", .found = "none"});
  if (options.participant.empty() == options.observer.empty())
    throw input_error({.field = "seamline study",
                       .wanted = "either --participant CODE or --observer KIND",
                       .found = options.observer.empty() ? "neither" : "both"});
  if (!options.observer.empty()) return simulate(options);
  check_participant_code(options.participant);
  if (load_rendered_set(options.set_folder).study.recruitment)
    fmt::print(stderr,
               "[recruitment] is for people in browsers: in the window nobody is matched, screened or "
               "sent back\n");
  run_participant({.set_folder = options.set_folder,
                   .log = options.log,
                   .code = options.participant,
                   .language = options.language,
                   .pilot = options.pilot,
                   .allow_scaling = options.allow_scaling,
                   .frame_times = options.frame_times,
                   .windowed = options.windowed,
                   .display_check = options.display_check,
                   .trace = options.trace});
}

/// From the log, and from the file that says whose invitation was whose. Somebody who is in that file alone
/// was forgotten before, without it.
void forget_person(const LogOptions& options) {
  if (options.codes.empty()) {
    const bool in_browser = forget_participant(options.log, options.forget);
    (void)forget_recruit(options.log, options.forget);
    if (in_browser)
      fmt::print("{}: forgotten in {}. {}\n", options.forget, options.log,
                 "If a server kept codes (seamline serve --codes FILE), FILE still has their line: the same "
                 "command with --codes FILE takes it out.");
    return;
  }
  const bool is_in_log = has_participant(options.log, options.forget);
  const InvitationCodes codes = read_invitation_codes(options.codes);
  const bool is_in_codes = std::any_of(codes.begin(), codes.end(),
                                       [&](const auto& line) { return line.second == options.forget; });
  if (is_in_log || !is_in_codes) forget_participant(options.log, options.forget);
  (void)forget_recruit(options.log, options.forget);
  fmt::print("{}: {} in {}, {} lines taken out of {}\n", options.forget,
             is_in_log ? "forgotten" : "not there any more", options.log,
             forget_invitation_of(options.codes, options.forget), options.codes);
}

void administer(const LogOptions& options) {
  const bool does_something = options.status || options.tracks || !options.exclude.empty() ||
                              !options.forget.empty() || !options.recover.empty() ||
                              !options.upgrade.empty() || !options.identifiers.empty() ||
                              !options.backup.empty() || options.forget_identifiers;
  if (!does_something)
    throw input_error({.field = "seamline log",
                       .wanted =
                           "--status, --tracks, --exclude CODE, --forget CODE, --recover OUT, --upgrade NEW, "
                           "--backup NEW, --identifiers FILE or --forget-identifiers",
                       .found = "none"});
  if (!options.recover.empty()) {
    const LogRecovery recovery = recover_log(options.log, options.recover, options.set);
    fmt::print("{}", recovery_text(recovery, options.log, options.recover));
    return;
  }
  if (!options.upgrade.empty()) {
    fmt::print("{}", upgrade_text(upgrade_log(options.log, options.upgrade), options.log, options.upgrade));
    return;
  }
  if (!options.backup.empty()) {
    back_up_log(options.log, options.backup);
    fmt::print("{}: a copy of {} as it was at one moment\n", options.backup, options.log);
  }
  if (!options.identifiers.empty())
    fmt::print("{}: {} people\n", options.identifiers, write_recruits(options.log, options.identifiers));
  if (options.forget_identifiers)
    fmt::print("{}: the identifiers of {} people are deleted; their answers stay\n", options.log,
               forget_identifiers(options.log));
  if (!options.exclude.empty()) exclude_participant(options.log, options.exclude);
  if (!options.forget.empty()) forget_person(options);
  if (options.status) fmt::print("{}", status_text(read_log(options.log)));
  if (options.tracks) fmt::print("{}", tracks_text(quest_plus_estimates(read_log(options.log))));
}

}  // namespace

void refuse_without_window(const ParticipantRequest&) {
  throw input_error({.field = "--participant",
                     .wanted = "a seamline that was built with its window application",
                     .found = "one without (simulated people need no window: --observer KIND)"});
}

void add_study_commands(CLI::App& app, const ParticipantRunner& run_participant) {
  const auto study_options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand("study", "run a session: a person in a window, or simulated people");
  command
      ->add_option("set", study_options->set_folder,
                   "folder of the rendered set (for --print-texts also a study file)")
      ->required();
  command->add_option("--log", study_options->log, "SQLite log of answers; made when it is missing");
  command->add_option("--participant", study_options->participant, "a person's code, never a name");
  command->add_option("--language", study_options->language,
                      "tag of the language that the person reads, of [[language]] in the study");
  command->add_flag("--print-texts", study_options->print_texts,
                    "print every text of the study, to translate into --language, and say what is missing");
  command->add_flag("--pilot", study_options->pilot, "mark the participant as a trial run");
  command->add_flag("--allow-scaling", study_options->allow_scaling,
                    "show pictures that do not fit the screen smaller; the log says so with every answer");
  command->add_option("--frame-times", study_options->frame_times, "CSV for the time of every frame");
  command->add_flag("--windowed", study_options->windowed,
                    "a window instead of the whole screen, to try things");
  command->add_flag("--display-check", study_options->display_check,
                    "measure the screen again, though it is known on this machine");
  command->add_option("--trace", study_options->trace)->group("");  // for tests that drive the window
  command->add_option("--observer", study_options->observer,
                      "simulated people: threshold, image (looks at the pictures), guesser or perfect");
  add_number(*command, "--count", study_options->count, {1, 1000000}, "how many simulated people")
      ->capture_default_str();
  add_number(*command, "--seed", study_options->seed, any_seed, "of the simulated people")
      ->capture_default_str();
  add_number(*command, "--gain", study_options->gain, {1e-9, 1e9},
             "of the observer image, as `predict` prints it (else the study's observer.image_gain)");
  command->callback([study_options, run_participant] { study(*study_options, run_participant); });

  const auto log_options = std::make_shared<LogOptions>();
  CLI::App* log = app.add_subcommand("log", "look after a log: who did what, exclude, forget, repair");
  log->add_option("log", log_options->log, "the log")->required();
  CLI::Option* status = log->add_flag("--status", log_options->status, "print who has done what");
  CLI::Option* tracks =
      log->add_flag("--tracks", log_options->tracks, "print the thresholds of an adaptive study (QUEST+)");
  CLI::Option* exclude =
      log->add_option("--exclude", log_options->exclude, "leave a participant's answers out of the analysis");
  CLI::Option* forget =
      log->add_option("--forget", log_options->forget, "delete every trace of a participant");
  CLI::Option* backup = log->add_option("--backup", log_options->backup,
                                        "copy the log as it is now, also while a server writes to it");
  CLI::Option* identifiers =
      log->add_option("--identifiers", log_options->identifiers,
                      "write who came from a panel as which participant, with which end, as CSV");
  CLI::Option* forget_all = log->add_flag("--forget-identifiers", log_options->forget_identifiers,
                                          "delete all identifiers of a panel, and keep the answers");
  log->add_option("--codes", log_options->codes,
                  "for --forget: the file in which `serve --codes` kept whose invitation was whose")
      ->needs(forget);
  CLI::Option* recover =
      log->add_option("--recover", log_options->recover,
                      "save what can be read of a damaged log into a new one, and say what is lost");
  CLI::Option* upgrade =
      log->add_option("--upgrade", log_options->upgrade,
                      "make a log of today's schema of one that an older seamline began, with every answer")
          ->excludes(recover);
  for (CLI::Option* alone : {recover, upgrade})  // they make another log, and touch this one in no way
    for (CLI::Option* other : {status, tracks, exclude, forget, backup, identifiers, forget_all})
      alone->excludes(other);
  log->add_option("--set", log_options->set, "for --recover: the set, where the log's own study is lost")
      ->needs(recover);
  log->callback([log_options] { administer(*log_options); });
}

}  // namespace seamline::study
