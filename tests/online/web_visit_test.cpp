// The page's visit (study/online/page/web/core) is the window's: the same events lead through the same
// screens, phases and records, event by event, whatever is hammered.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "stimuli/definition/parts/task_definition.h"
#include "support/running/overloaded.h"
#include "tests/program/run_program.h"
#include "tests/study/small_visit.h"

namespace seamline::study::online {
namespace {

using Json = nlohmann::json;

constexpr int trial_count = 9;

struct NamedEvent {
  VisitEvent event;
  Json json;
};

NamedEvent session_event(Random& random, std::int64_t now_ns) {
  const int number = static_cast<int>(random.below(7)) - 1;
  switch (random.below(13)) {
    case 0:
    case 6:
    case 7:
      return {Event(Tick{now_ns}), {{"type", "tick"}, {"now_ns", now_ns}}};
    case 1:
    case 8:
    case 9:
      return {Event(ImageShown{now_ns}), {{"type", "image_shown"}, {"now_ns", now_ns}}};
    case 2:
    case 3:
    case 10:
      return {Event(ObjectChosen{.index = number, .now_ns = now_ns}),
              {{"type", "object_chosen"}, {"index", number}, {"now_ns", now_ns}}};
    case 4:
    case 5:
    case 11:
      return {Event(RatingGiven{.rating = number, .now_ns = now_ns, .position = 21 * number}),
              {{"type", "rating_given"}, {"rating", number}, {"position", 21 * number}, {"now_ns", now_ns}}};
    default:
      return {Event(PictureTaken{}), {{"type", "picture_taken"}}};
  }
}

NamedEvent form_event(Random& random) {
  const std::vector<std::string> ages = {"", "33", "17", "33.5", "1e1", "+33", "0x21", "abc", "121", "120"};
  std::vector<FormAnswer> answers = {{"age", ages[random.below(ages.size())]}};
  Json list = {{{"field", "age"}, {"value", answers[0].value}}};
  for (const FormField& field : default_form())
    if (const auto* choice = std::get_if<ChoiceField>(&field.kind);
        choice != nullptr && random.below(8) != 0) {
      answers.push_back({field.name, random.below(8) == 0 ? "none of these" : choice->options.front()});
      list.push_back({{"field", field.name}, {"value", answers.back().value}});
    }
  return {FormSubmitted{answers}, {{"type", "form_submitted"}, {"answers", list}}};
}

NamedEvent any_event(Random& random, std::int64_t now_ns) {
  switch (random.below(20)) {
    case 0:
      return {ConsentGiven{}, {{"type", "consent_given"}, {"unix_s", 0}}};
    case 1:
      return random.below(40) == 0 ? NamedEvent{ConsentRefused{}, {{"type", "consent_refused"}}}
                                   : NamedEvent{WentBack{}, {{"type", "went_back"}}};
    case 2:
      return form_event(random);
    case 3:
      return {DisplayConfirmed{}, {{"type", "display_confirmed"}, {"facts", Json::object()}}};
    case 4:
    case 5:
      return {Continued{}, {{"type", "continued"}}};
    case 6:
      if (random.below(6) != 0) return session_event(random, now_ns);
      return {PauseBegun{}, {{"type", "pause_begun"}}};
    case 7:
      return {Enrolled{trials(trial_count)}, {{"type", "enrolled"}}};
    case 8:
    case 9:
      return {RecordStored{}, {{"type", "record_stored"}}};
    case 10:
      return random.below(2000) == 0
                 ? NamedEvent{StoreFailed{"full"}, {{"type", "store_failed"}, {"message", "full"}}}
                 : NamedEvent{Event(BreakEnded{}), {{"type", "break_ended"}}};
    default:
      return session_event(random, now_ns);
  }
}

std::string name_of(const Screen& screen) {
  return std::visit(
      Overloaded{
          [](const ConsentScreen&) -> std::string { return "consent"; },
          [](const FormScreen& form) { return fmt::format("form {}", form.problems.size()); },
          [](const DisplayScreen&) -> std::string { return "display"; },
          [](const InstructionScreen& page) { return fmt::format("instructions {}", page.page); },
          [](const TrainingScreen&) -> std::string { return "training"; },
          [](const FeedbackScreen& feedback) { return fmt::format("feedback {}", feedback.chosen_index); },
          [](const ReadyScreen&) -> std::string { return "ready"; },
          [](const TrialScreen&) -> std::string { return "trial"; },
          [](const BreakScreen&) -> std::string { return "break"; },
          [](const BriefingScreen&) -> std::string { return "briefing"; },
          [](const PauseScreen&) -> std::string { return "pause"; },
          [](const ThanksScreen&) -> std::string { return "thanks"; },
          [](const DeclinedScreen&) -> std::string { return "declined"; },
          [](const StoppedScreen&) -> std::string { return "stopped"; }},
      screen);
}

std::string name_of(const Phase& phase) {
  return std::visit(
      Overloaded{
          [](const Grey&) -> std::string { return "grey"; },
          [](const AwaitingImage&) -> std::string { return "awaiting"; },
          [](const Viewing&) -> std::string { return "viewing"; },
          [](const Gap&) -> std::string { return "gap"; },
          [](const Choosing&) -> std::string { return "choosing"; },
          [](const Rating& now) { return fmt::format("rating {} {}", now.chosen_index, now.choice_ns); },
          [](const Storing& now) {
            const TrialAnswer& a = now.answer;
            return fmt::format("storing {} {} {} {} {} {}", a.trial_index, a.chosen_index, a.rating,
                               a.choice_ns, a.rating_ns, a.position);
          },
          [](const OnBreak&) -> std::string { return "break"; },
          [](const Briefing&) -> std::string { return "briefing"; },
          [](const Done&) -> std::string { return "done"; }},
      phase);
}

std::string name_of(const std::optional<Record>& record) {
  if (!record) return "nothing";
  return std::visit(
      Overloaded{[](const DeclineRecord&) -> std::string { return "decline"; },
                 [](const ConsentRecord&) -> std::string { return "consent"; },
                 [](const FormRecord& form) { return fmt::format("form {}", form.answers.size()); },
                 [](const DisplayRecord&) -> std::string { return "display"; },
                 [](const TrainingRecord&) -> std::string { return "training"; },
                 [](const AnswerRecord&) -> std::string { return "answer"; },
                 [](const CompletionRecord&) -> std::string { return "completion"; }},
      *record);
}

std::string state_of(const Visit& visit) {
  const bool enrolled = current_trial(visit.session.trials) || answered_trials(visit.session.trials) > 0;
  return fmt::format(
      "{} | {} | {} {} | {}", name_of(visit.screen), name_of(visit.pending), name_of(visit.training.phase),
      answered_trials(visit.training.trials),
      enrolled ? fmt::format("{} {}", name_of(visit.session.phase), answered_trials(visit.session.trials))
               : "none");
}

/// Trials of three blocks, two of them briefed, in which a slider is asked for.
VisitScript briefed_script() {
  VisitScript said = script();
  const TaskDefinition slider{.kind = TaskKind::rating, .second_question = false, .slider = true};
  said.pace.task.facts = facts_of(&slider);
  std::vector<int> blocks(10 + trial_count, -1);
  for (int i = 0; i < trial_count; ++i)
    blocks[10 + static_cast<std::size_t>(i)] = std::array{0, -1, 1}[static_cast<std::size_t>(i / 4)];
  said.pace.briefed = std::make_shared<const std::vector<int>>(std::move(blocks));
  return said;
}

Json script_json(const VisitScript& said) {
  Json form = Json::array();
  for (const FormField& field : said.form) {
    if (const auto* number = std::get_if<NumberField>(&field.kind))
      form.push_back({{"name", field.name},
                      {"required", field.required},
                      {"kind", "number"},
                      {"least", number->least},
                      {"most", number->most},
                      {"whole", number->whole}});
    else
      form.push_back({{"name", field.name},
                      {"required", field.required},
                      {"kind", "choice"},
                      {"options", std::get<ChoiceField>(field.kind).options}});
  }
  return {{"form", form},
          {"instruction_pages", said.instruction_pages},
          {"training", {{{"right_index", 1}}, {{"right_index", 2}}}},
          {"pace",
           {{"break_every_trials", said.pace.break_every_trials},
            {"minimum_viewing_ns", said.pace.minimum_viewing_ns},
            {"inter_trial_ns", said.pace.inter_trial_ns},
            {"briefs", said.pace.briefed != nullptr},
            {"task",
             {{"kind", word(said.pace.task.facts.kind)},
              {"alternatives", said.pace.task.facts.alternatives},
              {"pictures", 1},
              {"exposure_ns", 0},
              {"gap_ns", 0},
              {"chooses", said.pace.task.facts.chooses},
              {"rates", said.pace.task.facts.rates},
              {"slides", said.pace.task.facts.slides}}}}}};
}

/// Of each trial that the page plans.
Json briefings_json(const VisitScript& said) {
  Json blocks = Json::array();
  for (int i = 0; said.pace.briefed && i < trial_count; ++i)
    blocks.push_back(said.pace.briefed->at(10 + static_cast<std::size_t>(i)));
  return blocks;
}

/// Hammered visits of a script, replayed in the page; how many came to their end.
int replay_visits(const VisitScript& said, const std::string& name) {
  Random random(2024);
  Json visits = Json::array();
  int thanks = 0;
  for (int run = 0; run < 40; ++run) {
    Visit visit = begin_visit(shared(said));
    Json steps = Json::array();
    std::int64_t now_ns = 0;
    for (int i = 0; i < 8000 && !is_over(visit); ++i) {
      now_ns += second / 3;
      const NamedEvent event = any_event(random, now_ns);
      visit = next(std::move(visit), event.event);
      steps.push_back({event.json, state_of(visit)});
    }
    thanks += on<ThanksScreen>(visit) ? 1 : 0;
    visits.push_back(std::move(steps));
  }
  const auto folder = test::fresh_folder(name);
  test::write_text(folder / "visits.json", Json{{"script", script_json(said)},
                                                {"trials", trial_count},
                                                {"briefings", briefings_json(said)},
                                                {"visits", visits}}
                                               .dump());
  const std::string source = SEAMLINE_SOURCE_DIR;
  const test::Outcome outcome =
      test::run_program("node", source + "/tests/online/replay.mjs " + source + "/study/online/page/web " +
                                    (folder / "visits.json").string());
  EXPECT_EQ(outcome.status, 0) << outcome.output.substr(0, 2000);
  return thanks;
}

TEST(WebVisit, TheSameEventsLeadThroughTheSameScreensAsInTheWindow) {
  if (test::run_program("node", "--version").status != 0) GTEST_SKIP() << "no node";
  EXPECT_GT(replay_visits(script(), "web-visits"), 10) << "most visits come to their end";
}

TEST(WebVisit, BlocksWithInstructionsAndSlidersAreThoseOfTheWindow) {
  if (test::run_program("node", "--version").status != 0) GTEST_SKIP() << "no node";
  EXPECT_GT(replay_visits(briefed_script(), "web-visits-briefed"), 10);
}

TEST(WebVisit, ThePagesOwnPartsKeepTheirLaws) {
  if (test::run_program("node", "--version").status != 0) GTEST_SKIP() << "no node";
  const std::string source = SEAMLINE_SOURCE_DIR;
  const test::Outcome outcome =
      test::run_program("node", source + "/tests/online/laws.mjs " + source + "/study/online/page/web");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
}

}  // namespace
}  // namespace seamline::study::online
