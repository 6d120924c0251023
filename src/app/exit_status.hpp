// The program's exit statuses.
#pragma once

namespace fiberfate {

enum class ExitStatus {
  done = 0,
  bad_input = 2,
  failed = 3,   ///< the simulation failed, or a result could not be written
  stopped = 4,  ///< by a signal, after a checkpoint
};

}  // namespace fiberfate
