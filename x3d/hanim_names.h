#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace seamline::renderer {

/// The joint of HAnim 2.0 (ISO/IEC 19774, level of articulation 1) that a node's name says, in the words of
/// common tools: `left_elbow`, `LeftForeArm`, `mixamorig:LeftForeArm`, `forearm.L`; empty: none.
[[nodiscard]] std::string hanim_joint(std::string_view node);

/// Names of the joints of one figure, the first of which is the root: HAnim's where a node says one that no
/// node before it says, else the node's own, as X3D takes names. All differ.
[[nodiscard]] std::vector<std::string> hanim_joints(const std::vector<std::string>& nodes);

/// The segment that a joint of HAnim moves; empty for others.
[[nodiscard]] std::string hanim_segment(std::string_view joint);

}  // namespace seamline::renderer
