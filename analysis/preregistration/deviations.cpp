#include "analysis/preregistration/deviations.h"

#include <fmt/format.h>

#include <algorithm>

#include "support/text/counted.h"

namespace seamline::analysis {
namespace {

constexpr std::size_t short_hash = 12;

std::string in_short(const std::string& hash) {
  return hash.size() > short_hash ? hash.substr(0, short_hash) + "..." : hash;
}

std::string used_or_left_out(bool left_out) {
  return left_out ? "left out" : "named and used";
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

/// Collects what differs.
struct Comparing {
  std::vector<Deviation> deviations;

  void same(const std::string& what, const std::string& frozen, const std::string& found) {
    if (frozen != found) deviations.push_back({.what = what, .frozen = frozen, .found = found});
  }
};

void compare_data(Comparing& comparing, const Preregistration& frozen, const AnalysisDone& done) {
  if (frozen.study_hash != done.study_hash)
    comparing.deviations.push_back({"study", in_short(frozen.study_hash), in_short(done.study_hash)});
  const bool known = std::any_of(frozen.sets.begin(), frozen.sets.end(),
                                 [&](const FrozenSet& set) { return set.set_hash == done.set_hash; });
  if (!known && !frozen.sets.empty()) {
    std::vector<std::string> hashes;
    for (const FrozenSet& set : frozen.sets) hashes.push_back(in_short(set.set_hash));
    comparing.deviations.push_back(
        {"stimulus set", fmt::format("{}", fmt::join(hashes, " or ")), in_short(done.set_hash)});
  }
  comparing.same("program", "Seamline " + frozen.program_version, "Seamline " + done.program_version);
  comparing.same("participants used", std::to_string(frozen.participants),
                 std::to_string(done.participants_used));
}

void compare_exclusions(Comparing& comparing, const FrozenAnalysis& frozen, const AnalysisDone& done) {
  comparing.same("exclusion rule: whom a screen names", used_or_left_out(frozen.exclude_screened),
                 used_or_left_out(done.analysis.exclude_screened));
  comparing.same("exclusion rule: whom catch trials name", used_or_left_out(frozen.exclude_inattentive),
                 used_or_left_out(done.analysis.exclude_inattentive));
  comparing.same("exclusion rule: vision neither normal nor corrected",
                 used_or_left_out(frozen.exclude_uncorrected),
                 used_or_left_out(done.analysis.exclude_uncorrected));
  comparing.same("exclusion rule: pilot data", frozen.include_pilot ? "used" : "left out",
                 done.analysis.include_pilot ? "used" : "left out");
  if (frozen.by_hand.empty() && !done.excluded.empty())
    comparing.deviations.push_back(
        {"exclusion rule: by hand", "nobody", fmt::format("{}", fmt::join(done.excluded, ", "))});
  for (const std::string& rule : frozen.rules)
    if (!contains(done.analysis.rules, rule))
      comparing.deviations.push_back({"rule of the program", rule, "not so today"});
  for (const std::string& rule : done.analysis.rules)
    if (!contains(frozen.rules, rule)) comparing.deviations.push_back({"rule of the program", "none", rule});
}

void compare_options(Comparing& comparing, const FrozenAnalysis& frozen, const FrozenAnalysis& done) {
  comparing.same("bootstrap replicates", std::to_string(frozen.bootstrap_replicates),
                 std::to_string(done.bootstrap_replicates));
  const auto listed = [](const std::vector<std::string>& fields) {
    return fields.empty() ? std::string("as the program does by itself")
                          : fmt::format("{}", fmt::join(fields, ", "));
  };
  comparing.same("groups compared", listed(frozen.compare), listed(done.compare));
  comparing.same("bootstrap seed", std::to_string(frozen.seed), std::to_string(done.seed));
  comparing.same("field of view", fmt::format("{:g} degrees", frozen.field_of_view_deg),
                 fmt::format("{:g} degrees", done.field_of_view_deg));
}

std::vector<std::string> remarks_on(const Preregistration& frozen, const AnalysisDone& done) {
  std::vector<std::string> remarks;
  if (frozen.sets.empty())
    remarks.emplace_back("No stimulus set was frozen, so any set of the study would do.");
  if (!frozen.analysis.by_hand.empty())
    remarks.push_back(fmt::format(
        "Excluded by hand: {}. Frozen was: {} Whether the one follows from the other a reader has to judge.",
        done.excluded.empty() ? "nobody" : fmt::format("{}", fmt::join(done.excluded, ", ")),
        frozen.analysis.by_hand));
  return remarks;
}

}  // namespace

FrozenComparison compare_with_frozen(const Archive& archive, const AnalysisDone& done) {
  Comparing comparing;
  compare_data(comparing, archive.content, done);
  compare_exclusions(comparing, archive.content.analysis, done);
  compare_options(comparing, archive.content.analysis, done.analysis);
  return {.archive = archive.file.filename().string(),
          .sha256 = archive.sha256,
          .thresholds = archive.content.analysis.thresholds,
          .participants = archive.content.participants,
          .why_so_many = archive.content.why_so_many,
          .deviations = std::move(comparing.deviations),
          .remarks = remarks_on(archive.content, done)};
}

std::string verdict_of(const FrozenComparison& comparison) {
  const std::size_t count = comparison.deviations.size();
  return fmt::format("Preregistration {} ({}): {} Confirmatory: {}; all else explores.", comparison.sha256,
                     comparison.archive,
                     count == 0 ? "data and analysis are those that were frozen."
                                : counted(count, "deviation") + " from what was frozen.",
                     fmt::join(comparison.thresholds, ", "));
}

std::string deviations_in_words(const FrozenComparison& comparison) {
  if (comparison.deviations.empty()) return "Data and analysis were those that were frozen.";
  std::string list;
  for (const Deviation& one : comparison.deviations)
    list += fmt::format("{}{} (frozen: {}; found: {})", list.empty() ? "" : "; ", one.what, one.frozen,
                        one.found);
  return fmt::format("Deviations from what was frozen: {}.", list);
}

}  // namespace seamline::analysis
