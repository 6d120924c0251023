// The command line.
#pragma once

namespace fiberfate {

/// Reads the command line, runs the command and returns the exit status (app/exit_status.hpp); every error
/// becomes a message on stderr.
[[nodiscard]] int run_command_line(int argument_count, const char* const* arguments);

}  // namespace fiberfate
