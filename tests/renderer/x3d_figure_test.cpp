// HAnim joints carry a figure's vertices where glTF's own rule for skins has them, at every key and between
// keys.
#include "x3d/x3d_figure.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "raytracer/scene/scene_moment.h"
#include "raytracer/scene/truth_scene.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "tests/renderer/gltf_bytes.h"
#include "x3d/hanim_names.h"
#include "x3d/x3d_humanoid.h"

namespace seamline::renderer {
namespace {

using test::bytes_of;
using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// An arm in centimetres below a stand that makes metres of them: a skin between shoulder and elbow, whose
/// axes are turned, and a hand of its own mesh, which is stretched while it moves.
class X3dArm : public testing::Test {
 protected:
  void add(const std::string& bytes, int component_type, const char* type, int count) {
    const char* comma = accessors_.empty() ? "" : ",";
    views_ += fmt::format(R"({}{{"buffer":0,"byteOffset":{},"byteLength":{}}})", comma, buffer_.size(),
                          bytes.size());
    accessors_ += fmt::format(R"({}{{"bufferView":{},"componentType":{},"type":"{}","count":{}}})", comma,
                              number_++, component_type, type, count);
    buffer_ += bytes;
    buffer_.resize((buffer_.size() + 3) / 4 * 4, '\0');
  }

  /// `by`: interpolation of the turns. `names`: of shoulder, elbow and hand.
  std::filesystem::path arm(const std::string& skin, const std::string& by = "LINEAR",
                            const std::array<const char*, 3>& names = {"LeftArm", "LeftForeArm",
                                                                       "LeftHand"}) {
    add(bytes_of<float>({0, 0, 0, 30, 0, 0, 60, 5, 0}), 5126, "VEC3", 3);
    add(bytes_of<float>({0, 0, 1, 0, 0, 1, 0, 0.6F, 0.8F}), 5126, "VEC3", 3);
    add(bytes_of<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}), 5121, "VEC4", 3);
    add(bytes_of<float>({1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0}), 5126, "VEC4", 3);
    // The shoulder is bound where it rests; the elbow, 30 cm on, was bound half a turn about X away from it.
    add(bytes_of<float>({1, 0, 0, 0, 0, 1,  0, 0, 0, 0, 1,  0, 0,   0, 0, 1,
                         1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, -30, 0, 0, 1}),
        5126, "MAT4", 2);
    add(bytes_of<float>({0.5F, 1, 2}), 5126, "SCALAR", 3);
    add(bytes_of<float>({0, 0, 0, 1, 0.6F, 0, 0, 0.8F, 0, 0.8F, 0, -0.6F}), 5126, "VEC4", 3);
    add(bytes_of<float>({0, 0, 0, 5, 0, 1, 0, 7, 2}), 5126, "VEC3", 3);
    add(bytes_of<float>({1, 1, 1, 1, 2, 1, 1.5F, 1, 0.5F}), 5126, "VEC3", 3);
    const std::string text = fmt::format(
        R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{},"uri":"arm.bin"}}],"bufferViews":[{}],)"
        R"("accessors":[{}],"scenes":[{{"nodes":[0,4]}}],"nodes":[)"
        R"({{"name":"stand","scale":[0.01,0.01,0.01],"translation":[1,2,3],"rotation":[0,0.6,0,0.8],"children":[1]}},)"
        R"({{"name":"{}","children":[2]}},{{"name":"{}","translation":[30,0,0],"rotation":[0,0,0.6,0.8],"children":[3]}},)"
        R"({{"name":"{}","translation":[28,1,0],"mesh":0}},{{"mesh":1{}}}],{})"
        R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}},{{"primitives":[{{"attributes":{{"POSITION":0,)"
        R"("NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3}}}}]}}],"animations":[{{"name":"Wave","channels":[)"
        R"({{"sampler":0,"target":{{"node":1,"path":"rotation"}}}},{{"sampler":0,"target":{{"node":2,"path":"rotation"}}}},)"
        R"({{"sampler":1,"target":{{"node":1,"path":"translation"}}}},{{"sampler":2,"target":{{"node":3,"path":"scale"}}}}],)"
        R"("samplers":[{{"input":5,"output":6,"interpolation":"{}"}},{{"input":5,"output":7}},{{"input":5,"output":8}}]}}]}})",
        buffer_.size(), views_, accessors_, names[0], names[1], names[2], skin.empty() ? "" : R"(,"skin":0)",
        skin, by);
    write_file_atomically(folder_ / "arm.bin", buffer_);
    write_file_atomically(folder_ / "arm.gltf", text);
    return folder_ / "arm.gltf";
  }

  /// The same file with another text in a place of it.
  static void edit(const std::filesystem::path& file, const std::string& from, const std::string& to) {
    std::string text = read_file(file);
    ASSERT_NE(text.find(from), std::string::npos) << from;
    write_file_atomically(file, text.replace(text.find(from), from.size(), to));
  }
  /// Nodes behind those of the arm, which no scene shows.
  static void add_nodes(const std::filesystem::path& file, const std::string& nodes) {
    edit(file, R"({"mesh":1,"skin":0})", R"({"mesh":1,"skin":0},)" + nodes);
  }

  [[nodiscard]] static FigureRead read(const std::filesystem::path& file) {
    return read_figure(
        {.path = file, .is_joint = [](std::string_view name) { return !hanim_joint(name).empty(); }});
  }

  /// The subject of a page: a camera that looks about, and the arm turned and half as large.
  [[nodiscard]] static X3dSubject subject_of(const std::filesystem::path& file, SceneFigure figure) {
    X3dSubject subject;
    subject.camera_position_m = {0.5, 1, 2};
    subject.camera.axes = Eigen::AngleAxisf(0.7F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
    Eigen::Affine3d x3d_from_world = Eigen::Affine3d::Identity();
    x3d_from_world.linear() = subject.camera.axes.transpose().cast<double>();
    x3d_from_world.translate(-subject.camera_position_m);
    subject.x3d_from_figure = x3d_from_world * placement();
    subject.figure = std::move(figure);
    subject.objects = place_meshes(read_scene_file(file), placement(), subject.camera_position_m, 0.5, 1);
    return subject;
  }

  [[nodiscard]] static Eigen::Affine3d placement() {
    return object_placement({.name = {},
                             .file = {},
                             .path = {},
                             .position_m = {1, 0, -3},
                             .rotation_deg = {10, 20, 30},
                             .scale = 0.5});
  }

  TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
  std::string buffer_, views_, accessors_;
  int number_ = 0;
};

constexpr const char* arm_skin = R"("skins":[{"joints":[1,2],"inverseBindMatrices":4}],)";

std::vector<std::vector<float>> all_open(const X3dSubject& subject) {
  std::vector<std::vector<float>> open;
  for (const auto& mesh : subject.objects) open.emplace_back(mesh->positions_m.size(), 1.0F);
  return open;
}

X3dJointPose between(const X3dJoint& joint, const std::vector<double>& fractions, double fraction) {
  const auto after =
      std::upper_bound(fractions.begin() + 1, fractions.end() - 1, fraction) - fractions.begin();
  const X3dJointPose &from = joint.keys[static_cast<std::size_t>(after - 1)],
                     &to = joint.keys[static_cast<std::size_t>(after)];
  const double share =
      (fraction - fractions[static_cast<std::size_t>(after - 1)]) /
      (fractions[static_cast<std::size_t>(after)] - fractions[static_cast<std::size_t>(after - 1)]);
  return {.translation_m = from.translation_m + share * (to.translation_m - from.translation_m),
          .rotation = from.rotation.slerp(share, to.rotation),
          .scale = from.scale + share * (to.scale - from.scale)};
}

/// X3D 4.0, 10.4.4 (Transform) and 26.2.2 (skin), in its own words.
std::vector<Eigen::Vector3d> carried(const X3dFigure& figure, const std::vector<X3dJointPose>& places) {
  std::vector<Eigen::Affine3d> joints;
  for (std::size_t j = 0; j < figure.joints.size(); ++j) {
    const X3dJoint& joint = figure.joints[j];
    Eigen::Affine3d own = Eigen::Affine3d::Identity();
    own.translate(places[j].translation_m).translate(joint.centre_m).rotate(places[j].rotation);
    own.rotate(joint.scale_axes).scale(places[j].scale).rotate(joint.scale_axes.conjugate());
    own.translate(-joint.centre_m);
    joints.push_back(joint.parent < 0 ? own : joints[static_cast<std::size_t>(joint.parent)] * own);
  }
  std::vector<Eigen::Vector3d> out;
  for (std::size_t v = 0; v < figure.positions_m.size(); ++v) {
    out.emplace_back(0, 0, 0);
    for (const auto& [joint, weight] : figure.held_by[v])
      out.back() += weight * (joints[static_cast<std::size_t>(joint)] * figure.positions_m[v].cast<double>());
  }
  return out;
}

/// Largest distance from what `read_scene_moment` has at a time.
double off_m(const std::filesystem::path& file, const X3dSubject& subject, const X3dFigure& figure,
             double time_s, double fraction, const std::vector<PlacedNode>& nodes = {}) {
  std::vector<X3dJointPose> places;
  for (const X3dJoint& joint : figure.joints)
    places.push_back(fraction < 0 ? joint.place : between(joint, figure.fractions, fraction));
  const std::vector<Eigen::Vector3d> found = carried(figure, places);
  const SceneFile moment = fraction < 0
                               ? read_scene_file(file)
                               : read_scene_moment(file, MaterialModel::diffuse, Transparency::refused,
                                                   FileMoment{"Wave", time_s, true, nodes});
  double most_m = 0;
  std::size_t at = 0;
  for (const FileMesh& mesh : moment.meshes)
    for (const Eigen::Vector3d& vertex : mesh.positions_m)
      most_m = std::max(most_m, (subject.x3d_from_figure * vertex - found.at(at++)).norm());
  EXPECT_EQ(at, found.size());
  return most_m;
}

TEST_F(X3dArm, IsWhereItsSkinIsAtEveryTime) {
  for (const char* by : {"LINEAR", "STEP"}) {
    const auto file = arm(arm_skin, by);
    FigureRead read = X3dArm::read(file);
    ASSERT_TRUE(read.figure) << read.why_not;
    EXPECT_EQ(why_no_x3d_figure(*read.figure, Eigen::Affine3d::Identity()), "");
    const X3dSubject subject = subject_of(file, std::move(*read.figure));
    const X3dFigure figure = x3d_figure(subject, all_open(subject));
    EXPECT_DOUBLE_EQ(figure.cycle_s, 1.5);
    EXPECT_LT(off_m(file, subject, figure, 0, -1), 2e-6);
    for (const double fraction : {0.0, 1.0 / 3, 0.5, 0.62, 0.99, 1.0}) {
      // A step between two keys is a line of a sixtieth of a second.
      if (by == std::string("STEP") && (fraction == 1.0 / 3 || fraction > 0.98)) continue;
      EXPECT_LT(off_m(file, subject, figure, 0.5 + 1.5 * fraction, fraction), 2e-6) << by << " " << fraction;
    }
    buffer_.clear(), views_.clear(), accessors_.clear(), number_ = 0;
  }
}

TEST_F(X3dArm, WithoutSkinIsAFigureWhereItsNodesAreNamedAsJoints) {
  EXPECT_FALSE(X3dArm::read(arm("")).figure);  // three joints are not a person's
  buffer_.clear(), views_.clear(), accessors_.clear(), number_ = 0;
  const auto file = arm("", "LINEAR", {"spine", "LeftArm", "LeftForeArm"});
  std::string text = read_file(file);
  text.replace(text.find("\"stand\""), 7, "\"hips\"");
  write_file_atomically(file, text);
  FigureRead read = X3dArm::read(file);
  ASSERT_TRUE(read.figure) << read.why_not;
  const X3dSubject subject = subject_of(file, std::move(*read.figure));
  const X3dFigure figure = x3d_figure(subject, all_open(subject));
  for (const double fraction : {0.0, 0.4, 1.0})
    EXPECT_LT(off_m(file, subject, figure, 0.5 + 1.5 * fraction, fraction), 2e-6) << fraction;
}

TEST_F(X3dArm, SaysWhyItStandsStill) {
  const auto file = arm(arm_skin);
  std::string text = read_file(file);
  text.replace(text.find("[0.01,0.01,0.01]"), 16, "[0.01,0.02,0.01]");
  write_file_atomically(file, text);
  const FigureRead read = X3dArm::read(file);
  ASSERT_TRUE(read.figure);
  EXPECT_THAT(why_no_x3d_figure(*read.figure, Eigen::Affine3d::Identity()), HasSubstr("sheared"));
}

/// Nodes from 5 on, each below the one before, named as joints.
std::string chain(int count) {
  std::string nodes;
  for (int i = 0; i < count; ++i)
    nodes += fmt::format(R"({}{{"name":"{}"{}}})", i > 0 ? "," : "", i % 2 == 0 ? "head" : "left_knee",
                         i + 1 < count ? fmt::format(R"(,"children":[{}])", 6 + i) : "");
  return nodes;
}

TEST_F(X3dArm, HasAnEndWhereNoStepIsLeftBetweenTimes) {
  const auto file = arm(arm_skin, "STEP");
  edit(folder_ / "arm.bin", bytes_of<float>({0.5F, 1, 2}), bytes_of<float>({1e17F, 2e17F, 3e17F}));
  const FigureRead read = X3dArm::read(file);
  ASSERT_TRUE(read.figure) << read.why_not;
  EXPECT_LT(read.figure->times_s.size(), 216'003U);
}

TEST_F(X3dArm, HasNoJointsThatNoSceneShows) {
  const auto file = arm(arm_skin);
  const std::size_t joints = X3dArm::read(file).figure->joints.size();
  add_nodes(file, chain(2000));
  const FigureRead read = X3dArm::read(file);
  ASSERT_TRUE(read.figure) << read.why_not;
  EXPECT_EQ(read.figure->joints.size(), joints);
}

TEST_F(X3dArm, StandsStillWhereTheJointsOfItsSkinAreNoTree) {
  auto file = arm(arm_skin);
  add_nodes(file, chain(400));
  std::string all = "0";
  for (int node = 5; node < 405; ++node) all += "," + std::to_string(node);
  edit(file, R"("joints":[1,2],"inverseBindMatrices":4)", R"("joints":[)" + all + "]");
  FigureRead read = X3dArm::read(file);
  EXPECT_FALSE(read.figure);
  EXPECT_THAT(read.why_not, HasSubstr("nested too deep"));

  for (const char* joints : {R"("joints":[5,6])", R"("joints":[404])"}) {
    buffer_.clear(), views_.clear(), accessors_.clear(), number_ = 0;
    file = arm(arm_skin);
    add_nodes(file,
              std::string(joints).ends_with("6]") ? R"({"children":[6]},{"children":[5]})" : chain(400));
    edit(file, R"("joints":[1,2],"inverseBindMatrices":4)", joints);
    read = X3dArm::read(file);
    EXPECT_FALSE(read.figure);
    EXPECT_THAT(read.why_not, AnyOf(HasSubstr("no tree"), HasSubstr("nested too deep")));
  }
}

TEST_F(X3dArm, CarriesWhatIsFlatOrHangsOnAJointOfNoSize) {
  for (const char* elbow : {R"("children":[3,5])", R"("scale":[0,0,0],"children":[3,5])"}) {
    const auto file = arm(arm_skin);
    edit(file, R"("children":[3])", elbow);
    add_nodes(file, R"({"mesh":1,"scale":[1,1,0]})");
    FigureRead read = X3dArm::read(file);
    ASSERT_TRUE(read.figure) << read.why_not;
    EXPECT_EQ(why_no_x3d_figure(*read.figure, Eigen::Affine3d::Identity()), "");
    const X3dSubject subject = subject_of(file, std::move(*read.figure));
    const X3dFigure figure = x3d_figure(subject, all_open(subject));
    for (const Eigen::Vector3f& normal : figure.normals) EXPECT_TRUE(normal.allFinite());
    EXPECT_LT(off_m(file, subject, figure, 0, -1), 2e-6);
    EXPECT_LT(off_m(file, subject, figure, 1.25, 0.5), 2e-6);
    buffer_.clear(), views_.clear(), accessors_.clear(), number_ = 0;
  }
}

TEST_F(X3dArm, HangsOnItsFirstJointWithoutWeights) {
  const auto file = arm(arm_skin);
  edit(folder_ / "arm.bin", bytes_of<float>({1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0}),
       std::string(48, '\0'));
  edit(folder_ / "arm.bin", bytes_of<std::uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}),
       bytes_of<std::uint8_t>({0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
  FigureRead read = X3dArm::read(file);
  ASSERT_TRUE(read.figure) << read.why_not;
  const X3dSubject subject = subject_of(file, std::move(*read.figure));
  EXPECT_LT(off_m(file, subject, x3d_figure(subject, all_open(subject)), 1.25, 0.5), 2e-6);
  edit(file, R"(,"WEIGHTS_0":3)", "");
  EXPECT_THAT(X3dArm::read(file).why_not, HasSubstr("no weights"));
}

TEST_F(X3dArm, StandsStillWhereItsAnimationCannotBeRead) {
  const auto file = arm(arm_skin);
  edit(file, R"("output":6)", R"("output":60)");
  const FigureRead read = X3dArm::read(file);
  EXPECT_FALSE(read.figure);
  EXPECT_THAT(read.why_not, HasSubstr("animations[0]"));
}

TEST_F(X3dArm, MovesFromWhereItsNodesArePlaced) {
  const auto file = arm(arm_skin);
  const std::vector<PlacedNode> nodes = {{"LeftForeArm", {0, 9, 0}, {0, 0, 40}}};
  for (const bool is_animated : {false, true}) {
    FigureRead read = read_figure({.path = file, .moment = FileMoment{"Wave", 0.5, is_animated, nodes}});
    ASSERT_TRUE(read.figure) << read.why_not;
    ASSERT_EQ(why_no_x3d_figure(*read.figure, Eigen::Affine3d::Identity()), "");
    const X3dSubject subject = subject_of(file, std::move(*read.figure));
    const X3dFigure figure = x3d_figure(subject, all_open(subject));
    for (const double fraction : {0.0, 1.0 / 3, 1.0})
      EXPECT_LT(off_m(file, subject, figure, 0.5 + 1.5 * fraction, fraction, nodes), 2e-6) << fraction;
  }
}

TEST_F(X3dArm, PlaysTheAnimationThatTheMomentMeans) {
  const auto file = arm(arm_skin);
  edit(file, R"("animations":[{"name":"Wave")",
       R"("animations":[{"name":"1","channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}}],)"
       R"("samplers":[{"input":5,"output":6}]},{"name":"Wave")");
  const FigureRead read = read_figure({.path = file, .moment = FileMoment{"1", 1}});
  ASSERT_TRUE(read.figure) << read.why_not;
  EXPECT_EQ(read.figure->animation, "1");
}

TEST_F(X3dArm, IsWrittenAsAHumanoidWithRoutes) {
  const auto file = arm(arm_skin);
  const X3dSubject subject = subject_of(file, *X3dArm::read(file).figure);
  const auto open = all_open(subject);
  const X3dFrame frame;
  const ByteImage photograph;
  const std::string text =
      x3d_humanoid({.subject = subject, .frame = frame, .photograph = photograph, .openness = open},
                   [](std::size_t) { return std::string("<appearance></appearance>"); });
  for (const char* piece :
       {"<HAnimHumanoid id=\"figure\"", "name=\"l_elbow\"", "containerField=\"skeleton\"",
        "skinCoordWeight=\"1 0.5 \"", "<HAnimSegment DEF=\"segment_l_forearm\"",
        "<OrientationInterpolator DEF=\"rotation_l_elbow\"", "toNode=\"hanim_l_elbow\" toField=\"rotation\"",
        "toNode=\"hanim_l_radiocarpal\" toField=\"scale\""})
    EXPECT_THAT(text, HasSubstr(piece));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(HanimNames, AreTheJointsThatNodesSay) {
  EXPECT_EQ(hanim_joint("mixamorig:LeftForeArm"), "l_elbow");
  EXPECT_EQ(hanim_joint("right_knee"), "r_knee");
  EXPECT_EQ(hanim_joint("thigh.L"), "l_hip");
  EXPECT_EQ(hanim_joint("Head"), "skullbase");
  for (const char* none : {"", "left", "table_leg", "hand", "lamp_l", "spoon"})
    EXPECT_EQ(hanim_joint(none), "") << none;
  EXPECT_THAT(hanim_joints({"hips", "LeftShoulder", "LeftArm", "left_upper_arm", "7 of\"9"}),
              ElementsAre("humanoid_root", "LeftShoulder", "l_shoulder", "left_upper_arm", "joint_7_of_9"));
  EXPECT_THAT(hanim_joints({"", "", "right_shoulder"}), ElementsAre("humanoid_root", "joint", "r_shoulder"));
  EXPECT_THAT(hanim_joints({"", "a", "a", "a_2", "a"}),
              ElementsAre("humanoid_root", "a", "a_2", "a_2_2", "a_3"));
  EXPECT_EQ(hanim_segment("l_hip"), "l_thigh");
  EXPECT_EQ(hanim_segment("LeftShoulder"), "");
}

}  // namespace
}  // namespace seamline::renderer
