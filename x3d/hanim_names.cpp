#include "x3d/hanim_names.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace seamline::renderer {
namespace {

struct NamedJoint {
  std::string_view joint, segment;        ///< of HAnim, without side
  std::array<std::string_view, 5> words;  ///< without side, signs and capitals
  bool has_side = true;
};

constexpr std::array<NamedJoint, 9> named_joints = {{
    {"hip", "thigh", {"hip", "upleg", "thigh", "upperleg"}},
    {"knee", "calf", {"knee", "leg", "shin", "calf", "lowerleg"}},
    {"talocrural", "talus", {"ankle", "foot", "talocrural"}},
    {"shoulder", "upperarm", {"shoulder", "arm", "upperarm"}},
    {"elbow", "forearm", {"elbow", "forearm", "lowerarm"}},
    {"radiocarpal", "carpal", {"hand", "wrist", "radiocarpal"}},
    {"humanoid_root", "sacrum", {"hips", "pelvis", "humanoidroot"}, false},
    {"vl5", "l5", {"spine", "vl5"}, false},
    {"skullbase", "skull", {"head", "skullbase"}, false},
}};

/// A name's letters, small, without what tools put before it; and its side.
struct Words {
  std::string core;
  char side = 0;  ///< l, r, or 0
};

Words words_of(std::string_view node) {
  if (const std::size_t colon = node.rfind(':'); colon != std::string_view::npos)
    node.remove_prefix(colon + 1);
  std::string small;
  for (const char letter : node)
    small += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  const auto is_sign = [](char letter) {
    return letter == '_' || letter == '.' || letter == '-' || letter == ' ';
  };
  Words words;
  for (const auto& [word, side] : {std::pair{"left", 'l'}, {"right", 'r'}})
    if (const std::size_t at = small.find(word); at != std::string::npos && words.side == 0) {
      words.side = side;
      small.erase(at, std::string_view(word).size());
    }
  for (const char side : {'l', 'r'})
    if (words.side == 0 && small.size() > 2) {
      if (small[0] == side && is_sign(small[1]))
        words.side = side, small.erase(0, 2);
      else if (small.back() == side && is_sign(small[small.size() - 2]))
        words.side = side, small.resize(small.size() - 2);
    }
  for (const char letter : small)
    if (!is_sign(letter)) words.core += letter;
  return words;
}

/// As X3D takes names: no other letters, no digit or sign first.
std::string own_name(const std::string& node) {
  std::string name;
  for (const char letter : node) {
    const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    const bool is_kept = is_letter || (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    if (name.empty() && !is_letter) name += "joint_";
    name += is_kept ? letter : '_';
  }
  return name.empty() ? "joint" : name;
}

}  // namespace

std::string hanim_joint(std::string_view node) {
  const Words words = words_of(node);
  for (const NamedJoint& one : named_joints)
    if (one.has_side == (words.side != 0) && !words.core.empty() &&
        std::find(one.words.begin(), one.words.end(), words.core) != one.words.end())
      return (one.has_side ? std::string{words.side, '_'} : std::string{}) + std::string(one.joint);
  return {};
}

std::vector<std::string> hanim_joints(const std::vector<std::string>& nodes) {
  // A shoulder beside an arm of the same side is the collar bone, which only the file names.
  std::set<std::string> arms;
  for (const std::string& node : nodes)
    if (const Words words = words_of(node); words.core == "arm" || words.core == "upperarm")
      arms.insert({words.side});
  std::vector<std::string> names;
  std::set<std::string> taken;
  std::map<std::string, int> last;  ///< number behind a name
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Words words = words_of(nodes[i]);
    std::string name = i == 0 ? "humanoid_root" : hanim_joint(nodes[i]);
    if (words.core == "shoulder" && arms.contains({words.side})) name.clear();
    if (name.empty() || taken.contains(name)) name = own_name(nodes[i]);
    const std::string first = name;
    while (!taken.insert(name).second)
      name = fmt::format("{}_{}", first, ++last.try_emplace(first, 1).first->second);
    names.push_back(name);
  }
  return names;
}

std::string hanim_segment(std::string_view joint) {
  const bool has_side = joint.starts_with("l_") || joint.starts_with("r_");
  for (const NamedJoint& one : named_joints)
    if (one.has_side == has_side && joint.substr(has_side ? 2 : 0) == one.joint)
      return std::string(joint.substr(0, has_side ? 2 : 0)) + std::string(one.segment);
  return {};
}

}  // namespace seamline::renderer
