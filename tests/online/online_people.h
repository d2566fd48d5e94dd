// People in browsers, as the messages that their pages would send.
#pragma once
#include <fmt/core.h>

#include <string>
#include <vector>

#include "study/observers/observer.h"
#include "study/online/messages/message.h"
#include "study/online/messages/message_writer.h"
#include "study/online/messages/shown_names.h"
#include "study/trials/participant_trials.h"
#include "study/trials/training_trials.h"
#include "support/arithmetic/random.h"
#include "support/files/hash.h"
#include "tests/study/temporary_set.h"

namespace seamline::study::online {

inline std::string uuid_of(std::uint64_t person, std::uint64_t number) {
  const std::string hex = sha256(fmt::format("uuid {} {}", person, number));
  return fmt::format("{}-{}-4{}-a{}-{}", hex.substr(0, 8), hex.substr(8, 4), hex.substr(13, 3),
                     hex.substr(17, 3), hex.substr(20, 12));
}

/// The study of these tests: four stimuli a width, a form and a consent of its own, catch trials.
inline std::string online_study_text(const std::string& widths_px = "64, 512", const std::string& more = {}) {
  return study_text("online", widths_px) +
         "[consent]\ntext = \"Our own text.\"\n[catch]\nattention = 1\nreference = 1\n[training]\ntrials = "
         "2\n" +
         more;
}

/// One page: what it would say next, numbered.
struct Page {
  const RenderedSet* set = nullptr;
  std::uint64_t number = 1;  ///< of the person; decides ids and answers
  std::string code = {};
  int slot = -1;
  Origin origin = Origin::serve;
  std::int64_t sequence = 0;
  std::int64_t accepted_unix_s = 1'700'000'000;
  bool pilot = false;
  bool is_old = false;  ///< of a version before shown names

  [[nodiscard]] Message say(MessageBody body) {
    const std::int64_t own = sequence++;
    return {.study_hash = set->manifest.study_hash,
            .set_hash = set->set_hash,
            .participant = code,
            .sequence = own,
            .id = uuid_of(number, static_cast<std::uint64_t>(own)),
            .body = std::move(body)};
  }
  [[nodiscard]] Message enrol() {
    return say(EnrolBody{.slot = slot,
                         .consent_sha256 = sha256(set->study.consent.text),
                         .accepted_unix_s = accepted_unix_s,
                         .user_agent = "Mozilla/5.0 (test)",
                         .origin = origin,
                         .pilot = pilot});
  }
  [[nodiscard]] static std::string form_value(const FormField& field) {
    if (const auto* number = std::get_if<NumberField>(&field.kind))
      return fmt::format("{}", static_cast<int>(std::max(number->least, 30.0)));
    return std::get<ChoiceField>(field.kind).options.front();
  }
  [[nodiscard]] Message form() {
    FormBody body;
    for (const FormField& field : set->study.form) body.answers.push_back({field.name, form_value(field)});
    return say(body);
  }
  [[nodiscard]] Message display() {
    return say(DisplayBody{.screen_width_px = 1920,
                           .screen_height_px = 1080,
                           .device_pixel_ratio = 1.25,
                           .viewport_width_px = 1536,
                           .viewport_height_px = 780,
                           .mm_per_px = 0.25,
                           .viewing_distance_mm = 600,
                           .pixels_per_degree = 41.9,
                           .refresh_hz = 59.94,
                           .gamma_confirmed = true});
  }
  /// The set's own id, which pages of older versions say.
  [[nodiscard]] std::string id_of(const Trial& trial) const {
    return set->manifest.stimuli[static_cast<std::size_t>(trial.stimulus)].id;
  }
  [[nodiscard]] TrialAnswer answer_to(int trial_index) const {
    Random random(number, static_cast<std::uint64_t>(trial_index));
    const auto chosen = static_cast<int>(1 + random.below(3)), rating = static_cast<int>(1 + random.below(4));
    return {.trial_index = trial_index,
            .chosen_index = chosen,
            .rating = rating,
            .choice_ns = 1'000'000'000 + trial_index,
            .rating_ns = 2'000'000'000 + trial_index};
  }
  [[nodiscard]] PictureAnswer picture_answer(const Trial& trial, const TrialAnswer& answer) const {
    return {.kind = trial.kind,
            .stimulus_id = is_old ? id_of(trial) : ShownNames(*set).name_of(trial),
            .chosen_index = answer.chosen_index,
            .rating = answer.rating,
            .choice_ns = answer.choice_ns,
            .rating_ns = answer.rating_ns};
  }
  [[nodiscard]] Message training(int index) {
    const Trial trial = training_trials(*set)[static_cast<std::size_t>(index)];
    return say(TrainingBody{.training_index = index, .answer = picture_answer(trial, answer_to(index))});
  }
  [[nodiscard]] Message answer(const Trial& trial, const TrialAnswer& answer) {
    return say(AnswerBody{.trial_index = answer.trial_index, .answer = picture_answer(trial, answer)});
  }
  [[nodiscard]] std::vector<Trial> order() const { return decided_trials(make_trial_rules(*set), slot, {}); }
  [[nodiscard]] Message answer(int trial_index) {
    return answer(order()[static_cast<std::size_t>(trial_index)], answer_to(trial_index));
  }

  /// From form to completion, once the code and the slot are known.
  [[nodiscard]] std::vector<Message> the_rest() {
    std::vector<Message> messages = {form(), display()};
    for (int i = 0; i < static_cast<int>(training_trials(*set).size()); ++i) messages.push_back(training(i));
    const std::vector<Trial> trials = order();
    for (int i = 0; i < static_cast<int>(trials.size()); ++i) {
      messages.push_back(say(EventBody{.monotonic_ns = 1000 + i, .kind = "shown", .trial_index = i}));
      messages.push_back(answer(trials[static_cast<std::size_t>(i)], answer_to(i)));
    }
    messages.push_back(say(CompletionBody{}));
    return messages;
  }
  /// Everything of a page on a host of files.
  [[nodiscard]] std::vector<Message> whole_stream() {
    std::vector<Message> messages = {enrol()};
    for (Message& message : the_rest()) messages.push_back(std::move(message));
    return messages;
  }
};

inline Page page_elsewhere(const RenderedSet& set, std::uint64_t number,
                           Origin origin = Origin::static_host) {
  return {.set = &set,
          .number = number,
          .code = fmt::format("w-{:016}", number),
          .slot = static_cast<int>(number - 1),
          .origin = origin,
          .accepted_unix_s = 1'700'000'000 + static_cast<std::int64_t>(number)};
}

inline std::string lines_of(const std::vector<Message>& messages) {
  std::string text;
  for (const Message& message : messages) text += message_line(message) + "\n";
  return text;
}

}  // namespace seamline::study::online
