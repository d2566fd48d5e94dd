#include "study/online/serving/watch.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "study/log/log_place.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"

namespace seamline::study::online {
namespace {

using WatchJson = nlohmann::ordered_json;

std::string state_word(const OnlineStanding& one, const RecruitmentDesk* desk) {
  if (one.excluded) return "excluded";
  if (desk != nullptr)
    if (const auto ended = desk->outcomes().find(one.code); ended != desk->outcomes().end())
      return std::string(word(ended->second));
  return one.completed ? "finished" : "at it";
}

WatchJson disk_json(const std::filesystem::path& log) {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(log_place(log).parent_path(), error);
  std::uintmax_t bytes = 0;
  for (const std::filesystem::path& file : {log_place(log), ahead_file(log)}) {
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (!error) bytes += size;
  }
  return {{"free_bytes", space.available}, {"log_bytes", bytes}};
}

}  // namespace

Watch::Watch(const std::filesystem::path& secret_file, std::filesystem::path log,
             std::function<std::map<std::string, int>()> refused)
    : key_sha256_(sha256(secret_of_file(secret_file))), log_(std::move(log)), refused_(std::move(refused)) {
  auto page = std::make_shared<SentFile>();
  page->content_type = "text/html; charset=utf-8";
  page->bytes = read_file(web_page_folder() / "watch.html");
  page->version = "\"" + sha256(page->bytes).substr(0, 32) + "\"";
  page->size_bytes = static_cast<std::int64_t>(page->bytes.size());
  page_ = page;
}

bool Watch::is_key(const std::string& secret) const {
  return !secret.empty() && sha256(secret) == key_sha256_;
}

std::string Watch::facts_text(Intake& intake, const RecruitmentDesk* desk,
                              const Invitations* invitations) const {
  const std::int64_t now = now_unix_s();
  WatchJson people = WatchJson::array();
  for (const OnlineStanding& one : intake.standings())
    people.push_back({{"code", one.code},
                      {"pilot", one.pilot},
                      {"state", state_word(one, desk)},
                      {"answered", one.answered},
                      {"trials", one.trials},
                      {"began_s_ago", std::max<std::int64_t>(0, now - one.began_unix_s)},
                      {"seen_s_ago", std::max<std::int64_t>(0, now - one.last_unix_s)}});
  WatchJson refused = WatchJson::array();
  for (const auto& [what, times] : refused_()) refused.push_back({{"what", what}, {"times", times}});
  WatchJson facts = {{"study", intake.set().study.name}, {"people", std::move(people)},
                     {"declined", intake.declines()},    {"refused", std::move(refused)},
                     {"disk", disk_json(log_)},          {"quotas", WatchJson::array()}};
  if (desk != nullptr) {
    for (const QuotaState& quota : desk->quotas(intake))
      facts["quotas"].push_back(
          {{"who", quota.people_who}, {"people", quota.people}, {"most", quota.most_people}});
    if (desk->recruitment().closes_unix_s) facts["closes_in_s"] = *desk->recruitment().closes_unix_s - now;
  }
  if (invitations != nullptr) {
    const std::vector<ListedInvitation> listed =
        list_invitations(invitations->file(), used_invitations(log_));
    const auto used = std::count_if(listed.begin(), listed.end(), [](const auto& one) { return one.used; });
    facts["invitations"] = {{"used", used}, {"free", static_cast<std::int64_t>(listed.size()) - used}};
  }
  return facts.dump(-1, ' ', false, WatchJson::error_handler_t::replace);
}

}  // namespace seamline::study::online
