// How the threads of the program wait for each other.
#include "app/thread_waiting.hpp"

#include <unistd.h>

#include <cstdlib>

namespace fiberfate {

void let_waiting_threads_sleep(char** arguments) {
  for (const char* name : {"OMP_WAIT_POLICY", "GOMP_SPINCOUNT", "KMP_BLOCKTIME"}) {
    if (std::getenv(name) != nullptr) return;
  }
  if (setenv("OMP_WAIT_POLICY", "passive", 0) != 0) return;
  execv("/proc/self/exe", arguments);
}

}  // namespace fiberfate
