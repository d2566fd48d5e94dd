#include "renderer/transport/answers.h"

namespace seamline::renderer {
namespace {

constexpr Answers everything_from_depth{Who::depth, Who::depth, Who::depth,
                                        Who::depth, Who::depth, Who::depth};

Answers table(Artifact artifact) {
  switch (artifact) {
    case Artifact::receiver:
      return {.receiver = Who::depth};
    case Artifact::shadow:
      return {.object_lit = Who::depth};
    case Artifact::occlusion:
      return {.occlusion = Who::depth};
    case Artifact::overlap:
      return {.real_lit = Who::depth};
    case Artifact::bounce:
      return {.bounce = Who::depth};
    case Artifact::reflection:
      return {.mirrored = Who::depth};
    case Artifact::all:
      return everything_from_depth;
    case Artifact::none:
      return {};
  }
  return {};
}

Recipe mask_recipe(Artifact artifact) {
  switch (artifact) {
    case Artifact::receiver:
    case Artifact::occlusion:
    case Artifact::all:
      return {everything_from_depth, Keep::everything};
    case Artifact::shadow:
      return {everything_from_depth, Keep::object_only};
    case Artifact::overlap:
      return {everything_from_depth, Keep::all_but_object};
    case Artifact::bounce:
    case Artifact::reflection:
    case Artifact::none:
      return {table(artifact), Keep::everything};
  }
  return {};
}

}  // namespace

Recipe recipe(Artifact artifact, Isolation isolation) {
  switch (isolation) {
    case Isolation::query:
      return {table(artifact), Keep::everything};
    case Isolation::mask:
      return mask_recipe(artifact);
  }
  return {};
}

Answers asked_by_any(std::span<const Recipe> recipes) {
  Answers all;
  for (const Recipe& one : recipes)
    for (Who Answers::*question : {&Answers::receiver, &Answers::real_lit, &Answers::object_lit,
                                   &Answers::occlusion, &Answers::bounce, &Answers::mirrored})
      if (one.answers.*question == Who::depth) all.*question = Who::depth;
  return all;
}

}  // namespace seamline::renderer
