#include "commands/study/study_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands/options/output_files.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/study_file/people/study_file_language.h"
#include "stimuli/study_file/study_file.h"
#include "study/log/participant_code.h"
#include "study/running/simulation.h"
#include "study/trials/rendered_set.h"
#include "support/text/counted.h"
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
  fmt::print("{}: {} run ({}), {} complete before\n", options.log,
             counted(summary.participants_run, "simulated participant"),
             counted(summary.answers_added, "answer"), counted(summary.participants_complete, "was", "were"));
  if (summary.tracks_on_edge > 0)
    fmt::print("alarm: in {} the threshold leans on the edge of the grid (seamline log tracks {})\n",
               counted(summary.tracks_on_edge, "track"), options.log);
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
  fmt::print(stderr, "{}: {} to translate{}{}\n", texts.tag, counted(missing.size(), "text"),
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

}  // namespace

void refuse_without_window(const ParticipantRequest&) {
  throw input_error({.field = "--participant",
                     .wanted = "a seamline that was built with its window application",
                     .found = "one without (simulated people need no window: --observer KIND)"});
}

void add_study_command(CLI::App& app, const ParticipantRunner& run_participant) {
  const auto options = std::make_shared<StudyOptions>();
  CLI::App* command = app.add_subcommand("study", "run a session: a person in a window, or simulated people");
  command
      ->add_option("set", options->set_folder,
                   "folder of the rendered set (for --print-texts also a study file)")
      ->required();
  command->add_option("--log", options->log, "SQLite log of answers; made when it is missing");
  command->add_option("--participant", options->participant, "a person's code, never a name");
  command->add_option("--language", options->language,
                      "tag of the language that the person reads, of [[language]] in the study");
  command->add_flag("--print-texts", options->print_texts,
                    "print every text of the study, to translate into --language, and say what is missing");
  command->add_flag("--pilot", options->pilot, "mark the participant as a trial run");
  command->add_flag("--allow-scaling", options->allow_scaling,
                    "show pictures that do not fit the screen smaller; the log says so with every answer");
  command->add_option("--frame-times", options->frame_times, "CSV for the time of every frame");
  command->add_flag("--windowed", options->windowed, "a window instead of the whole screen, to try things");
  command->add_flag("--display-check", options->display_check,
                    "measure the screen again, though it is known on this machine");
  command->add_option("--trace", options->trace)->group("");  // for tests that drive the window
  command->add_option("--observer", options->observer,
                      "simulated people: threshold, image (looks at the pictures), guesser or perfect");
  add_number(*command, "--count", options->count, {1, 1000000}, "how many simulated people")
      ->capture_default_str();
  add_number(*command, "--seed", options->seed, any_seed, "of the simulated people")->capture_default_str();
  add_number(*command, "--gain", options->gain, {1e-9, 1e9},
             "of the observer image, as `predict` prints it (else the study's observer.image_gain)");
  command->callback([options, run_participant, command] {
    require_outputs(*command, {"--frame-times"}, {"--log"});
    study(*options, run_participant);
  });
}

}  // namespace seamline::study
