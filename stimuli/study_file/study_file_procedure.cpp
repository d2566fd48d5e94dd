#include "stimuli/study_file/study_file_procedure.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "stimuli/settings/people/procedure_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/study_file_range.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::int64_t most_points = 1000000;  // of the whole grid
constexpr std::int64_t joint_points = 12;      // what the joint model multiplies it by (study/placement)

/// The axis of a study, and how its keys end: lengths on the log2 axis are octaves, on the linear one the
/// level's unit.
struct AxisWords {
  bool linear = false;
  const QuantityFacts& level;

  [[nodiscard]] std::string in_unit(const std::string& name) const {
    return level.unit_key.empty() ? name : fmt::format("{}_{}", name, level.unit_key);
  }
  [[nodiscard]] std::string key(const std::string& name) const {
    return linear ? in_unit(name) : name + "_octaves";
  }
  [[nodiscard]] NumberRange bounds() const {
    return linear ? NumberRange{1e-9, 1e9, level.unit} : NumberRange{1e-3, 100, "octaves"};
  }
};

/// The key of a length on the axis. Throws InputError when the table has that of the other axis.
std::string length_key(const TomlTable& table, const std::string& name, const AxisWords& axis) {
  const std::string other = AxisWords{.linear = !axis.linear, .level = axis.level}.key(name);
  if (table.has(other))
    throw table.complaint(
        other, fmt::format("{} where axis = \"{}\"", axis.key(name), axis.linear ? "linear" : "log2"), other);
  return axis.key(name);
}

void check_sizes(const TomlTable& table, const QuestPlusDefinition& quest) {
  const std::int64_t points = std::int64_t{1} * quest.threshold.count * quest.scale.count *
                              quest.lapse.count * quest.guess.count * quest.rating_step.count *
                              (quest.outcome == PlacementOutcome::joint ? joint_points : 1);
  if (points > most_points)
    throw table.complaint("threshold_px",
                          fmt::format("at most {} combinations of all parameters", most_points),
                          fmt::format("{}", points));
  if (quest.lapse.most + quest.guess.most >= 1)
    throw table.complaint("lapse", "lapse and guess that leave room for seeing (less than 1 together)",
                          fmt::format("{}", quest.lapse.most + quest.guess.most));
}

void read_ratings(const TomlTable& table, const AxisWords& axis, QuestPlusDefinition& quest) {
  const bool asked = quest.outcome != PlacementOutcome::correct;
  const std::string key = length_key(table, "rating_step", axis);
  if (!asked && table.has(key))
    throw table.complaint("outcome", "\"joint\" or \"noticeability\" where there are " + key, "\"correct\"");
  quest.rating_step = asked
                          ? read_range(table, key.c_str(), quest.rating_step, {axis.bounds(), Steps::ratios})
                          : ParameterRange{1, 1, 1};
}

/// The grid of the joint model as it was seen to hold the truth of unlike people (adaptive_placement.md).
void set_joint_grid(QuestPlusDefinition& quest) {
  quest.sigmoid = Sigmoid::normal;
  quest.scale.count = 7;
  quest.lapse = {0, 0.04, 3};
  quest.rating_step.least = 0.1767766952966369;  // 2^-2.5
}

void read_stops(const TomlTable& table, const AxisWords& axis, QuestPlusDefinition& quest) {
  quest.min_trials = std::min(quest.min_trials, quest.max_trials);
  read_setting(table, "min_trials", quest);
  const std::string interval = length_key(table, "stop_interval", axis);
  if (table.has(interval)) quest.stop_interval = table.number(interval, 0, axis.bounds());
}

/// On the linear axis, what the usual octaves are to the seven widths of the paper, which span six.
void set_linear_lengths(QuestPlusDefinition& quest, const std::vector<double>& levels) {
  const double span = levels.size() > 1 ? levels.back() - levels.front() : std::max(levels.back(), 1.0);
  for (ParameterRange* range : {&quest.scale, &quest.rating_step}) {
    range->least *= span / 6;
    range->most *= span / 6;
  }
}

void read_grid(const TomlTable& table, const LevelDefinition& level, QuestPlusDefinition& quest) {
  const bool linear = quest.axis == Axis::linear;
  const AxisWords axis{.linear = linear, .level = facts(level.quantity)};
  if (linear) set_linear_lengths(quest, level.values);
  if (!linear && stands_apart(Axis::log2, level.values.front()))
    throw table.complaint("axis", "levels above 0 on the log2 axis, or axis = \"linear\"", "a level of 0");
  const double span = level.values.back() - level.values.front();
  // An octave more than the levels each way; on a linear axis that begins at 0, a sixth of its length.
  const bool from_zero = level.values.front() <= 0;
  const ParameterRange around{from_zero ? level.values.front() - span / 6 : level.values.front() / 2.0,
                              from_zero ? level.values.back() + span / 6 : level.values.back() * 2.0, 41};
  const NumberRange thresholds{linear && from_zero                          ? -1e9
                               : level.quantity == Quantity::depth_width_px ? 1e-3
                                                                            : 1e-12,
                               1e9, axis.level.unit};
  quest.threshold = read_range(table, axis.in_unit("threshold").c_str(), around,
                               {thresholds, linear ? Steps::equal : Steps::ratios});
  quest.scale = read_range(table, length_key(table, "scale", axis).c_str(), quest.scale,
                           {axis.bounds(), Steps::ratios});
  quest.lapse = read_range(table, "lapse", quest.lapse, {{0, 0.5}, Steps::equal, true});
  quest.guess = read_range(table, "guess", quest.guess, {{0, 0.99}, Steps::equal, true});
  read_ratings(table, axis, quest);
  read_stops(table, axis, quest);
}

QuestPlusDefinition read_quest_plus(const TomlTable& table, const LevelDefinition& level) {
  QuestPlusDefinition quest;
  quest.axis = level.axis();
  quest.direction = level.noticeability;
  read_setting(table, "outcome", quest);
  if (quest.outcome == PlacementOutcome::joint) set_joint_grid(quest);
  read_settings(table, quest);
  read_grid(table, level, quest);
  table.finish();
  check_sizes(table, quest);
  return quest;
}

}  // namespace

ProcedureDefinition read_procedure(const TomlTable& study, const LevelDefinition& level) {
  constexpr std::array<std::string_view, 3> words = {"constant", "quest_plus", "staircase"};
  const std::string_view placement =
      study.has("procedure") ? words.at(read_word(study, "procedure", words)) : words[0];
  const bool adaptive = placement == "quest_plus";  // [staircase] is read with the task
  const std::optional<TomlTable> settings = study.table("quest_plus");
  if (settings && !adaptive)
    throw study.complaint("procedure", "\"quest_plus\" where there is a table [quest_plus]",
                          "\"" + std::string(placement) + "\"");
  if (!adaptive) return ConstantDefinition{};
  if (!settings)
    throw study.complaint("quest_plus", "a table [quest_plus] with at least max_shows_per_image", "nothing");
  return read_quest_plus(*settings, level);
}

}  // namespace seamline::inline stimuli
