#pragma once
#include <optional>
#include <string>

#include "study/visit/visit.h"
#include "support/arithmetic/random.h"

namespace seamline::study {

/// What a person who always does the next sensible thing does on a screen, at a time. The answer to trial t
/// of person p is always the same.
class ScriptedPerson {
 public:
  explicit ScriptedPerson(std::uint64_t seed) : seed_(seed) {}

  [[nodiscard]] TrialAnswer answer_to(int trial_index) const {
    Random random(seed_, static_cast<std::uint64_t>(trial_index));
    return {.trial_index = trial_index,
            .chosen_index = 1 + static_cast<int>(random.below(3)),
            .rating = 1 + static_cast<int>(random.below(4)),
            .choice_ns = second,
            .rating_ns = 2 * second};
  }

  /// The next event; time goes on by a second each time.
  [[nodiscard]] VisitEvent act(const Visit& visit) {
    now_ns_ += second;
    if (std::holds_alternative<ConsentScreen>(visit.screen)) return ConsentGiven{.unix_s = 1000};
    if (std::holds_alternative<FormScreen>(visit.screen)) return FormSubmitted{form()};
    if (std::holds_alternative<DisplayScreen>(visit.screen)) return DisplayConfirmed{display()};
    if (std::holds_alternative<TrainingScreen>(visit.screen)) return in_trial(visit.training);
    if (std::holds_alternative<TrialScreen>(visit.screen)) return in_trial(visit.session);
    return Continued{};
  }

  [[nodiscard]] static std::vector<FormAnswer> form() {
    return {{"age", "33"}, {"gender", "female"}, {"vision", "normal"}, {"technical_background", "yes"}};
  }

  [[nodiscard]] static DisplayFacts display() {
    return {.machine = "lab-1",
            .monitor = "Dull 24\"",
            .renderer = "software",
            .mode_width_px = 1920,
            .mode_height_px = 1080,
            .refresh_hz = 59.94,
            .framebuffer_width_px = 1920,
            .framebuffer_height_px = 1080,
            .mm_per_px = 0.2768,
            .viewing_distance_mm = 600,
            .pixels_per_degree = pixels_per_degree_of(0.2768, 600),
            .gamma_confirmed = true,
            .read_back_bytes = 1000};
  }

  static constexpr std::int64_t second = 1000000000;

 private:
  [[nodiscard]] VisitEvent in_trial(const Session& session) const {
    const TrialAnswer answer = answer_to(answered_trials(session.trials));
    if (std::holds_alternative<Grey>(session.phase)) return Event(Tick{now_ns_});
    if (std::holds_alternative<AwaitingImage>(session.phase)) return Event(ImageShown{now_ns_});
    if (std::holds_alternative<Choosing>(session.phase))
      return Event(ObjectChosen{.index = answer.chosen_index, .now_ns = now_ns_});
    return Event(RatingGiven{.rating = answer.rating, .now_ns = now_ns_});
  }

  std::uint64_t seed_;
  std::int64_t now_ns_ = 0;
};

}  // namespace seamline::study
