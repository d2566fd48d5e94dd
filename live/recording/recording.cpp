#include "live/recording/recording.h"

#include <fmt/format.h>

#include <cmath>

#include "registration/files/pose_table.h"
#include "sensors/rig/rig.h"
#include "stimuli/study_file/study_file_light.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/toml_table.h"
#include "support/text/limits.h"

namespace seamline::live {
namespace {

constexpr const char* format_text = "seamline recording 1";
constexpr NumberRange any_time_s{0, 1e9, "s"};

/// Whose files lie in the folder, as they are written.
std::string file_at(const TomlTable& table, const std::string& key, const std::string& fallback = {}) {
  const std::string name = fallback.empty() ? table.text(key) : table.text(key, fallback);
  if (!is_written_below(name))
    throw table.complaint(key, "a file of the recording's folder", "\"" + name + "\"");
  return name;
}

RecordedFrame read_frame(const TomlTable& table, const std::filesystem::path& path) {
  RecordedFrame frame;
  if (!table.has("time_s")) throw table.missing("time_s", range_text("a number", any_time_s));
  frame.time_s = table.number("time_s", 0, any_time_s);
  frame.depth_file = file_at(table, "depth");
  frame.colour_file = file_at(table, "colour");
  if (const auto pose = table.table("world_from_colour")) {
    frame.world_from_colour = registration::read_pose(*pose);
    sensors::require_rigid(*frame.world_from_colour,
                           path.string() + ": " + table.field("world_from_colour.rotation"));
  }
  table.finish();
  return frame;
}

/// Keys that `read_light` knows, and a recording has no use for.
void refuse_keys_of_studies(const TomlTable& table) {
  for (const char* key : {"materials", "object_metallic", "object_roughness", "ambient_occlusion",
                          "ao_distance_m", "sun_radius_deg", "bounces", "albedo"})
    if (table.has(key))
      throw table.complaint(key, "suns, lamps, an environment or exposure_ev", "a key of studies");
}

void read_light_of(const TomlTable& table, const std::filesystem::path& path, Recording& recording) {
  refuse_keys_of_studies(table);
  for (const char* key : {"environment", "environment_radiance", "suns", "lamps"})
    recording.has_light = recording.has_light || table.has(key);
  recording.light.environment_radiance = {0, 0, 0};
  recording.light.suns.emplace();
  recording.light.lamps.emplace();
  read_light(table, {.study_file = path}, AssetCheck::must_exist, recording.light);
}

Recording recording_of(const TomlTable& table, const std::filesystem::path& path) {
  const std::string format = table.text("format");
  if (format != format_text)
    throw table.complaint("format", fmt::format("\"{}\"", format_text), "\"" + format + "\"");
  Recording recording{.folder = path.parent_path()};
  recording.camera_file = file_at(table, "camera", recording.camera_file);
  const std::array<double, 3> up = table.triple("up", {0, 1, 0}, {-1e6, 1e6});
  recording.up = {up[0], up[1], up[2]};
  if (!(recording.up.norm() > 1e-6)) throw table.complaint("up", "a direction that is not zero", "none");
  if (recording.up.norm() != 1) recording.up.normalize();
  read_light_of(table, path, recording);
  const std::vector<TomlTable> frames = table.tables("frame");
  if (frames.empty() || frames.size() > most_recorded_frames)
    throw table.complaint("frame", fmt::format("1 to {} tables [[frame]]", most_recorded_frames),
                          std::to_string(frames.size()));
  for (const TomlTable& frame : frames) {
    recording.frames.push_back(read_frame(frame, path));
    const std::size_t count = recording.frames.size();
    if (count > 1 && recording.frames[count - 1].time_s < recording.frames[count - 2].time_s)
      throw frame.complaint("time_s", "a time that is not before the frame before",
                            fmt::format("{}", recording.frames[count - 1].time_s));
  }
  table.finish();
  return recording;
}

template <class Values>
std::string numbers_text(const Values& v) {
  return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]);
}

std::string quoted(const std::string& from) {
  std::string out = "\"";
  for (const char letter : from) {
    if (letter == '"' || letter == '\\') out += '\\';
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(letter));
    else
      out += letter;
  }
  return out + "\"";
}

std::string light_text(const SceneDefinition& light) {
  std::string text;
  if (light.environment)
    text += fmt::format("environment = {}\nenvironment_rotation_deg = {}\nenvironment_strength = {}\n",
                        quoted(light.environment->file), light.environment->rotation_deg,
                        light.environment->strength);
  else
    text += "environment_radiance = " + numbers_text(light.environment_radiance) + "\n";
  return text;
}

std::string lamps_text(const SceneDefinition& light) {
  std::string text;
  for (const SunDefinition& sun : light.suns.value_or(std::vector<SunDefinition>{}))
    text += fmt::format("\n[[suns]]\nto_sun = {}\nirradiance_w_m2 = {}\nangular_radius_deg = {}\n",
                        numbers_text(sun.to_sun), numbers_text(sun.irradiance_w_m2), sun.angular_radius_deg);
  for (const LampDefinition& lamp : light.lamps.value_or(std::vector<LampDefinition>{})) {
    text += fmt::format("\n[[lamps]]\nposition_m = {}\nintensity_w_sr = {}\n", numbers_text(lamp.position_m),
                        numbers_text(lamp.intensity_w_sr));
    if (lamp.is_spot)
      text += fmt::format("shines_along = {}\ninner_deg = {}\nouter_deg = {}\n",
                          numbers_text(lamp.shines_along), lamp.inner_deg, lamp.outer_deg);
  }
  return text;
}

}  // namespace

Recording read_recording(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / recording_index;
  if (!std::filesystem::is_regular_file(path))
    throw input_error({.file = folder.string(),
                       .wanted = std::string("a folder with ") + recording_index,
                       .found = "none there"});
  return parse_recording(read_file(path, limits::largest_text_file_bytes), path);
}

Recording parse_recording(const std::string& text, const std::filesystem::path& path) {
  return recording_of(TomlTable::parse(text, path), path);
}

std::string recording_text(const Recording& recording) {
  std::string text =
      fmt::format("format = \"{}\"\ncamera = {}\nup = {}\nexposure_ev = {}\n", format_text,
                  quoted(recording.camera_file), numbers_text(recording.up), recording.light.exposure_ev);
  if (recording.has_light) text += light_text(recording.light) + lamps_text(recording.light);
  for (const RecordedFrame& frame : recording.frames) {
    text += fmt::format("\n[[frame]]\ntime_s = {}\ndepth = {}\ncolour = {}\n", frame.time_s,
                        quoted(frame.depth_file), quoted(frame.colour_file));
    if (frame.world_from_colour)
      text += registration::pose_text("frame.world_from_colour", *frame.world_from_colour);
  }
  return text;
}

registration::RegistrationRig recording_rig(const Recording& recording) {
  const std::filesystem::path path = path_below(
      recording.folder, recording.camera_file,
      {.file = (recording.folder / recording_index).string(), .field = "camera", .wanted = {}, .found = {}});
  return registration::registration_rig(registration::read_camera_file(path), path.string());
}

}  // namespace seamline::live
