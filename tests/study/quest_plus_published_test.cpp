// Sequences that were published: Watson (2017), "Implementation" and examples 1 to 3, as the tests of the
// questplus package (hoechenberger/questplus) list them: after the answers so far, the stimulus that was
// shown next. Rising functions on a linear axis (dB of contrast, degrees), grids of equal steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "study/placement/quest_plus_model.h"

namespace seamline::study {
namespace {

struct Published {
  std::string answers;  ///< c: correct, i: incorrect
  std::vector<int> shown;
};

const Published example_1 = {
    "cccciicccccccciccicciccccccccccc",
    {-18, -22, -25, -28, -30, -22, -13, -15, -16, -18, -19, -20, -21, -22, -23, -19,
     -20, -20, -18, -18, -19, -17, -17, -18, -18, -18, -19, -19, -19, -19, -19, -19}};

const Published implementation = {
    "cicccccccccccicciccciccccicccccccccccicciicccciciccciccccccccccc",
    {-18, -22, -12, -13, -15, -16, -17, -18, -19, -21, -24, -25, -26, -27, -21, -22,
     -23, -20, -20, -20, -21, -19, -19, -20, -20, -20, -19, -19, -19, -19, -19, -20,
     -20, -20, -20, -20, -21, -21, -20, -20, -20, -19, -18, -18, -19, -19, -19, -18,
     -18, -17, -18, -18, -18, -17, -17, -17, -17, -17, -17, -17, -18, -18, -18, -18}};

const Published example_2 = {
    "cccciiccccccccicicccccccicccccccciccccccccciccciccccccccicccccci"
    "ccccccccccccciciccccicciccccccciccccccccccccccciccciciiccccicccc",
    {-18, -22, -25, -28, -30, -21, -12, -14, -15, -16, -18, -19, -20, -22, -23, -18, -19, -16, -17,
     -17, -18, -18, -18, -19, -19, -17, -17, -18, -18, -18, -18, -19, -19, -20, -18, -18, -18, -18,
     -18, -19, -19, -19, -19, -20, -18, -18, -18, -18, -18, -18, -18, -18, -18, -19, -19, -19, -20,
     -18, -18, -18, -18, -19, -19, -19, -18, -18, -18, -18, -19, -19, -19, -19, -19, -19, -19, -19,
     -20, -21, -19, -19, -19, -19, -19, -19, -19, -18, -19, -19, -16, -16, -16, -16, -16, -16, 0,
     0,   -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -21, -21, -19, -19,
     -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19}};

const Published example_3 = {
    "ciiccccccciciiiiccicciiiciciiciiciciiciccciccciiiiiciiiiciiiciic"
    "iiiccciicciciiicciiiiiciiccicciciccicciciiiicccciciiiciiiiccccci",
    {0,  -1, 2,  -2, 2,  3,  3,  -5, 3,  3,  3,  3,  -7, -7, -7, -7, 4,  -7, 4,  4,  4, -8, -8, -8, 4,  -8,
     4,  -8, -7, 4,  -7, -7, 4,  -7, 4,  -7, -6, 3,  -4, -5, 3,  3,  -7, 2,  2,  1,  0, -7, -6, -6, -6, 2,
     -5, 2,  -6, -5, 3,  -5, -5, 3,  4,  -5, -5, 4,  -4, -4, -4, -4, 4,  3,  3,  4,  5, 5,  -5, 5,  -5, -5,
     4,  5,  5,  -5, -4, -4, -4, -4, 5,  -4, -4, -3, 4,  4,  5,  5,  -4, 5,  -4, -4, 5, 4,  5,  5,  -5, 5,
     -4, -4, -4, -4, 5,  -4, 5,  4,  -4, 4,  -4, -4, -4, 4,  -4, -4, -4, 4,  4,  -4, 4, 4,  4,  -4}};

constexpr int least_db = -40;
constexpr int levels_db = 41;

std::vector<double> from_to(double least, double most, double step) {
  std::vector<double> values;
  for (int i = 0; least + i * step < most + step / 2; ++i) values.push_back(least + i * step);
  return values;
}

/// Shows what the tables ask for and gives the published answers; the first stimulus of equals.
void expect_published(const QuestPlusTables& tables, QuestPlusPosterior& posterior, int least_level,
                      const Published& published) {
  ASSERT_EQ(published.answers.size(), published.shown.size());
  for (std::size_t trial = 0; trial < published.shown.size(); ++trial) {
    const std::vector<double> expected = expected_entropies_nats(tables, posterior);
    const auto best = std::min_element(expected.begin(), expected.end()) - expected.begin();
    ASSERT_EQ(least_level + best, published.shown[trial]) << "trial " << trial;
    learn(posterior, tables, static_cast<int>(best), published.answers[trial] == 'c' ? 1 : 0);
  }
}

double mode(const QuestPlusGrid& grid, const QuestPlusPosterior& posterior, Parameter parameter) {
  const auto best = std::max_element(posterior.mass.begin(), posterior.mass.end()) - posterior.mass.begin();
  return grid.value(parameter, static_cast<int>(best));
}

/// Watson's Weibull function of a level in dB, 1 - l - (1 - g - l) exp(-10^(b (x - t) / 20)), as what a study
/// file can say: exp(-e^y) = 2^(-e^(y - ln ln 2)), so b is a scale of 20 / (b ln 10) and its threshold, at 1
/// - 1/e, lies ln ln 2 scales above the one at 0.5.
TEST(QuestPlusPublished, Example1FromADefinition) {
  const double scale = 20 / (3.5 * std::numbers::ln10);
  const double shift = scale * std::log(std::numbers::ln2);
  QuestPlusDefinition definition;
  definition.axis = Axis::linear;
  definition.direction = Direction::increasing;
  definition.sigmoid = Sigmoid::gumbel;
  definition.threshold = {least_db + shift, 0 + shift, levels_db};
  definition.scale = {scale, scale, 1};
  definition.lapse = {0.02, 0.02, 1};
  definition.guess = {0.5, 0.5, 1};
  const QuestPlusGrid grid = make_grid(definition);
  const QuestPlusTables tables = make_quest_plus_tables(levels_db, 2, grid.points(), [&](int i, int point) {
    return outcome_probabilities(definition, grid, point, least_db + i);
  });
  QuestPlusPosterior posterior = prior_posterior(grid);
  expect_published(tables, posterior, least_db, example_1);
  EXPECT_NEAR(mode(grid, posterior, Parameter::threshold) - shift, -20, 1e-9);
}

/// The tables of Watson's Weibull function with a guess rate of 0.5. The scale of a Weibull function moves
/// its threshold at 0.5, so with several of them this grid (scale: b) is not one of a study file.
QuestPlusTables weibull_tables(const QuestPlusGrid& grid) {
  return make_quest_plus_tables(levels_db, 2, grid.points(), [&](int i, int point) {
    const double t = grid.value(Parameter::threshold, point), b = grid.value(Parameter::scale, point);
    const double l = grid.value(Parameter::lapse, point);
    const double right = 1 - l - (0.5 - l) * std::exp(-std::pow(10, b * (least_db + i - t) / 20));
    return std::vector<double>{1 - right, right};
  });
}

TEST(QuestPlusPublished, ImplementationWithSlopes) {
  const QuestPlusGrid grid{.values = {{from_to(least_db, 0, 1), from_to(2, 5, 1), {0.02}, {0.5}, {0}}}};
  QuestPlusPosterior posterior = prior_posterior(grid);
  expect_published(weibull_tables(grid), posterior, least_db, implementation);
  EXPECT_EQ(mode(grid, posterior, Parameter::threshold), -20);
  EXPECT_EQ(mode(grid, posterior, Parameter::scale), 3);
}

TEST(QuestPlusPublished, Example2WithSlopesAndLapses) {
  const QuestPlusGrid grid{
      .values = {{from_to(least_db, 0, 1), from_to(2, 5, 1), from_to(0, 0.04, 0.01), {0.5}, {0}}}};
  QuestPlusPosterior posterior = prior_posterior(grid);
  expect_published(weibull_tables(grid), posterior, least_db, example_2);
  EXPECT_EQ(mode(grid, posterior, Parameter::threshold), -20);
  EXPECT_EQ(mode(grid, posterior, Parameter::scale), 5);
  EXPECT_DOUBLE_EQ(mode(grid, posterior, Parameter::lapse), 0.04);
}

/// Mean, standard deviation and lapse rate of a cumulative normal whose lapses go to both answers alike: at
/// each lapse rate the guess rate is the same number, and the other points of the definition's grid have no
/// mass.
TEST(QuestPlusPublished, Example3FromADefinition) {
  QuestPlusDefinition definition;
  definition.axis = Axis::linear;
  definition.direction = Direction::increasing;
  definition.sigmoid = Sigmoid::normal;
  definition.threshold = {-5, 5, 11};
  definition.scale = {1, 10, 10, Steps::equal};
  definition.lapse = {0, 0.04, 5};
  definition.guess = {0, 0.04, 5};
  const QuestPlusGrid grid = make_grid(definition);
  constexpr int least_degree = -10;
  const QuestPlusTables tables = make_quest_plus_tables(21, 2, grid.points(), [&](int i, int point) {
    return outcome_probabilities(definition, grid, point, least_degree + i);
  });
  QuestPlusPosterior posterior = prior_posterior(grid);
  for (int point = 0; point < grid.points(); ++point)
    if (grid.index(Parameter::lapse, point) != grid.index(Parameter::guess, point))
      posterior.log_mass[static_cast<std::size_t>(point)] = -std::numeric_limits<double>::infinity();
  normalise(posterior);
  expect_published(tables, posterior, least_degree, example_3);
  EXPECT_EQ(mode(grid, posterior, Parameter::threshold), 0);
  EXPECT_EQ(mode(grid, posterior, Parameter::scale), 4);
  EXPECT_DOUBLE_EQ(mode(grid, posterior, Parameter::lapse), 0.01);
}

}  // namespace
}  // namespace seamline::study
