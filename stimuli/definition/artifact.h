#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace seamline::inline stimuli {

/// Which seam of the composition a stimulus shows, alone (paper section 3.3). A closed set without data:
/// switches over it have no default branch, so the compiler finds the place where a new one is forgotten.
enum class Artifact {
  receiver,    ///< type 1: real objects receive the virtual shadow
  shadow,      ///< type 2: the virtual object receives real shadows
  occlusion,   ///< type 3: the real world hides the virtual object
  overlap,     ///< type 4: real and virtual shadow overlap
  bounce,      ///< reserved: bounce light alone
  reflection,  ///< reserved: what is mirrored in the virtual object
  all,         ///< reserved: everything from the depth mesh
  none         ///< reserved: everything from the truth; equals the reference
};

inline constexpr std::array<Artifact, 8> every_artifact = {
    Artifact::receiver, Artifact::shadow,     Artifact::occlusion, Artifact::overlap,
    Artifact::bounce,   Artifact::reflection, Artifact::all,       Artifact::none};
/// The four that the paper studied, in its order of types 1 to 4.
inline constexpr std::array<Artifact, 4> paper_artifacts = {Artifact::receiver, Artifact::shadow,
                                                            Artifact::occlusion, Artifact::overlap};

/// The word used in study files, ids and reports, e.g. "receiver".
[[nodiscard]] std::string_view word(Artifact artifact);
[[nodiscard]] std::optional<Artifact> artifact_from_word(std::string_view text);

/// How one artifact is kept apart from the others.
enum class Isolation {
  query,  ///< each question that light asks is answered by the truth or by the depth mesh
  mask  ///< everything from the depth mesh, then layers are exchanged with the reference (what the paper did)
};

[[nodiscard]] std::string_view word(Isolation isolation);
[[nodiscard]] std::optional<Isolation> isolation_from_word(std::string_view text);

}  // namespace seamline::inline stimuli
