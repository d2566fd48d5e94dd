#include "stimuli/definition/procedure_definition.h"

#include <fmt/core.h>

namespace seamline::inline stimuli {
namespace {

std::string text(const ParameterRange& range) {
  return fmt::format("{} {} {}", range.least, range.most, range.count);
}

/// What can be said since studies were first rendered, only where it is said: they keep their hash.
std::string further_text(const QuestPlusDefinition& definition) {
  std::string out;
  if (definition.axis == Axis::linear) out += "axis linear\n";
  if (definition.direction == Direction::increasing) out += "noticeability rises\n";
  out += canonical_text(definition.threshold, "threshold") + canonical_text(definition.scale, "scale") +
         canonical_text(definition.lapse, "lapse") + canonical_text(definition.guess, "guess");
  if (definition.outcome != PlacementOutcome::correct)
    out += canonical_text(definition.rating_step, "rating_step");
  return out;
}

std::string text(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "never";
}

std::string quest_plus_text(const QuestPlusDefinition& definition) {
  std::string out = fmt::format(
      "quest_plus outcome {} track {} sigmoid {} shows {} trials {} {} interval {} entropy {} "
      "edge {}\n",
      static_cast<int>(definition.outcome), static_cast<int>(definition.track),
      static_cast<int>(definition.sigmoid), definition.max_shows_per_image, definition.min_trials,
      definition.max_trials, text(definition.stop_interval), text(definition.stop_entropy_nats),
      definition.edge_share);
  out += fmt::format("grid {} | {} | {} | {}\n", text(definition.threshold), text(definition.scale),
                     text(definition.lapse), text(definition.guess));
  if (definition.outcome != PlacementOutcome::correct)
    out += fmt::format("ratings {}\n", text(definition.rating_step));
  return out + further_text(definition);
}

}  // namespace

std::string canonical_text(const ProcedureDefinition& procedure) {
  const auto* quest_plus = std::get_if<QuestPlusDefinition>(&procedure);
  return quest_plus != nullptr ? quest_plus_text(*quest_plus) : std::string();
}

}  // namespace seamline::inline stimuli
