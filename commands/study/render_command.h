#pragma once
#include "sets/render_set.h"

namespace CLI {
class App;
}

namespace seamline::renderer {

/// `seamline render` and `seamline verify`.
void add_render_command(CLI::App& app);

/// Renders, and prints how much.
RenderSummary render_and_say(const StudyDefinition& study, const RenderRequest& request);

/// Where the set is whole: writes errors.html, and prints what a reader must know of it. `asked_error` is
/// that of --error; 0: none was asked.
void say_of_whole_set(const StudyDefinition& study, const RenderRequest& request, double asked_error);

}  // namespace seamline::renderer
