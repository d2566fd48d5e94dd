#include "registration/commands/commands.h"

#include "registration/commands/calibrate_command.h"
#include "registration/commands/register_command.h"

namespace seamline::registration {

void add_registration_commands(CLI::App& app) {
  add_register_command(app);
  add_calibrate_command(app);
}

}  // namespace seamline::registration
