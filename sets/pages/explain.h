#pragma once
#include <string>

#include "sets/render_plan.h"

namespace seamline::renderer {

/// The plan as text for a person, a block a scene (`--explain`).
[[nodiscard]] std::string explain(const StudyDefinition& study, const RenderPlan& plan);

/// What each omission saved in a scene, from what was counted while rendering.
[[nodiscard]] std::string explain_savings(const std::string& scene, const Savings& savings);

}  // namespace seamline::renderer
