// The command line.
#pragma once

namespace fiberfate {

/// The program's exit statuses.
enum class ExitStatus {
  done = 0,
  bad_input = 2,
  failed = 3,   ///< the simulation failed, or a result could not be written
  stopped = 4,  ///< by a signal, after a checkpoint
};

/// Reads the command line, runs the command and returns the exit status; every error becomes a message on
/// stderr.
[[nodiscard]] int run_command_line(int argument_count, const char* const* arguments);

}  // namespace fiberfate
