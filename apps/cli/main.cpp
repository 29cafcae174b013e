// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/exit_status.h"

int main(int argument_count, char** arguments) {
  inkflate::cli::end_faults_with_status();
  std::vector<std::string> const words(arguments + (argument_count > 0 ? 1 : 0),
                                       arguments + argument_count);
  return static_cast<int>(inkflate::cli::run_command_line(words));
}
