#include "analysis/report/text/joint_text.h"

#include <fmt/format.h>

#include <cmath>

#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

constexpr double small_p = 0.05;

/// So many people show in nine of ten studies that curves differ in how people rate
/// (documentation/evidence/joint_model_checks.md).
constexpr int few_for_criteria = 40;

std::string goodness_sentence(const char* what, double g2, double p, int replicates) {
  if (replicates == 0)
    return fmt::format("Whether the joint model describes {} was not tested (G2 = {:.1f}).", what, g2);
  return fmt::format("The joint model {} {} (G2 = {:.1f}, {} among {} simulated data sets).",
                     p < small_p ? "does not describe" : "is not shown to fail on", what, g2, p_text(p),
                     replicates);
}

std::string list_of_tests(const std::vector<SharingTest>& tests) {
  std::string list;
  for (const SharingTest& test : tests)
    list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", test.shared, p_text(test.p));
  return list;
}

/// Which tests of sharing were refused, and what became of it.
std::vector<std::string> sharing_sentences(const JointAnalysis& joint) {
  if (joint.sharing.empty()) return {};
  std::vector<std::string> sentences;
  if (!joint.refused_sharing.empty())
    sentences.push_back(fmt::format("Curves were shown to want their own: {}. Each has its own of these.",
                                    list_of_tests(joint.refused_sharing)));
  std::vector<SharingTest> still;  // shared, although refused
  for (const SharingTest& test : joint.sharing)
    if (std::isfinite(test.p) && test.p < small_p &&
        (test.block == nullptr || joint.fit.model.sharing.*test.block))
      still.push_back(test);
  if (!still.empty())
    sentences.push_back(fmt::format(
        "Curves may want their own: {}. Thresholds rest on the shared ones; compare them with those of {}.",
        list_of_tests(still), request_name("own")));
  if (sentences.empty())
    sentences.push_back(
        "No curve is shown to want a scale, criteria, lapse rate or guess ratings of its own.");
  if (joint.fit.model.sharing.criteria && joint.fit.model.ratings > 1 && joint.fit.people < few_for_criteria)
    sentences.emplace_back(
        "Few participants show little of this: 20 simulated ones whose curves differed in how people rate showed "
        "it in a third of the studies, and 95 % intervals held the truth in 89 to 95 %. A study that expects "
        "such curves names share = [\"nothing\"].");
  return sentences;
}

}  // namespace

std::string as_sentence(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string sharing_method(const Analysis& analysis) {
  const JointAnalysis& joint = *analysis.joint;
  if (joint.data.curves.size() < 2) return "";
  if (!asked_of_log(analysis.log).sharing_tested) return "What curves share was fixed by the study file. ";
  const std::size_t refused = joint.refused_sharing.size();
  return fmt::format(
      "What curves share was decided by the answers: the block that a robust score test over participants (Boos, "
      "1992) refuses most, with p below {}, becomes each curve's own, until none is refused. {} refused. ",
      refused_sharing_p,
      refused == 0   ? "None was"
      : refused == 1 ? "One was"
                     : fmt::format("{} were", refused));
}

std::vector<std::string> joint_check_sentences(const Analysis& analysis) {
  std::vector<std::string> sentences;
  if (!analysis.joint || !analysis.joint->fit.estimated()) return sentences;
  const JointAnalysis& joint = *analysis.joint;
  if (joint.goodness) {
    const JointGoodness& goodness = *joint.goodness;
    sentences.push_back(goodness_sentence("right and wrong choices", goodness.choices_g2, goodness.choices_p,
                                          goodness.replicates));
    if (joint.data.ratings > 1)
      sentences.push_back(goodness_sentence("the ratings of right choices", goodness.ratings_g2,
                                            goodness.ratings_p, goodness.replicates));
  }
  for (std::string& sentence : sharing_sentences(joint)) sentences.push_back(std::move(sentence));
  if (joint.fit.model.between_people) {
    sentences.push_back(fmt::format(
        "Participants' thresholds on a curve differ with a standard deviation of {:.2f} {}, estimated with the "
        "curves. The fit is not tested: levels were placed by the answers, so no cell has an expected count.",
        std::abs(difference_at(joint.axis, joint.people.shift_sd)), length_unit(joint.axis)));
    return sentences;
  }
  sentences.push_back(
      fmt::format("Participants' thresholds differ with a standard deviation of {:.2f} {}, and beside that "
                  "from curve to curve "
                  "with one of {:.2f}.",
                  std::abs(difference_at(joint.axis, joint.people.shift_sd)), length_unit(joint.axis),
                  std::abs(difference_at(joint.axis, joint.people.curve_sd))));
  return sentences;
}

std::vector<std::string> joint_conclusions(const Analysis& analysis, const ReportNumbers& numbers) {
  std::vector<std::string> sentences;
  if (!analysis.joint) return sentences;
  sentences = analysis.joint->contrasts.notes;
  for (const ContrastTable& contrasts : analysis.joint->contrasts.tables)
    for (const ContrastRow& row : contrasts.rows) sentences.push_back(as_sentence(row.conclusion));
  for (const GroupComparison& groups : numbers.groups) {
    if (!groups.verdict.empty()) sentences.push_back(groups.field + ": " + groups.verdict);
    for (const ContrastRow& row : groups.shifts.rows) sentences.push_back(as_sentence(row.conclusion));
    sentences.insert(sentences.end(), groups.notes.begin(), groups.notes.end());
  }
  for (const ContrastRow& row : numbers.halves.shifts.rows)
    if (row.verdict == ContrastVerdict::differs) sentences.push_back(as_sentence(row.conclusion));
  return sentences;
}

}  // namespace seamline::analysis
