// What the environment asks of the program.
#include "app/environment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/simd.hpp"

namespace fiberfate {
namespace {

void check_instruction_set() {
  const char* wish = std::getenv("FIBERFATE_ISA");
  if (wish == nullptr || *wish == 0) return;
  const std::vector<std::string> all = {name(InstructionSet::baseline), name(InstructionSet::avx2),
                                        name(InstructionSet::avx512)};
  if (std::find(all.begin(), all.end(), wish) == all.end())
    throw InputError(fmt::format("FIBERFATE_ISA = {}: there is no such instruction set", wish),
                     fmt::format("give one of {}, or unset it", fmt::join(all, ", ")));
  if (std::string(wish) != name(instruction_set()))
    throw InputError(
        fmt::format("FIBERFATE_ISA = {}: this processor has no more than {}", wish, name(instruction_set())),
        "give a lesser one, or unset it");
}

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
  check_instruction_set();
  check_ranks();
}

}  // namespace fiberfate
