// What the environment asks of the program.
#include "app/environment.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "base/error.hpp"
#include "base/simd.hpp"

namespace fiberfate {
namespace {

/// Open MPI, MPICH and Intel MPI tell a process so how many they started.
void check_ranks() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* size = std::getenv(variable);
    if (size != nullptr && std::atoi(size) > 1)
      throw InputError(fmt::format("started as one of {} processes, which would all do the same", size),
                       "start the program without mpirun; --threads uses more cores");
  }
}

}  // namespace

void check_environment() {
  static_cast<void>(instruction_set());
  check_ranks();
}

}  // namespace fiberfate
