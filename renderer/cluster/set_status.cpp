#include "renderer/cluster/set_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "renderer/set/pages/page_frame.h"
#include "renderer/set/sharing/set_running.h"
#include "renderer/set/sharing/work_list.h"
#include "stimuli/set/manifest.h"
#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/html.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

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

double age_s(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  if (error) return 0;
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count();
}

std::vector<ElementStatus> read_marks(const fs::path& folder) {
  std::vector<ElementStatus> out;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".json") continue;
    Json json;
    try {
      json = Json::parse(read_file(entry.path()), nullptr, false);
    } catch (const InputError&) {
      continue;  // removed meanwhile
    }
    if (!json.is_object()) continue;
    ElementStatus element{.name = entry.path().stem().string(),
                          .host = printable(json.value("host", std::string())),
                          .complaint = printable(json.value("failed", std::string())),
                          .state = ElementStatus::State::running,
                          .done = json.value("done", 0),
                          .of = json.value("of", 0),
                          .mark_age_s = age_s(entry.path())};
    if (!element.complaint.empty())
      element.state = ElementStatus::State::failed;
    else if (element.mark_age_s > dead_after_s)
      element.state = ElementStatus::State::died;
    out.push_back(std::move(element));
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return out;
}

std::string state_text(const ElementStatus& element) {
  switch (element.state) {
    case ElementStatus::State::running:
      return fmt::format("{} of {} done", element.done, element.of);
    case ElementStatus::State::failed:
      return "failed: " + element.complaint;
    case ElementStatus::State::died:
      return fmt::format("died: silent for {:.0f} s, after {} of {}", element.mark_age_s, element.done,
                         element.of);
  }
  return {};
}

int count(const SetStatus& status, bool running) {
  return static_cast<int>(std::count_if(status.elements.begin(), status.elements.end(), [&](const auto& e) {
    return (e.state == ElementStatus::State::running) == running;
  }));
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

SetStatus read_status(const fs::path& set_folder) {
  const std::optional<WorkList> list = read_work_list(set_folder);
  if (!list)
    throw input_error({.file = set_folder.string(),
                       .wanted = "a set that a job of `seamline render` has begun",
                       .found = "no records/work.json in it"});
  SetStatus status{.study = list->study, .truths = {}, .elements = {}};
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
  status.elements = read_marks(records / "running");
  std::error_code error;
  if (fs::is_regular_file(set_folder / "manifest.json", error))
    status.joined = static_cast<int>(read_manifest(set_folder).stimuli.size()) == status.of();
  return status;
}

std::string status_text(const fs::path& set_folder, const SetStatus& status) {
  const int done = status.done(), of = status.of();
  std::string out =
      fmt::format("{}: study {}, {} of {} stimuli done ({:.0f} %), {} left; {} at work, {} failed{}\n",
                  set_folder.string(), printable(status.study), done, of, percent(done, of), of - done,
                  count(status, true), count(status, false), status.joined ? "; the manifest lists all" : "");
  std::size_t longest = 0;
  for (const TruthStatus& truth : status.truths) longest = std::max(longest, truth.name.size());
  for (const TruthStatus& truth : status.truths)
    out += fmt::format("  {:<{}}  {:>6} of {:>6}{}\n", printable(truth.name), longest, truth.done, truth.of,
                       truth.reference ? "" : "  (its reference is not done)");
  for (const ElementStatus& element : status.elements)
    out += fmt::format("  {} on {}: {}\n", printable(element.name), element.host, state_text(element));
  return out;
}

void write_status_page(const fs::path& file, const fs::path& set_folder, const SetStatus& status) {
  const int done = status.done(), of = status.of();
  std::string body = fmt::format(
      "<p><strong>{} of {}</strong> stimuli are done ({:.0f} %); {} processes are at work, {} ended "
      "otherwise than "
      "well.{} This page is as old as its file: <code>seamline render --status {} --html FILE</code> writes "
      "it "
      "anew.</p>\n<table><thead><tr><th>truth</th><th>reference</th><th>stimuli</th><th></th></tr></"
      "thead><tbody>",
      done, of, percent(done, of), count(status, true), count(status, false),
      status.joined ? " The manifest lists all." : "", html_escape(set_folder.string()));
  for (const TruthStatus& truth : status.truths)
    body += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{} of {}</td><td><svg width=\"240\" height=\"14\" role=\"img\" "
        "aria-label=\"{:.0f} percent\"><rect width=\"240\" height=\"14\" fill=\"#ddd\"/><rect "
        "width=\"{:.1f}\" "
        "height=\"14\" fill=\"#2a7\"/></svg></td></tr>\n",
        html_escape(truth.name), truth.reference ? "done" : "&ndash;", truth.done, truth.of,
        percent(truth.done, truth.of), 2.4 * percent(truth.done, truth.of));
  body += "</tbody></table>\n";
  if (!status.elements.empty()) {
    body += "<table><thead><tr><th>process</th><th>machine</th><th>how far</th></tr></thead><tbody>";
    for (const ElementStatus& element : status.elements)
      body += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td></tr>\n", html_escape(element.name),
                          html_escape(element.host), html_escape(state_text(element)));
    body += "</tbody></table>\n";
  }
  write_file_atomically(file, html_page("Rendering " + html_escape(status.study), body));
}

}  // namespace seamline::renderer
