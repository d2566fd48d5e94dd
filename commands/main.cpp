#include "commands/program.h"

int main(int argc, char** argv) {
  return seamline::run_command_line(argc, argv);
}
