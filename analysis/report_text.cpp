#include "analysis/report_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "stimuli/support/assets.h"

namespace seamline {

namespace {

std::string widths_text(const Analysis& analysis) {
  std::vector<int> widths;
  for (const ArtifactScores& scores : analysis.data.artifacts)
    widths.insert(widths.end(), scores.width_px.begin(), scores.width_px.end());
  std::sort(widths.begin(), widths.end());
  widths.erase(std::unique(widths.begin(), widths.end()), widths.end());
  std::string text;
  for (int width : widths) text += fmt::format("{}{} × {}", text.empty() ? "" : ", ", width, width / 2);
  return text;
}

std::string procedure(const Analysis& analysis) {
  int trials = 0;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) trials = std::max(trials, person.answers);
  return fmt::format(
      "Each image showed three objects, one of which had been composited into the picture with the help of a "
      "depth map; {} judged "
      "up to {} images each, in an order of their own. They chose the object that they took for the inserted "
      "one (forced choice) and "
      "rated how noticeable the insertion was: 1 slightly, 2 moderately, 3 very, 4 extremely. Noticeability "
      "is the rating when the "
      "choice was right and 0 when it was wrong. Equirectangular depth maps of {} texels were tested.",
      source_text(analysis), trials, widths_text(analysis));
}

constexpr const char* means_text =
    "Answers were averaged over the objects of an artifact within each participant and then over "
    "participants; error bars are standard "
    "errors of the mean over participants. The perceptual threshold (PT) and the width at which an artifact "
    "becomes slightly noticeable "
    "(SN) are the largest depth map widths at which the non-increasing isotonic regression of mean "
    "noticeability, linear in log2 width, "
    "equals 0.5 and 1.0. The inflection point (IP) is the centre of a four-parameter logistic fitted by "
    "least squares in log2 width. "
    "Where a curve does not cross a level within the widths tested, no threshold is given. Because the "
    "choice is forced, a participant "
    "who sees nothing is right one time in three and then rates at least 1: the floor of mean noticeability "
    "is at least 1/3, not 0.";

std::string intervals_text(const Analysis& analysis) {
  return fmt::format(
      "Intervals are 95 % confidence intervals over participants. For PT and SN they hold every width at "
      "which a score test does not "
      "tell the isotonic curve from the level (Student's t with n - 1 degrees of freedom; the variance over "
      "participants is read at the "
      "mean that the level implies, as in Wilson's interval). For IP they are expanded percentile intervals "
      "(Hesterberg, 2015) of {} "
      "bootstrap samples of participants (seed {}); a sample without an inflection point counts as infinite "
      "and is never dropped. An "
      "interval is open (\"above\", \"below\") where the data do not exclude a threshold beyond the widths "
      "tested.",
      analysis.resampling.replicates, analysis.resampling.seed);
}

constexpr const char* checks_method_text =
    "Beside them stand: PT and SN read off the logistic (expanded percentile intervals); thresholds of the "
    "curve corrected for guessing by a latent-class model (saw it, or guessed) fitted by expectation "
    "maximisation, with guessers' positions and ratings estimated from wrong choices and reference trials; "
    "and "
    "the range found when each object in turn is left out. Participants were screened by ITU-R BT.500 "
    "(kurtosis) "
    "and by correlation with the mean of the others; those named are counted and the thresholds are given "
    "with "
    "and without them.";

std::string software(const Analysis& analysis) {
  return fmt::format("Analysed with Seamline {} (study {}, study hash {}, set hash {}).", program_version(),
                     analysis.log.study_name, analysis.log.study_hash.substr(0, 12),
                     analysis.log.set_hash.substr(0, 12));
}

}  // namespace

std::vector<std::string> method_paragraphs(const Analysis& analysis) {
  std::vector<std::string> paragraphs = {procedure(analysis), means_text, intervals_text(analysis),
                                         checks_method_text, software(analysis)};
  if (!analysis.planted.empty())
    paragraphs.emplace_back(
        "The answers come from simulated observers with known psychometric functions. Planted values are PT, "
        "SN and IP of their "
        "expected mean noticeability, the floor from guessing included; they test the analysis and are not "
        "the values of Table 1 "
        "of the paper.");
  return paragraphs;
}

}  // namespace seamline
