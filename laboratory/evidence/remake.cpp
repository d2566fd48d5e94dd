#include "laboratory/evidence/remake.h"

#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <thread>

#include "laboratory/evidence/evidence_figure.h"
#include "laboratory/evidence/evidence_table.h"
#include "laboratory/evidence/marked_page.h"
#include "laboratory/evidence/remade_page.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/running/child_process.h"
#include "support/running/interrupt.h"
#include "support/running/machine.h"
#include "support/text/error.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr int status_not_here = 77;  ///< by which scripts say that something they need is not installed

fs::path this_program() {
  return fs::read_symlink("/proc/self/exe");
}

/// The source of this build: that of ready studies, which an installed program has elsewhere.
fs::path source_folder() {
  return builtin_study("quick").parent_path().parent_path();
}

/// A step's command, taken apart.
struct StepCommand {
  std::vector<std::string> words, variables;
};

bool is_variable(const std::string& word) {
  const std::size_t equals = word.find('=');
  return equals != std::string::npos && word.find('-') > equals && word.find('/') > equals;
}

std::string meant_by(const std::string& word, bool is_first) {
  const fs::path build = this_program().parent_path();
  if (word == "SEAMLINE" || (is_first && word == "seamline")) return this_program();
  if (word == "BUILD") return build;
  if (word == "SCENES") return build / "scenes" / "builtin";
  if (is_first && word.starts_with("tests/")) return build / word;
  if (is_first && word.starts_with("benchmarks/")) return source_folder() / word;
  if (word.starts_with("stimuli/") && word.ends_with(".toml"))
    return builtin_study(fs::path(word).stem().string());
  return word;
}

StepCommand command_of(const EvidenceStep& step) {
  StepCommand command;
  std::istringstream words(step.command);
  for (std::string word; words >> word;)
    if (command.words.empty() && is_variable(word))
      command.variables.push_back(word);
    else
      command.words.push_back(meant_by(word, command.words.empty()));
  return command;
}

bool is_optional(const EvidenceStep& step) {
  return step.command.starts_with("benchmarks/cycles/");
}

const std::vector<EvidenceStep>& steps_of(const EvidencePage& page, bool small) {
  return small ? page.small_steps : page.steps;
}

/// Processor seconds of all children that have ended.
double children_processor_s() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) { return time.tv_sec + 1e-6 * time.tv_usec; };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

std::string today() {
  const std::chrono::year_month_day day{
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now())};
  return fmt::format("{}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

/// Notes in made.csv that the step was run now.
void note_made(const fs::path& folder, const std::string& step, double processor_s) {
  const fs::path file = folder / "made.csv";
  std::vector<MadeStep> steps = read_made(file);
  std::erase_if(steps, [&](const MadeStep& made) { return made.step == step; });
  steps.push_back({.step = step,
                   .date = today(),
                   .seamline = program_version(),
                   .processor = processor_name(),
                   .threads = std::to_string(std::thread::hardware_concurrency()),
                   .processor_s = processor_s});
  write_file_atomically(file, made_csv(steps));
}

/// What the step printed; run now unless NAME.txt begins with the line that this run would write.
StepRecord step_record(const EvidencePage& page, const EvidenceStep& step, const fs::path& folder,
                       const RemakeOptions& options) {
  const fs::path file = folder / (step.name + ".txt");
  const std::string first_line = made_by() + ": " + step.command + "\n";
  std::error_code error;
  if (fs::exists(file, error))
    if (const std::string before = read_file(file); before.starts_with(first_line)) {
      options.said(fmt::format("{}: {}, made before", page.name, step.name));
      return {step, before.substr(first_line.size())};
    }
  const StepCommand command = command_of(step);
  if (access(command.words.front().c_str(), X_OK) != 0 && is_optional(step))
    return {step, "left out: no source here\n"};
  options.said(fmt::format("{}: {}", page.name, step.command));
  ChildProcess child{.command = command.words, .environment = command.variables, .folder = folder};
  child.environment.push_back("SEAMLINE_EVIDENCE_FOLDER=" + folder.string());
  const double before_s = children_processor_s();
  const std::optional<ChildResult> run = run_child(child);
  stop_if_interrupted();
  if (run && run->status == status_not_here) return {step, "left out: " + run->output};
  if (!run || run->status != 0) {
    const fs::path failed = folder / (step.name + ".failed.txt");
    write_file_atomically(failed, first_line + (run ? run->output : "it could not be started\n"));
    throw input_error({.file = failed.string(),
                       .wanted = "a step that ends well (" + step.command + ")",
                       .found = run ? fmt::format("exit status {}", run->status) : "no such program"});
  }
  write_file_atomically(file, first_line + run->output);
  note_made(folder, step.name, children_processor_s() - before_s);
  return {step, run->output};
}

/// Tables of which not all sources are there (a small form has made some) are left out.
void write_computed_tables(const EvidencePage& page, const fs::path& folder) {
  for (const EvidenceTable& table : page.tables)
    if (std::all_of(table.from.begin(), table.from.end(), [&](const TableSource& source) {
          std::error_code error;
          return fs::exists(folder / source.file, error);
        }))
      write_file_atomically(folder / table.file, csv_of(summarised(table, folder)));
}

void write_printed_tables(const EvidencePage& page, const std::vector<StepRecord>& records,
                          const fs::path& folder) {
  for (const PrintedTable& table : page.printed)
    for (const StepRecord& record : records)
      if (record.step.name == table.step)
        if (const TextTable made = printed_table(table, record.printed); !made.rows.empty())
          write_file_atomically(folder / table.file, csv_of(made));
}

/// Brings what a page shows, and what that is computed from, into the folder beside the page.
void bring_beside_page(const EvidencePage& page, const fs::path& from, const fs::path& to) {
  std::vector<std::string> files = shown_files(page);
  files.emplace_back("made.csv");
  for (const EvidenceTable& table : page.tables)
    for (const TableSource& source : table.from) files.push_back(source.file);
  std::error_code error;
  for (const std::string& file : files) {
    if (!fs::exists(from / file, error)) continue;
    prepare_output_folder((to / file).parent_path());
    write_file_atomically(to / file, read_file(from / file));
  }
}

}  // namespace

std::string made_by() {
  return fmt::format("seamline {} on {}, {} threads", program_version(), processor_name(),
                     std::thread::hardware_concurrency());
}

std::string missing_of(const EvidencePage& page, bool small) {
  for (const EvidenceStep& step : steps_of(page, small)) {
    const std::string program = command_of(step).words.front();
    if (!is_optional(step) && access(program.c_str(), X_OK) != 0)
      return program + " is missing; it needs " + page.needs;
  }
  return "";
}

fs::path remake_evidence(const EvidencePage& page, const RemakeOptions& options) {
  if (const std::string missing = missing_of(page, options.small); !missing.empty())
    throw input_error({.field = "evidence " + page.name, .wanted = page.needs, .found = missing});
  const fs::path folder = fs::absolute(options.out) / page.name;
  prepare_output_folder(folder);
  std::vector<StepRecord> records;
  for (const EvidenceStep& step : steps_of(page, options.small))
    records.push_back(step_record(page, step, folder, options));
  std::error_code error;
  write_printed_tables(page, records, folder);
  write_computed_tables(page, folder);
  for (const EvidenceFigure& figure : page.figures)
    if (fs::exists(folder / figure.table, error)) draw_evidence(folder, figure);
  if (!options.pages.empty()) {
    bring_beside_page(page, folder, options.pages / page.name);
    return renew_evidence(page, options.pages);
  }
  const fs::path file = options.out / page.name / (page.name + ".md");
  write_file_atomically(file, remade_page(page, options.small, records, folder));
  return file;
}

fs::path renew_evidence(const EvidencePage& page, const fs::path& pages) {
  const fs::path file = pages / (page.name + ".md");
  const std::string text = read_file(file);
  write_computed_tables(page, pages / page.name);
  write_file_atomically(file, with_marked_parts(text, page.name, pages));
  return file;
}

}  // namespace seamline::laboratory
