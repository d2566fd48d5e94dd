#include "commands/depth_cameras/registration_commands.h"

#include "commands/depth_cameras/calibrate_command.h"
#include "commands/depth_cameras/register_command.h"

namespace seamline::registration {

void add_registration_commands(CLI::App& app) {
  add_register_command(app);
  add_calibrate_command(app);
}

}  // namespace seamline::registration
