#include "stimuli/study_file_procedure.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "stimuli/study_file_words.h"

namespace seamline::inline stimuli {
namespace {

constexpr int most_values = 1001;              // of one parameter
constexpr std::int64_t most_points = 1000000;  // of the whole grid

/// A table with `least`, `most` and `count`.
ParameterRange read_range(const TomlTable& settings, const char* key, const ParameterRange& fallback,
                          Range bounds) {
  const std::optional<TomlTable> table = settings.table(key);
  if (!table) return fallback;
  ParameterRange range;
  range.least = table->number("least", fallback.least, bounds);
  range.most = table->number("most", fallback.most, bounds);
  range.count = table->integer("count", fallback.count, {1, most_values, "values"});
  table->finish();
  const bool single = range.count == 1;
  if (single ? range.most != range.least : range.most <= range.least)
    throw table->complaint("most",
                           fmt::format("{} least ({}), with count = {}", single ? "the same as" : "more than",
                                       range.least, range.count),
                           fmt::format("{}", range.most));
  return range;
}

void check_sizes(const TomlTable& table, const QuestPlusDefinition& quest) {
  const std::int64_t points = std::int64_t{1} * quest.threshold_px.count * quest.scale_octaves.count *
                              quest.lapse.count * quest.guess.count * quest.rating_step_octaves.count;
  if (points > most_points)
    throw table.complaint("threshold_px",
                          fmt::format("at most {} combinations of all parameters", most_points),
                          fmt::format("{}", points));
  if (quest.lapse.most + quest.guess.most >= 1)
    throw table.complaint("lapse", "lapse and guess that leave room for seeing (less than 1 together)",
                          fmt::format("{}", quest.lapse.most + quest.guess.most));
  if (quest.min_trials > quest.max_trials)
    throw table.complaint("min_trials", fmt::format("at most max_trials ({})", quest.max_trials),
                          fmt::format("{}", quest.min_trials));
}

void read_ratings(const TomlTable& table, QuestPlusDefinition& quest) {
  const bool asked = quest.outcome == PlacementOutcome::noticeability;
  if (!asked && table.has("rating_step_octaves"))
    throw table.complaint("outcome", "\"noticeability\" where there are rating_step_octaves", "\"correct\"");
  quest.rating_step_octaves =
      asked ? read_range(table, "rating_step_octaves", quest.rating_step_octaves, {1e-3, 100, "octaves"})
            : ParameterRange{1, 1, 1};
}

void read_stops(const TomlTable& table, QuestPlusDefinition& quest) {
  if (!table.has("max_shows_per_image"))
    throw table.complaint("max_shows_per_image", "how often a participant may see the same image", "nothing");
  quest.max_shows_per_image = table.integer("max_shows_per_image", 1, {1, 100000, "shows"});
  quest.max_trials = table.integer("max_trials", quest.max_trials, {1, 100000, "trials"});
  quest.min_trials =
      table.integer("min_trials", std::min(quest.min_trials, quest.max_trials), {1, 100000, "trials"});
  if (table.has("stop_interval_octaves"))
    quest.stop_interval_octaves = table.number("stop_interval_octaves", 0, {1e-3, 100, "octaves"});
  if (table.has("stop_entropy_nats"))
    quest.stop_entropy_nats = table.number("stop_entropy_nats", 0, {0, 100, "nats"});
  quest.edge_share = table.number("edge_share", quest.edge_share, {1e-6, 1});
}

QuestPlusDefinition read_quest_plus(const TomlTable& table, const std::vector<int>& depth_width_px) {
  QuestPlusDefinition quest;
  quest.outcome = one_of<PlacementOutcome>(
      table, "outcome", quest.outcome,
      {{"correct", PlacementOutcome::correct}, {"noticeability", PlacementOutcome::noticeability}});
  quest.track =
      one_of<PlacementTrack>(table, "track", quest.track,
                             {{"artifact", PlacementTrack::artifact}, {"object", PlacementTrack::object}});
  quest.sigmoid = one_of<Sigmoid>(
      table, "sigmoid", quest.sigmoid,
      {{"logistic", Sigmoid::logistic}, {"norm", Sigmoid::normal}, {"gumbel", Sigmoid::gumbel}});
  const ParameterRange around{depth_width_px.front() / 2.0, depth_width_px.back() * 2.0, 41};
  quest.threshold_px = read_range(table, "threshold_px", around, {1e-3, 1e9, "px"});
  quest.scale_octaves = read_range(table, "scale_octaves", quest.scale_octaves, {1e-3, 100, "octaves"});
  quest.lapse = read_range(table, "lapse", quest.lapse, {0, 0.5});
  quest.guess = read_range(table, "guess", quest.guess, {0, 0.99});
  read_ratings(table, quest);
  read_stops(table, quest);
  table.finish();
  check_sizes(table, quest);
  return quest;
}

}  // namespace

ProcedureDefinition read_procedure(const TomlTable& study, const std::vector<int>& depth_width_px) {
  const bool adaptive = one_of<bool>(study, "procedure", false, {{"constant", false}, {"quest_plus", true}});
  const std::optional<TomlTable> settings = study.table("quest_plus");
  if (settings && !adaptive)
    throw study.complaint("procedure", "\"quest_plus\" where there is a table [quest_plus]", "\"constant\"");
  if (!adaptive) return ConstantDefinition{};
  if (!settings)
    throw study.complaint("quest_plus", "a table [quest_plus] with at least max_shows_per_image", "nothing");
  return read_quest_plus(*settings, depth_width_px);
}

}  // namespace seamline::stimuli
