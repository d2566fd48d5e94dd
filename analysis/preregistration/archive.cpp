#include "analysis/preregistration/archive.h"

#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

#include "analysis/joint/joint_sharing.h"
#include "analysis/screening/screening.h"
#include "analysis/thresholds/threshold_rules.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"

namespace seamline::analysis {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* archive_format = "seamline preregistration 1";
constexpr std::string_view hash_line = "  \"sha256\": \"";
constexpr std::string_view last_lines = "\"\n}\n";
constexpr std::size_t hash_letters = 64;

Json analysis_json(const FrozenAnalysis& analysis) {
  Json json = {{"confirmatory_thresholds", analysis.thresholds},
               {"include_pilot", analysis.include_pilot},
               {"exclude_screened", analysis.exclude_screened},
               {"exclude_inattentive", analysis.exclude_inattentive},
               {"exclude_uncorrected", analysis.exclude_uncorrected},
               {"excluded_by_hand", analysis.by_hand},
               {"field_of_view_deg", analysis.field_of_view_deg},
               {"bootstrap_replicates", analysis.bootstrap_replicates},
               {"bootstrap_seed", analysis.seed},
               {"rules", analysis.rules}};
  if (!analysis.compare.empty()) json["compare"] = analysis.compare;
  return json;
}

InputError not_whole(const std::filesystem::path& file, const std::string& found) {
  return input_error({.file = file.string(), .wanted = "an archive of seamline freeze", .found = found});
}

/// Fields of one object of the archive; what is missing or of another kind ends the command.
struct ArchiveFields {
  const Json& json;
  const std::filesystem::path& file;

  [[nodiscard]] const Json& at(const char* key) const {
    const auto found = json.is_object() ? json.find(key) : json.end();
    if (found == json.end()) throw not_whole(file, std::string("no \"") + key + "\"");
    return *found;
  }
  template <class T>
  [[nodiscard]] T get(const char* key) const {
    const Json& value = at(key);
    try {
      if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
        if (value.is_number_unsigned() && std::in_range<T>(value.get<std::uint64_t>())) return value.get<T>();
      } else {
        return value.get<T>();
      }
    } catch (const Json::exception&) {
    }
    throw not_whole(file, std::string("another kind of value in \"") + key + "\"");
  }
  /// Archives of earlier versions lack what is newer.
  [[nodiscard]] bool has(const char* key) const { return json.is_object() && json.contains(key); }
  [[nodiscard]] ArchiveFields object(const char* key) const { return {at(key), file}; }
};

FrozenAnalysis read_analysis(const ArchiveFields& fields) {
  return {.thresholds = fields.get<std::vector<std::string>>("confirmatory_thresholds"),
          .include_pilot = fields.get<bool>("include_pilot"),
          .exclude_screened = fields.get<bool>("exclude_screened"),
          .exclude_inattentive = fields.has("exclude_inattentive") && fields.get<bool>("exclude_inattentive"),
          .exclude_uncorrected = fields.has("exclude_uncorrected") && fields.get<bool>("exclude_uncorrected"),
          .field_of_view_deg = fields.get<double>("field_of_view_deg"),
          .bootstrap_replicates = fields.get<int>("bootstrap_replicates"),
          .seed = fields.get<std::uint64_t>("bootstrap_seed"),
          .rules = fields.get<std::vector<std::string>>("rules"),
          .by_hand = fields.get<std::string>("excluded_by_hand"),
          .compare = fields.has("compare") ? fields.get<std::vector<std::string>>("compare")
                                           : std::vector<std::string>{}};
}

Preregistration read_content(const ArchiveFields& fields) {
  Preregistration content{.program_version = fields.get<std::string>("program_version"),
                          .study_name = fields.object("study").get<std::string>("name"),
                          .study_hash = fields.object("study").get<std::string>("hash"),
                          .study_text = fields.object("study").get<std::string>("text"),
                          .sets = {},
                          .analysis = read_analysis(fields.object("analysis")),
                          .participants = fields.object("participants").get<int>("number"),
                          .why_so_many = fields.object("participants").get<std::string>("why"),
                          .plan = fields.object("participants").get<std::vector<std::string>>("plan")};
  for (const Json& set : fields.at("sets")) {
    const ArchiveFields of_set{set, fields.file};
    content.sets.push_back(
        {.set_hash = of_set.get<std::string>("hash"), .stimuli = of_set.get<int>("stimuli")});
  }
  return content;
}

}  // namespace

std::string archive_text(const Preregistration& content) {
  Json sets = Json::array();
  for (const FrozenSet& set : content.sets)
    sets.push_back({{"hash", set.set_hash}, {"stimuli", set.stimuli}});
  const Json json = {
      {"format", archive_format},
      {"program_version", content.program_version},
      {"study", {{"name", content.study_name}, {"hash", content.study_hash}, {"text", content.study_text}}},
      {"sets", std::move(sets)},
      {"analysis", analysis_json(content.analysis)},
      {"participants",
       {{"number", content.participants}, {"why", content.why_so_many}, {"plan", content.plan}}}};
  std::string text = json.dump(2);
  text.erase(text.rfind("\n}"));
  text += ",\n";
  const std::string hash = sha256(text);
  return text.append(hash_line).append(hash).append(last_lines);
}

Archive read_archive(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  const std::size_t tail = hash_line.size() + hash_letters + last_lines.size();
  if (text.size() <= tail || text.compare(text.size() - tail, hash_line.size(), hash_line) != 0 ||
      !text.ends_with(last_lines))
    throw not_whole(file, "a file that does not end with its hash");
  const std::string hash = text.substr(text.size() - last_lines.size() - hash_letters, hash_letters);
  if (sha256(std::string_view(text).substr(0, text.size() - tail)) != hash)
    throw input_error({.file = file.string(),
                       .wanted = "the bytes that were frozen, with SHA-256 " + hash.substr(0, 12) + "...",
                       .found = "others: it was changed afterwards"});
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) throw not_whole(file, "no JSON");
  const ArchiveFields fields{json, file};
  if (const auto format = fields.get<std::string>("format"); format != archive_format)
    throw not_whole(file, "the format \"" + format + "\"");
  return {.file = file, .content = read_content(fields), .sha256 = hash};
}

std::vector<std::string> rules_of_analysis() {
  std::vector<std::string> rules = {
      "left out: whoever is excluded in the log, pilot data unless they are included, whoever did not "
      "finish"};
  for (std::string& rule : sentences_of_rules()) rules.push_back(std::move(rule));
  rules.push_back(sentence_of_sharing());
  for (const ScreeningRule rule : every_screening_rule)
    rules.push_back("screen " + std::string(rule_of(rule)));
  return rules;
}

}  // namespace seamline::analysis
