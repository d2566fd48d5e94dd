#include "analysis/report/page/sections.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/log_analysis/people_choices.h"
#include "analysis/report/page/html_parts.h"
#include "analysis/report/text/threshold_text.h"
#include "stimuli/definition/parts/task_definition.h"
#include "study/running/staircase_results.h"
#include "support/text/html.h"

namespace seamline::analysis {

namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string with_interval(const std::string& estimate, const std::string& low, const std::string& high) {
  return fmt::format("{} ({} to {})", estimate, low, high);
}

std::string threshold_text(const ChoiceCurve& curve, const LevelAxis& axis) {
  const PooledFit& pooled = *curve.pooled;
  if (!pooled.threshold) return "–";
  return with_interval(estimated_text(axis, *pooled.threshold),
                       estimated_text(axis, pooled.threshold_ci95.low),
                       estimated_text(axis, pooled.threshold_ci95.high));
}

std::string known(const ChoiceCurve& curve, double value, const Interval& ci95, double factor, int digits) {
  if (!has_threshold(curve)) return "–";
  return with_interval(decimal_text(factor * value, digits), decimal_text(factor * ci95.low, digits),
                       decimal_text(factor * ci95.high, digits));
}

/// "p = 0.31"; a Monte Carlo p of r replicates is at least 1 / (r + 1).
std::string deviance_text(const ChoiceCurve& curve) {
  std::string text =
      fmt::format("{} ({} df)", decimal_text(curve.goodness.deviance, 1), curve.goodness.degrees_of_freedom);
  if (!std::isnan(curve.deviance_p))
    text += curve.deviance_p < 0.0015 ? ", p < 0.002" : fmt::format(", p = {:.3f}", curve.deviance_p);
  return text;
}

std::string threshold_title(const LevelAxis& axis) {
  if (of_depth_widths(axis)) return "threshold W, px";
  const std::string unit(facts(axis.quantity).unit);
  return unit.empty() ? "threshold" : "threshold, " + unit;
}

std::string fits_table(const ReportNumbers& numbers) {
  Lines lines;
  for (const ChoiceCurve& curve : numbers.choices) {
    if (!curve.pooled) continue;
    const PsychometricFit& fit = curve.pooled->fit;
    lines.push_back({artifact_title(curve.artifact, curve.condition), threshold_text(curve, numbers.axis),
                     known(curve, fit.width, curve.width_ci95, 1, 1),
                     known(curve, fit.function.lapse, curve.lapse_ci95, 100, 1), deviance_text(curve),
                     verdict_sentence(curve.pooled->verdict)});
  }
  return html_table({{"artifact"},
                     {threshold_title(numbers.axis), true},
                     {"width, " + length_unit(numbers.axis), true},
                     {"lapse, %", true},
                     {"deviance", true},
                     {"verdict"}},
                    lines);
}

std::string warnings_list(const ReportNumbers& numbers) {
  std::string items;
  for (const ChoiceCurve& curve : numbers.choices)
    for (const std::string& warning : curve.warnings)
      items += fmt::format("<li>{}{}: {}</li>\n", word(curve.artifact),
                           html_escape(in_condition(curve.condition)), html_escape(warning));
  return items.empty() ? "" : "<ul class=\"plain\">\n" + items + "</ul>\n";
}

std::string tracks_html(const ReportNumbers& numbers) {
  if (numbers.tracks.empty()) return "";
  Lines lines;
  for (const study::TrackEstimate& track : numbers.tracks) {
    std::string alarms;
    for (const study::EdgeAlarm& alarm : track.alarms) alarms += (alarms.empty() ? "" : "; ") + text(alarm);
    lines.push_back(
        {track.participant, track.track, track.used ? "yes" : "no", std::to_string(track.trials),
         with_interval(estimated_text(numbers.axis, track.threshold), estimated_text(numbers.axis, track.low),
                       estimated_text(numbers.axis, track.high)),
         track.axis == Axis::linear && !of_depth_widths(numbers.axis) ? fmt::format("{:.3g}", track.scale)
                                                                      : decimal_text(track.scale, 2),
         percent_text(track.lapse), alarms.empty() ? "–" : alarms});
  }
  const study::TrackEstimate& first = numbers.tracks.front();
  const bool linear = first.axis == Axis::linear;
  return fmt::format(
             "<h3>Tracks</h3>\n<p>Each participant’s thresholds from the posterior of QUEST+: the {} seen "
             "half of the time (mean{}, with the 95 % credible interval).{}</p>\n",
             level_word(numbers.axis), linear ? "" : " on log2",
             first.direction == Direction::increasing
                 ? fmt::format(" Noticeability rises with the {}.", level_word(numbers.axis))
                 : "") +
         html_table({{"participant"},
                     {"track"},
                     {"used"},
                     {"trials", true},
                     {threshold_title(numbers.axis), true},
                     {fmt::format("scale, {}", study::length_unit(first.axis, first.quantity)), true},
                     {"lapse", true},
                     {"alarms"}},
                    lines);
}

std::string staircases_html(const Analysis& analysis, const LevelAxis& axis) {
  if (!study::has_staircases(analysis.log)) return "";
  const std::vector<study::StaircaseEstimate> estimates = study::staircase_estimates(analysis.log);
  if (estimates.empty()) return "";
  std::vector<std::vector<std::string>> lines;
  for (const study::StaircaseEstimate& one : estimates)
    lines.push_back({one.participant, one.track, one.used ? "yes" : "no", std::to_string(one.trials),
                     std::to_string(one.reversals), one.level ? estimated_text(axis, *one.level) : "–"});
  return fmt::format(
             "<h3 id=\"staircases\">Staircases</h3>\n<p>Mean level of each staircase’s reversals{}, without "
             "the first two: the {} at which {} % of the answers are right. It is not the threshold of the "
             "functions above, which is where half is seen.</p>\n",
             is_linear(axis) ? "" : ", on log2", level_word(axis),
             decimal_text(100 * estimates.front().target, 1)) +
         html_table({{"participant"},
                     {"staircase"},
                     {"used"},
                     {"trials", true},
                     {"reversals", true},
                     {threshold_title(axis), true}},
                    lines);
}

std::string chance_text(const ReportNumbers& numbers) {
  if (!numbers.detection.rows.empty())
    return fmt::format("the false alarms, {}", decimal_text(numbers.guess_rate, 2));
  return fmt::format("1/{:.0f}", 1 / numbers.guess_rate);
}

std::string what_is_counted(const Analysis& analysis) {
  const TaskFacts task = facts_of(analysis.log.task.get());
  if (task.right_is_yes) return "How often people said yes, where something was inserted";
  return task.kind == TaskKind::object ? "Which object was chosen, without the ratings"
                                       : "Which alternative was chosen, without any rating";
}

std::string half_way_text(const ReportNumbers& numbers) {
  const bool of_three = std::abs(numbers.guess_rate - 1.0 / 3) < 1e-9;
  return of_three ? "2/3" : decimal_text((1 + numbers.guess_rate) / 2, 2);
}

std::string detection_html(const ReportNumbers& numbers) {
  const SignalDetection& detection = numbers.detection;
  if (detection.rows.empty()) return "";
  const auto between = [](double value, const Interval& ci95) {
    return std::isfinite(ci95.low) ? fmt::format("{} ({} to {})", decimal_text(value, 2),
                                                 decimal_text(ci95.low, 2), decimal_text(ci95.high, 2))
                                   : decimal_text(value, 2);
  };
  std::vector<std::vector<std::string>> lines;
  for (const DetectionRow& row : detection.rows)
    lines.push_back({std::string(word(row.artifact)) + in_condition(row.condition),
                     level_text(numbers.axis.quantity, row.level), std::to_string(row.people),
                     decimal_text(row.hits, 2), between(row.d_prime, row.d_prime_ci95),
                     between(row.criterion, row.criterion_ci95)});
  return fmt::format(
             "<h3 id=\"detection\">Yes or no: d′ and criterion</h3>\n<p>Of {} reference trials {} % were answered "
             "yes (false alarms). d′ = z(hits) − z(false alarms) says how well a seam is told from its reference, "
             "whatever the criterion −(z(hits) + z(false alarms)) / 2, which is above 0 for people who seldom say "
             "yes. Means over participants, half an answer added to each count; 95 % intervals over participants "
             "in brackets.</p>\n",
             detection.reference_answers, decimal_text(100 * detection.false_alarms, 1)) +
         html_table({{"artifact"},
                     {level_word(numbers.axis), true},
                     {"participants", true},
                     {"hits", true},
                     {"d′", true},
                     {"criterion", true}},
                    lines);
}

/// Every participant's own threshold.
std::string own_html(const std::vector<OwnThreshold>& people, const LevelAxis& axis) {
  constexpr std::size_t most_shown = 60;
  if (people.empty()) return "";
  Lines lines;
  for (const OwnThreshold& own : people) {
    if (lines.size() >= most_shown) break;
    lines.push_back({own.participant, artifact_title(own.artifact, own.condition),
                     std::to_string(own.answers), percent_text(own.right_share),
                     own.threshold ? with_interval(estimated_text(axis, *own.threshold),
                                                   estimated_text(axis, own.ci95.low),
                                                   estimated_text(axis, own.ci95.high))
                                   : "–",
                     verdict_sentence(own.verdict)});
  }
  return "<h3 id=\"own\">Each participant</h3>\n<p>The same function fitted to each participant’s answers alone, "
         "with 95 % intervals over these answers (profile likelihood): they are about this person, and say nothing "
         "of other people. " +
         std::string(people.size() > most_shown ? "The others are" : "Also") +
         " in <code>thresholds_people.csv</code>.</p>\n" +
         html_table({{"participant"},
                     {"artifact"},
                     {"answers", true},
                     {"right", true},
                     {threshold_title(axis), true},
                     {"verdict"}},
                    lines);
}

}  // namespace

std::string psychometric_html(const Analysis& analysis, const ReportNumbers& numbers,
                              const std::vector<Figure>& figures) {
  std::string html = "<h2 id=\"psychometric\">Psychometric functions</h2>\n", missing;
  bool fitted = false;
  for (const ChoiceCurve& curve : numbers.choices) {
    fitted = fitted || curve.pooled;
    if (!curve.missing.empty()) missing += html_paragraph(curve.missing);
  }
  html += missing;
  if (fitted)
    html +=
        "<p>" + what_is_counted(analysis) +
        ": the share of right choices falls from 1 less the lapse rate to chance, " + chance_text(numbers) +
        ", " +
        (of_depth_widths(numbers.axis)
             ? std::string("as maps grow finer")
             : fmt::format("as the {} {}", facts(numbers.axis.quantity).name,
                           numbers.axis.noticeability == Direction::increasing ? "falls" : "rises")) +
        ".</p>\n" + figure_html(figures, "psychometric") + fits_table(numbers) +
        "<p class=\"soft\">Threshold: the " + level_word(numbers.axis) +
        " at which the function, before guess and lapse, is 0.5, "
        "which is a share of right choices near " +
        half_way_text(numbers) +
        ". It is not PT, which is about ratings. Width: the "
        "distance between 0.05 and 0.95 of the function. 95 % intervals over participants in brackets. "
        "The p of the deviance takes answers as independent, which one person’s are not: a small one says "
        "that the curve’s shape or the people differ from the model.</p>\n" +
        warnings_list(numbers);
  return html + own_html(own_thresholds(analysis), numbers.axis) + staircases_html(analysis, numbers.axis) +
         tracks_html(numbers) + detection_html(numbers);
}

}  // namespace seamline::analysis
