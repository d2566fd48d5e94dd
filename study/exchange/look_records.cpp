#include "study/exchange/look_records.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "stimuli/study_file/study_file.h"
#include "study/log/log_database.h"
#include "study/log/log_values.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace {

constexpr double rad = std::numbers::pi / 180;

/// -180 to 180.
double turn_deg(double from_deg, double to_deg) {
  return std::remainder(to_deg - from_deg, 360.0);
}

double angle_between_deg(const Pose& a, const Pose& b) {
  const double cosine =
      std::sin(a.pitch_deg * rad) * std::sin(b.pitch_deg * rad) +
      std::cos(a.pitch_deg * rad) * std::cos(b.pitch_deg * rad) * std::cos((a.yaw_deg - b.yaw_deg) * rad);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) / rad;
}

double yaw_of_deg(const Eigen::Vector3d& ahead) {
  return std::atan2(ahead.x(), -ahead.z()) / rad;
}

std::vector<LookedTrial> looks_in(SQLite::Database& database, const std::filesystem::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT participants.code, events.trial_index, events.detail
      FROM events JOIN sessions USING (session) JOIN participants USING (participant)
      JOIN answers ON answers.session = events.session AND answers.trial_index = events.trial_index
      WHERE events.kind = 'look' ORDER BY participants.participant, events.trial_index, events.event)sql");
  const LogValues values(row, file, "events");
  std::vector<LookedTrial> looks;
  while (row.executeStep()) {
    LookedTrial one{.participant = values.code(0), .trial_index = values.number(1, 0), .poses = {}};
    const std::string text = row.getColumn(2).getString();
    const auto poses = poses_of(text);
    if (!poses)
      throw input_error({.file = file.string(),
                         .field = "events.detail",
                         .wanted = "poses as \"MS YAW PITCH;...\" in an event \"look\"",
                         .found = "\"" + printable(text, 40) + "\""});
    if (looks.empty() || looks.back().participant != one.participant ||
        looks.back().trial_index != one.trial_index)
      looks.push_back(std::move(one));
    looks.back().poses.insert(looks.back().poses.end(), poses->begin(), poses->end());
  }
  return looks;
}

/// "3 28": the answer, and the trials before it.
ComfortAnswer comfort_of(const std::string& participant, const std::string& text,
                         const std::filesystem::path& file) {
  ComfortAnswer one{.participant = participant};
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, one.comfort);
  const bool begun = first.ec == std::errc() && first.ptr != end && *first.ptr == ' ';
  const auto second = begun ? std::from_chars(first.ptr + 1, end, one.answered) : first;
  if (begun && second.ec == std::errc() && second.ptr == end && one.comfort >= 1 && one.comfort <= 5 &&
      one.answered >= 0)
    return one;
  throw input_error({.file = file.string(),
                     .field = "events.detail",
                     .wanted = "an answer from 1 to 5 and a number of trials in an event \"comfort\"",
                     .found = "\"" + printable(text, 40) + "\""});
}

std::vector<ComfortAnswer> comfort_in(SQLite::Database& database, const std::filesystem::path& file) {
  SQLite::Statement row(database, R"sql(
      SELECT participants.code, events.detail
      FROM events JOIN sessions USING (session) JOIN participants USING (participant)
      WHERE events.kind = 'comfort' ORDER BY participants.participant, events.event)sql");
  const LogValues values(row, file, "events");
  std::vector<ComfortAnswer> answers;
  while (row.executeStep()) answers.push_back(comfort_of(values.code(0), row.getColumn(1).getString(), file));
  return answers;
}

}  // namespace

std::vector<ComfortAnswer> read_comfort(const LogContents& log) {
  if (log.study_text.find("comfort_question") == std::string::npos) return {};
  return with_log_errors(log.file, [&] {
    SQLite::Database database = open_log_database(log.file, LogAccess::read);
    return comfort_in(database, log.file);
  });
}

std::vector<LookedTrial> read_looks(const LogContents& log) {
  if (log.study_text.find("panorama") == std::string::npos) return {};
  if (!is_panorama(read_study_text(log.study_text, log.file))) return {};
  return with_log_errors(log.file, [&] {
    SQLite::Database database = open_log_database(log.file, LogAccess::read);
    return looks_in(database, log.file);
  });
}

LookMeasures measure_look(const std::vector<PoseAt>& poses, double object_yaw_deg, double end_ms) {
  LookMeasures out;
  double facing_ms = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) out.degrees_turned += angle_between_deg(poses[i - 1].pose, poses[i].pose);
    if (std::abs(turn_deg(object_yaw_deg, poses[i].pose.yaw_deg)) > facing_deg) continue;
    if (!out.first_look_s) out.first_look_s = 1e-3 * poses[i].ms;
    const double until_ms = i + 1 < poses.size() ? poses[i + 1].ms : end_ms;
    facing_ms += std::max(0.0, std::min(until_ms, end_ms) - poses[i].ms);
  }
  if (end_ms > 0) out.share_facing = facing_ms / end_ms;
  return out;
}

std::vector<MeasuredLook> measured_looks(const LogContents& log, const std::vector<LookedTrial>& looks) {
  std::vector<MeasuredLook> measured;
  if (looks.empty()) return measured;
  std::map<std::pair<std::string, std::string>, double> yaws;  // by scene and object
  for (const SceneDefinition& scene : read_study_text(log.study_text, log.file).scenes)
    for (const ObjectDefinition& object : scene.objects)
      yaws[{scene.name, object.name}] = object_yaw_deg(scene, object);
  std::map<std::pair<std::string, int>, const LookedTrial*> of_trial;
  for (const LookedTrial& one : looks) of_trial[{one.participant, one.trial_index}] = &one;
  for (std::size_t i = 0; i < log.answers.size(); ++i) {
    const Answer& answer = log.answers[i];
    const auto found = of_trial.find({answer.participant, answer.trial_index});
    const auto yaw = yaws.find({answer.scene, answer.object});
    if (found == of_trial.end() || yaw == yaws.end()) continue;
    const double end_ms = 1e-6 * answer.rating_ns;
    measured.push_back({i, yaw->second, measure_look(found->second->poses, yaw->second, end_ms)});
  }
  return measured;
}

double object_yaw_deg(const SceneDefinition& scene, const ObjectDefinition& object) {
  if (!scene.camera) return 0;
  return turn_deg(yaw_of_deg(scene.camera->look_at_m - scene.camera->position_m),
                  yaw_of_deg(object.position_m - scene.camera->position_m));
}

}  // namespace seamline::study
