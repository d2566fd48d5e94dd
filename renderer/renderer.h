#pragma once
// renderer/: depth becomes a local scene; light is carried through it.
//
// capture.h makes a depth map of the truth, local_scene.h a mesh of a depth map. answers.h says which of the
// two answers which question of light for an artifact, and an Estimator makes the picture, its reference and
// their errors.

#include "renderer/depth/capture.h"
#include "renderer/depth/local_scene.h"
#include "renderer/estimators/estimator.h"
#include "renderer/transport/answers.h"
