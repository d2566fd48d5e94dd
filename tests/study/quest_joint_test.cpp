// QUEST+ that learns by the joint model: its posteriors are those of an independent computation
// (tests/data/quest_joint_posteriors.py), its outcomes the joint model's, and its intervals hold the
// thresholds of people who are not the model.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "quest_plus_task.h"
#include "stimuli/study_file/study_file.h"
#include "support/arithmetic/random.h"
#include "temporary_set.h"
#include "tests/analysis/true_people.h"

namespace seamline::study {
namespace {

using nlohmann::json;

QuestPlusDefinition joint_definition() {
  std::string text = study_text("joint", paper_widths_px);
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\nmax_shows_per_image = 99\noutcome = \"joint\"\n");
  return std::get<QuestPlusDefinition>(read_study_text(text, "joint.toml").procedure);
}

Task joint_task() {
  Task task{.definition = joint_definition(), .grid = {}, .width_px = seven_widths_px, .tables = {}};
  task.grid = make_grid(task.definition);
  task.tables = make_level_tables(task.definition, task.grid, {task.width_px.begin(), task.width_px.end()});
  return task;
}

TEST(QuestJoint, PosteriorsAreThoseOfAnIndependentComputation) {
  std::ifstream in(SEAMLINE_SOURCE_DIR "/tests/data/quest_joint_posteriors.json");
  const json known = json::parse(in);
  const Task task = joint_task();
  double largest = 0;
  for (const json& session : known["sessions"]) {
    QuestPlusPosterior posterior = prior_posterior(task.grid);
    for (const json& trial : session["trials"]) {
      const auto width = std::find(task.width_px.begin(), task.width_px.end(), trial[0].get<int>());
      learn(posterior, task.tables, static_cast<int>(width - task.width_px.begin()), trial[1].get<int>());
    }
    for (const Parameter parameter : every_parameter) {
      const Moments found = moments(task.grid, posterior, parameter);
      const std::string name(word(parameter));
      largest = std::max({largest, std::abs(found.mean - session["mean"][name].get<double>()),
                          std::abs(found.sd - session["sd"][name].get<double>())});
    }
    EXPECT_NEAR(entropy_nats(posterior.mass), session["entropy_nats"].get<double>(), 1e-9);
  }
  EXPECT_LT(largest, 1e-9);
  RecordProperty("largest_error_of_a_moment", std::to_string(largest));
}

TEST(QuestJoint, OutcomesSumToOneAndFollowTheNoticeabilityThatRises) {
  for (const Axis axis : {Axis::log2, Axis::linear}) {
    QuestPlusDefinition falling = joint_definition();
    falling.axis = axis;
    falling.threshold = {100, 1000, 3};
    if (axis == Axis::linear) {
      falling.scale = {50, 200, 3};
      falling.rating_step = {30, 120, 2};
    }
    QuestPlusDefinition rising = falling;
    rising.direction = Direction::increasing;
    const QuestPlusGrid grid = make_grid(falling);
    for (int point = 0; point < grid.points(); point += 5) {
      const double t = grid.value(Parameter::threshold, point);
      for (const double away : {-1.5, -0.2, 0.7}) {
        const double step = axis == Axis::log2 ? away : 60 * away;
        const auto at = outcome_probabilities(falling, grid, point, level_of(axis, t - step));
        const auto mirrored = outcome_probabilities(rising, grid, point, level_of(axis, t + step));
        ASSERT_EQ(at.size(), 5U);
        EXPECT_NEAR(std::accumulate(at.begin(), at.end(), 0.0), 1, 1e-12);
        for (std::size_t k = 0; k < at.size(); ++k) EXPECT_NEAR(at[k], mirrored[k], 1e-12);
      }
    }
  }
}

/// Whether the 95 % interval of a simulated person's threshold holds it, after `trials` placed trials.
bool holds_threshold(const Task& task, const test::TruePeople& people, int number, int trials) {
  Random random(81, static_cast<std::uint64_t>(number));
  const std::size_t curve = static_cast<std::size_t>(number) % test::true_curves;
  const double rating_shift = people.rating_sd * random.normal();
  const double scale = people.scale_octaves * std::exp(people.slope_sd * random.normal());
  const double x = std::log2(people.midpoint_px[curve]) +
                   std::hypot(people.people_sd, people.artifact_sd) * random.normal();
  QuestPlusPosterior posterior = prior_posterior(task.grid);
  for (int trial = 0; trial < trials; ++trial) {
    const int width = task.best(posterior);
    const double object = people.object_octaves * (static_cast<double>(random.below(3)) - 1);
    const double d = (x + object - std::log2(task.width_px[static_cast<std::size_t>(width)])) / scale;
    const double u = random.uniform();
    int score = 0;
    if (random.uniform() >= people.lapse && u < test::detail::seen_share(people.seeing, d)) {
      score = 1;
      for (int k = 1; k < 4; ++k)
        score += u < test::detail::seen_and_rated(people, d, d + rating_shift / scale, k) ? 1 : 0;
    } else if (random.below(3) == 0) {
      double v = random.uniform();
      score = 1;
      for (std::size_t k = 0; k < 3 && v >= people.guess_rating[k]; ++k, ++score) v -= people.guess_rating[k];
    }
    learn(posterior, task.tables, width, score);
  }
  const CredibleInterval interval = interval95(task.grid, posterior, Parameter::threshold);
  return interval.low <= x && x <= interval.high;
}

TEST(QuestJoint, IntervalsHoldTheThresholdsOfPeopleWhoAreNotTheModel) {
  const Task task = joint_task();
  constexpr int people = 24, trials = 30;
  for (const test::TruePeople& kind : test::true_populations()) {
    if (kind.name != "default" && kind.name != "lapses" && kind.name != "strength") continue;
    int held = 0;
    for (int number = 0; number < people; ++number)
      held += holds_threshold(task, kind, number, trials) ? 1 : 0;
    std::printf("%s: %d of %d intervals hold\n", kind.name.c_str(), held, people);
    EXPECT_GE(held, people - 5) << kind.name;
  }
}

}  // namespace
}  // namespace seamline::study
