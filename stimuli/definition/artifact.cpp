#include "stimuli/definition/artifact.h"

namespace seamline::inline stimuli {

std::string_view word(Artifact artifact) {
  switch (artifact) {
    case Artifact::receiver:
      return "receiver";
    case Artifact::shadow:
      return "shadow";
    case Artifact::occlusion:
      return "occlusion";
    case Artifact::overlap:
      return "overlap";
    case Artifact::bounce:
      return "bounce";
    case Artifact::reflection:
      return "reflection";
    case Artifact::all:
      return "all";
    case Artifact::none:
      return "none";
  }
  return {};
}

std::optional<Artifact> artifact_from_word(std::string_view text) {
  for (const Artifact artifact : every_artifact)
    if (word(artifact) == text) return artifact;
  return std::nullopt;
}

std::optional<Isolation> isolation_from_word(std::string_view text) {
  for (const Isolation isolation : {Isolation::query, Isolation::mask})
    if (word(isolation) == text) return isolation;
  return std::nullopt;
}

}  // namespace seamline::inline stimuli
