#include "renderer/commands/commands.h"

#include "renderer/commands/bench_command.h"
#include "renderer/commands/check_command.h"
#include "renderer/commands/convergence_command.h"
#include "renderer/commands/marker_command.h"
#include "renderer/commands/person_command.h"
#include "renderer/commands/pictures/composite_command.h"
#include "renderer/commands/pictures/flip_command.h"
#include "renderer/commands/pictures/picture_command.h"
#include "renderer/commands/pictures/views_command.h"
#include "renderer/commands/render_command.h"
#include "renderer/commands/sense_command.h"
#include "renderer/commands/workbench_command.h"
#include "renderer/figures/field_command.h"
#include "renderer/settling/relight_command.h"
#include "renderer/settling/settle_command.h"

namespace seamline::renderer {

void add_renderer_commands(CLI::App& app, PlaceInWindow in_window) {
  add_render_command(app);
  add_check_command(app);
  add_workbench_commands(app);
  add_composite_command(app);
  add_place_command(app, in_window);
  add_picture_command(app);
  add_views_command(app);
  add_flip_command(app);
  add_sense_command(app);
  add_settle_command(app);
  add_relight_command(app);
}

void add_lab_commands(CLI::App& lab) {
  add_bench_command(lab);
  add_convergence_command(lab);
  add_marker_command(lab);
  add_person_command(lab);
  add_field_command(lab);
}

}  // namespace seamline::renderer
