#include "commands/renderer_commands.h"

#include "commands/depth_cameras/relight_command.h"
#include "commands/depth_cameras/sense_command.h"
#include "commands/depth_cameras/settle_command.h"
#include "commands/depth_cameras/workbench_command.h"
#include "commands/evidence/bench_command.h"
#include "commands/evidence/convergence_command.h"
#include "commands/evidence/field_command.h"
#include "commands/evidence/marker_command.h"
#include "commands/evidence/person_command.h"
#include "commands/photographs/composite_command.h"
#include "commands/photographs/flip_command.h"
#include "commands/photographs/picture_command.h"
#include "commands/photographs/views_command.h"
#include "commands/study/check_command.h"
#include "commands/study/render_command.h"

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
