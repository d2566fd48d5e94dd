#pragma once
#include "scenes/shapes/field.h"
#include "scenes/shapes/mesh.h"

namespace seamline::scenes {

/// Newell's teapot, 1 m from handle to spout (along x), `steps` quads along each side of a patch. Its surface
/// is open where Newell's is: between lid and rim and at the spout's mouth.
[[nodiscard]] TriangleMesh make_teapot(int steps);

/// A robed, winged figure on a plinth that holds up a torch, 1.9 m tall, in the manner of the Stanford Lucy.
/// Faces +Z.
[[nodiscard]] Sculpture sculpt_statue();

/// An upright armoured creature with raised arms, 1.7 m tall, in the manner of the Stanford armadillo. Faces
/// +Z.
[[nodiscard]] Sculpture sculpt_creature();

/// A long, low four-legged beast with spines and a long tail, in the manner of the killeroo. Head towards +X.
[[nodiscard]] Sculpture sculpt_beast();

/// A walking lion with mane and tufted tail. Head towards +X.
[[nodiscard]] Sculpture sculpt_lion();

/// A long coiling dragon with horns and crest, in the manner of the Stanford dragon. Head towards +X.
[[nodiscard]] Sculpture sculpt_dragon();

}  // namespace seamline::scenes
