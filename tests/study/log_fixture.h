#pragma once
#include <gtest/gtest.h>

#include "study/log/log.h"
#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/trials/catch_trials.h"
#include "study/trials/stimulus_order.h"
#include "support/text/error.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {

using test::complaint_of;

class LogTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set = write_set(folder / "set");
  std::filesystem::path path = folder / "log.sqlite";

  [[nodiscard]] std::vector<int> order(int slot) const {
    return stimulus_order(static_cast<int>(set.manifest.stimuli.size()),
                          {.study_seed = set.study.seed, .slot = slot});
  }
  [[nodiscard]] std::vector<Trial> all_trials(int slot) const { return interleave(order(slot), {}); }
  OpenSession enter(LogWriter& log, const Enrolment& enrolment, int answers) const {
    OpenSession session = enter_session(log, enrolment, set.study.session.orders);
    if (session.trials.empty()) log.append_trials(session, all_trials(session.slot));
    for (int i = 0; i < answers; ++i) log.append_answer(session, answer(session.answered));
    return session;
  }
  [[nodiscard]] static TrialAnswer answer(int trial_index) {
    return {.trial_index = trial_index,
            .chosen_index = 1 + trial_index % 3,
            .rating = 1 + trial_index % 4,
            .choice_ns = 1000 + trial_index,
            .rating_ns = 3000000000LL + trial_index};
  }
};

}  // namespace seamline::study
