#include "study/online/serving/serve.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "study/online/intake/import.h"
#include "study/online/messages/shown_names.h"
#include "study/online/serving/tokens.h"
#include "support/running/interrupt.h"
#include "support/text/counted.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::study::online {
namespace {

constexpr double patience_at_end_s = 3;  ///< below `patience_after_signal_s`

void check_same_study(const ServeRequest& request, const SiteFiles& site, const RenderedSet& set) {
  const auto check = [&](const char* field, const std::string& wanted, const std::string& found) {
    if (wanted == found) return;
    throw input_error({.file = (request.folder / "study.json").string(),
                       .field = field,
                       .wanted = fmt::format("{} of study \"{}\", set {}", wanted,
                                             printable(set.study.name, 80), printable(set.folder.string())),
                       .found = fmt::format("{} of study \"{}\"", found, printable(site.study_name, 80))});
  };
  check("study_hash", set.manifest.study_hash, site.study_hash);
  check("set_hash", set.set_hash, site.set_hash);
  const int orders = set.study.session.orders;
  if (site.slots < 1 || (orders > 0 && site.slots < orders))
    throw input_error({.file = (request.folder / "study.json").string(),
                       .field = "slots",
                       .wanted = "at least " + counted(std::max(1, orders), "order"),
                       .found = std::to_string(site.slots)});
  // Ids of the set name the inserted object, and the server does not know them.
  const ShownNames names(set);
  for (int i = 0; i < std::ssize(set.manifest.stimuli); ++i)
    if (!site.picture_of.contains("stimulus " + names.name_of({.stimulus = i})))
      throw input_error({.file = (request.folder / "study.json").string(),
                         .field = "stimuli",
                         .wanted = "the names that a page shows today (export the page again)",
                         .found = "those of an older version, which tell the right answers"});
}

/// Codes and quotas can be changed in the set's study while a page is out; what the page asks of the link and
/// says of the end was exported.
void check_recruitment(const ServeRequest& request, const SiteFiles& site, const RenderedSet& set) {
  const RecruitmentDefinition none;
  const RecruitmentDefinition& wanted = set.study.recruitment ? *set.study.recruitment : none;
  if (site.recruited == (set.study.recruitment != nullptr) && site.identifiers == wanted.identifiers) return;
  throw input_error({.file = (request.folder / "study.json").string(),
                     .field = "recruitment",
                     .wanted = "the identifiers of [recruitment] in " + set.study.file.string() +
                               " (export the page again)",
                     .found = "others"});
}

std::optional<HttpResponse> not_this_host() {
  return HttpResponse{.status = 421,
                      .body =
                          "{\"error\":\"This server does not answer to this name. Its operator can "
                          "name it with " +
                          request_name("host") + ".\"}"};
}

/// What was refused, counted, so that a flood of requests is not a flood of lines.
class Refusals {
 public:
  void count(const std::string& path, int status) {
    const std::lock_guard guard(lock_);
    const std::string what = fmt::format("{} {}", status, path);
    ++of_[what];
    ++in_all_[what];
  }
  [[nodiscard]] std::map<std::string, int> take() {
    const std::lock_guard guard(lock_);
    return std::exchange(of_, {});
  }
  [[nodiscard]] std::map<std::string, int> in_all() {
    const std::lock_guard guard(lock_);
    return in_all_;
  }

 private:
  std::mutex lock_;
  std::map<std::string, int> of_, in_all_;
};

}  // namespace

void serve(const ServeRequest& request, const std::function<void(const std::string&)>& say) {
  const SiteFiles site = read_site_files(request.folder);
  const RenderedSet set = set_for_log(request.log, request.set);
  check_same_study(request, site, set);
  std::optional<Invitations> invitations;
  if (!request.tokens.empty()) invitations.emplace(request.tokens, say, request.codes);
  Intake intake(set, request.log);
  intake.limit(request.service.stored);
  Refusals refusals;
  std::optional<RecruitmentDesk> desk;
  if (set.study.recruitment) desk.emplace(*set.study.recruitment, request.log, site.pilot);
  check_recruitment(request, site, set);
  std::optional<Watch> watch;
  if (!request.watch.empty()) watch.emplace(request.watch, request.log, [&] { return refusals.in_all(); });
  StudyService service(site, intake,
                       {.invitations = invitations ? &*invitations : nullptr,
                        .desk = desk ? &*desk : nullptr,
                        .watch = watch ? &*watch : nullptr},
                       request.service);
  const auto noted = [&](const std::string& path, const std::optional<HttpResponse>& response) {
    if (response && response->status >= 400) refusals.count(loggable_path(path), response->status);
    return response;
  };
  HttpServer server(
      request.address, request.port,
      {.admit =
           [&](const RequestHead& head) {
             return is_own_host(head.host, request.hosts) ? service.admit(head) : not_this_host();
           },
       .now = [&](const HttpRequest& asked) { return noted(asked.head.path, service.now(asked)); },
       .later =
           [&](HttpRequest asked, Reply reply) {
             const std::string path = asked.head.path;
             service.later(std::move(asked), [&noted, path, reply = std::move(reply)](HttpResponse response) {
               (void)noted(path, response);
               reply(std::move(response));
             });
           },
       .refused = [&](const std::string& path, int status) { refusals.count(loggable_path(path), status); }},
      request.http);
  const bool is_six = request.address.find(':') != std::string::npos;
  say(fmt::format("serving {} at http://{}:{}/ into {}: {}, {} so far", request.folder.string(),
                  is_six ? "[" + request.address + "]" : request.address, server.port(), request.log.string(),
                  counted(service.participants(), "participant"), counted(service.answers(), "answer")));
  if (desk && !return_host(desk->recruitment()).empty())
    say(fmt::format("at the end people are sent to {}", return_host(desk->recruitment())));
  if (watch) say(fmt::format("who takes part: /watch, with the secret in {}", request.watch.string()));
  const auto report = [&] {
    for (const auto& [what, times] : refusals.take())
      say(fmt::format("refused: {} ({})", what, counted(times, "time")));
  };
  for (int round = 1; !interrupted(); ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    if (round % 5 == 0) server.close_slow_ones();
    if (round % 50 == 0) report();
  }
  server.stop(patience_at_end_s);
  service.finish();
  report();
  say(fmt::format("stopped: {}, {} in {}", counted(service.participants(), "participant"),
                  counted(service.answers(), "answer"), request.log.string()));
}

}  // namespace seamline::study::online
