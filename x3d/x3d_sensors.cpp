#include "x3d/x3d_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/arithmetic/grid_index.h"
#include "support/text/html.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

using sensors::DepthFrame;

struct ProtoField {
  const char* access;
  const char* type;
  const char* name;
  const char* value;  ///< of the declaration; null: none, which X3DOM does not take of texts
  std::string recorded;
};

std::string prototype(const char* name, const std::vector<ProtoField>& fields) {
  std::string text = fmt::format("<ProtoDeclare name=\"{}\"><ProtoInterface>\n", name);
  for (const ProtoField& field : fields) {
    text +=
        fmt::format("<field accessType=\"{}\" type=\"{}\" name=\"{}\"", field.access, field.type, field.name);
    if (field.value != nullptr) text += fmt::format(" value=\"{}\"", field.value);
    text += "></field>\n";
  }
  text += fmt::format(
      "</ProtoInterface><ProtoBody><Group></Group></ProtoBody></ProtoDeclare>\n"
      "<ProtoInstance name=\"{0}\" DEF=\"recorded_{0}\">\n",
      name);
  for (const ProtoField& field : fields)
    text += fmt::format("<fieldValue name=\"{}\" value=\"{}\"></fieldValue>\n", field.name, field.recorded);
  return text + "</ProtoInstance>\n";
}

/// An SFImage: size, components, and a number for each pixel, the lowest row first.
template <class PixelValue>
std::string image_text(int width_px, int height_px, int components, PixelValue value) {
  std::string text = fmt::format("{} {} {}", width_px, height_px, components);
  for (int row = height_px - 1; row >= 0; --row)
    for (int column = 0; column < width_px; ++column)
      fmt::format_to(std::back_inserter(text), " 0x{:X}", value(grid_index(row, column, width_px)));
  return text;
}

std::uint32_t millimetres(float planar_m) {
  if (DepthFrame::is_hole(planar_m)) return 0;
  return static_cast<std::uint32_t>(std::clamp(std::round(1000.0 * planar_m), 1.0, 65535.0));
}

std::vector<ProtoField> depth_sensor(const X3dRecording& recording) {
  const DepthFrame& frame = recording.depth;
  const int width_px = frame.camera.width_px, height_px = frame.camera.height_px;
  return {{"outputOnly", "SFImage", "depthImage", nullptr,
           image_text(width_px, height_px, 2, [&](std::size_t i) { return millimetres(frame.depth_m[i]); })},
          {"inputOutput", "SFInt32", "width", "640", fmt::format("{}", width_px)},
          {"inputOutput", "SFInt32", "height", "480", fmt::format("{}", height_px)},
          {"inputOutput", "SFInt32", "fps", "30", "0"},
          {"inputOutput", "SFBool", "normalizeDepth", "true", "false"},
          {"initializeOnly", "SFString", "label", "", html_escape(recording.label)}};
}

std::vector<ProtoField> ni_sensor(const X3dRecording& recording) {
  std::vector<ProtoField> fields = depth_sensor(recording);
  const ByteImage& colour = recording.colour;
  fields.push_back({"outputOnly", "SFImage", "colorImage", nullptr,
                    image_text(colour.width_px, colour.height_px, 3, [&](std::size_t i) {
                      const std::uint8_t* code = &colour.values[3 * i];
                      return (std::uint32_t{code[0]} << 16U) | (std::uint32_t{code[1]} << 8U) | code[2];
                    })});
  fields.push_back({"inputOutput", "SFBool", "alignViewports", "true", "true"});
  fields.push_back({"outputOnly", "MFInt32", "users", nullptr,
                    recording.user != nullptr ? fmt::format("{}", recording.user->id) : ""});
  return fields;
}

std::vector<ProtoField> user_sensor(const X3dRecording& recording) {
  const X3dUser& user = *recording.user;
  std::string positions, orientations;
  for (std::size_t i = 0; i < user.joints_m.size(); ++i) {
    if (!user.joints_m[i]) continue;
    const Eigen::AngleAxisd& turn = user.orientations[i];
    positions += (positions.empty() ? "" : ", ") + field_text(*user.joints_m[i]);
    orientations +=
        (orientations.empty() ? "" : ", ") + field_text(turn.axis()) + " " + field_text(turn.angle());
  }
  return {{"inputOutput", "SFInt32", "userID", "0", fmt::format("{}", user.id)},
          {"outputOnly", "SFImage", "userMask", nullptr,
           image_text(recording.depth.camera.width_px, recording.depth.camera.height_px, 1,
                      [&](std::size_t i) { return user.mask[i] != 0 ? 255U : 0U; })},
          {"outputOnly", "MFVec3f", "jointPositions", nullptr, positions},
          {"outputOnly", "MFRotation", "jointOrientations", nullptr, orientations},
          {"outputOnly", "SFString", "gesture", "", ""}};
}

}  // namespace

X3dUser x3d_user(const sensors::RecordedUser& user, const DepthFrame& frame,
                 const Eigen::Isometry3d& world_from_frame, const Eigen::Isometry3d& x3d_from_world) {
  X3dUser seen{.id = user.id,
               .mask = sensors::mask_of_user(frame, world_from_frame, user),
               .joints_m = user.joints_m,
               .orientations = {}};
  const sensors::Skeleton skeleton = sensors::with_bones_of(sensors::standing_person(), user.joints_m);
  const sensors::FittedPose fitted = sensors::fit_standing_pose(skeleton, user.joints_m);
  seen.rms_m = fitted.rms_m;
  for (const sensors::PlacedJoint& joint : sensors::place_joints(skeleton, fitted.pose))
    seen.orientations.emplace_back(Eigen::Matrix3d(x3d_from_world.linear() * joint.orientation));
  for (auto& place_m : seen.joints_m)
    if (place_m) place_m = x3d_from_world * *place_m;
  return seen;
}

std::string sensor_prototypes(const X3dRecording& recording) {
  std::string text =
      prototype("DepthSensor", depth_sensor(recording)) + prototype("NISensor", ni_sensor(recording));
  if (recording.user != nullptr) text += prototype("UserSensor", user_sensor(recording));
  return text;
}

}  // namespace seamline::renderer
