#include "sets/cluster/set_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "sets/pages/page_frame.h"
#include "sets/set_manifest.h"
#include "sets/sharing/work_list.h"
#include "stimuli/set/manifest.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/html.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

/// A record's inputs, without reading more of it than it takes: it begins with them.
bool is_record_of(const fs::path& path, const std::string& inputs) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  try {
    return read_file(path).find("\"inputs\": \"" + inputs + "\"") != std::string::npos;
  } catch (const InputError&) {
    return false;
  }
}

enum class PieceState { working, failed, died };

PieceState state_of(const FoundMark& mark) {
  if (!mark.complaint.empty()) return PieceState::failed;
  if (mark.life == FoundMark::Life::working) return PieceState::working;
  const bool silent = mark.life == FoundMark::Life::ended || mark.age_s > dead_after_s;
  return silent ? PieceState::died : PieceState::working;
}

std::string state_text(const FoundMark& mark) {
  constexpr double worth_saying_s = 30;  // a mark is written again every ten seconds
  const std::string far = mark.of > 0 ? fmt::format("{} of {} done", mark.done, mark.of) : "begun";
  switch (state_of(mark)) {
    case PieceState::working:
      if (mark.life == FoundMark::Life::working || mark.age_s < worth_saying_s) return far;
      return fmt::format("{}, silent for {:.0f} s", far, mark.age_s);
    case PieceState::failed:
      return "failed: " + printable(mark.complaint);
    case PieceState::died:
      return mark.life == FoundMark::Life::ended
                 ? fmt::format("died: killed, or its machine failed; {}", far)
                 : fmt::format("died: silent for {:.0f} s; {}", mark.age_s, far);
  }
  return {};
}

int count(const SetStatus& status, PieceState state) {
  return static_cast<int>(std::count_if(status.marks.begin(), status.marks.end(),
                                        [&](const FoundMark& mark) { return state_of(mark) == state; }));
}

/// "2 at work, 0 failed, 1 died"
std::string counts_text(const SetStatus& status) {
  return fmt::format("{} at work, {} failed, {} died", count(status, PieceState::working),
                     count(status, PieceState::failed), count(status, PieceState::died));
}

/// What a person should know or do beside the numbers; empty when work goes on.
std::string advice(const SetStatus& status) {
  if (!status.by_job) return "rendered without a job, by one process or by shards: they leave no marks";
  if (status.joined || count(status, PieceState::working) > 0) return {};
  std::error_code error;
  const fs::path folder = status.job.empty() ? fs::path("its job") : fs::path(status.job);
  const std::string begin =
      printable((folder / (fs::exists(folder / "run", error) ? "run" : "submit")).string());
  if (status.done() == status.of())
    return fmt::format("every stimulus is there, and no manifest yet: {} writes it",
                       printable((folder / "task").string()) + " join");
  const bool begun = !status.marks.empty() || std::any_of(status.truths.begin(), status.truths.end(),
                                                          [](const TruthStatus& t) { return t.reference; });
  if (!begun)
    return fmt::format("no piece has begun: not submitted ({} does it), or waiting in a queue", begin);
  return fmt::format("nothing is at work: what is left waits in a queue, or {} begins it again", begin);
}

double percent(int part, int whole) {
  return whole > 0 ? 100.0 * part / whole : 0.0;
}

}  // namespace

int SetStatus::done() const {
  return std::accumulate(truths.begin(), truths.end(), 0,
                         [](int sum, const auto& t) { return sum + t.done; });
}

int SetStatus::of() const {
  return std::accumulate(truths.begin(), truths.end(), 0, [](int sum, const auto& t) { return sum + t.of; });
}

namespace {

/// Of a set that no job makes: what its manifest lists.
SetStatus status_of_manifest(const fs::path& set_folder) {
  const Manifest manifest = read_manifest(set_folder);
  SetStatus status{
      .study = manifest.study_name, .job = {}, .truths = {}, .marks = {}, .by_job = false, .joined = true};
  for (const ManifestReference& reference : manifest.references) {
    const auto of_truth = std::count_if(
        manifest.stimuli.begin(), manifest.stimuli.end(),
        [&](const ManifestStimulus& stimulus) { return truth_of(stimulus.stimulus) == reference.truth; });
    const int count = static_cast<int>(of_truth);
    status.truths.push_back({.name = reference.truth, .reference = true, .done = count, .of = count});
  }
  return status;
}

bool lists_all(const fs::path& set_folder, const WorkList& list) {
  std::error_code error;
  if (!fs::is_regular_file(set_folder / "manifest.json", error)) return false;
  std::set<std::string> listed;
  for (const ManifestStimulus& stimulus : read_manifest(set_folder).stimuli) listed.insert(stimulus.id);
  return std::all_of(list.stimuli.begin(), list.stimuli.end(),
                     [&](const WorkList::Stimulus& stimulus) { return listed.contains(stimulus.id); });
}

}  // namespace

SetStatus read_status(const fs::path& set_folder) {
  const std::optional<WorkList> list = read_work_list(set_folder);
  std::error_code error;
  if (!list && fs::is_regular_file(set_folder / "manifest.json", error))
    return status_of_manifest(set_folder);
  if (!list)
    throw input_error({.file = set_folder.string(),
                       .wanted = "a set that a job of `seamline render` makes, or one that is rendered",
                       .found = !fs::exists(set_folder, error) ? "no such folder"
                                : is_begun_set(set_folder)
                                    ? "one that a render without a job has begun, which leaves no marks"
                                    : "something else"});
  SetStatus status{.study = list->study, .job = list->job, .truths = {}, .marks = {}};
  const fs::path records = set_folder / "records";
  std::map<std::string, std::size_t> places;
  for (const auto& [name, inputs] : list->references) {
    places.emplace(name, status.truths.size());
    status.truths.push_back(
        {.name = name, .reference = is_record_of(records / ("reference-" + name + ".json"), inputs)});
  }
  for (const auto& [id, inputs, truth] : list->stimuli) {
    const auto place = places.find(truth);
    if (place == places.end()) continue;
    TruthStatus& of_truth = status.truths[place->second];
    ++of_truth.of;
    if (is_record_of(records / (id + ".json"), inputs)) ++of_truth.done;
  }
  status.marks = read_marks(set_folder);
  status.joined = status.done() == status.of() && lists_all(set_folder, *list);
  return status;
}

std::string status_text(const fs::path& set_folder, const SetStatus& status) {
  const int done = status.done(), of = status.of();
  std::string out =
      fmt::format("{}: study {}, {} of {} stimuli done ({:.0f} %), {} left; {}{}\n",
                  printable(set_folder.string()), printable(status.study), done, of, percent(done, of),
                  of - done, counts_text(status), status.joined ? "; the manifest lists all" : "");
  std::size_t longest = 0;
  for (const TruthStatus& truth : status.truths) longest = std::max(longest, truth.name.size());
  for (const TruthStatus& truth : status.truths)
    out += fmt::format("  {:<{}}  {:>6} of {:>6}{}\n", printable(truth.name), longest, truth.done, truth.of,
                       truth.reference ? "" : "  (its reference is not done)");
  for (const FoundMark& mark : status.marks)
    out += fmt::format("  {} on {}: {}\n", printable(mark.name), printable(mark.host), state_text(mark));
  if (const std::string said = advice(status); !said.empty()) out += "  " + said + "\n";
  return out;
}

void write_status_page(const fs::path& file, const fs::path& set_folder, const SetStatus& status) {
  const int done = status.done(), of = status.of();
  const std::string said = advice(status);
  std::string body = fmt::format(
      "<p><strong>{} of {}</strong> stimuli are done ({:.0f} %); pieces: {}.{} {} This page is as old as "
      "its file: <code>seamline job status {} --html FILE</code> writes it "
      "anew.</p>\n<table><thead><tr><th>truth</th><th>reference</th><th>stimuli</th><th></th></tr></thead><tbody>",
      done, of, percent(done, of), counts_text(status), status.joined ? " The manifest lists all." : "",
      html_escape(said.empty() ? said : "Note: " + said + "."), html_escape(set_folder.string()));
  for (const TruthStatus& truth : status.truths)
    body += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{} of {}</td><td><svg width=\"240\" height=\"14\" role=\"img\" "
        "aria-label=\"{:.0f} percent\"><rect width=\"240\" height=\"14\" fill=\"#ddd\"/><rect "
        "width=\"{:.1f}\" height=\"14\" fill=\"#2a7\"/></svg></td></tr>\n",
        html_escape(truth.name), truth.reference ? "done" : "&ndash;", truth.done, truth.of,
        percent(truth.done, truth.of), 2.4 * percent(truth.done, truth.of));
  body += "</tbody></table>\n";
  if (!status.marks.empty()) {
    body += "<table><thead><tr><th>piece</th><th>machine</th><th>how far</th></tr></thead><tbody>";
    for (const FoundMark& mark : status.marks)
      body += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", html_escape(mark.name),
                          html_escape(mark.host), html_escape(state_text(mark)));
    body += "</tbody></table>\n";
  }
  write_file_atomically(file, html_page("Rendering " + html_escape(status.study), body));
}

}  // namespace seamline::renderer
