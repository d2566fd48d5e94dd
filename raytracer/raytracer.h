#pragma once
// raytracer/: scene files, rays, materials, lights, and the errors of pictures.
//
// A TruthScene is what a scene file and a study say together. Geometry answers rays (Embree), a material says
// what it does with light, and lights are sampled by light/. Knows no artifact.

#include "raytracer/light/light.h"
#include "raytracer/material/material.h"
#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "raytracer/tracing/geometry.h"
