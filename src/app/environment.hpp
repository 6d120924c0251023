// What the environment asks of the program, checked before anything is done.
#pragma once

namespace fiberfate {

/// Refuses an instruction set in FIBERFATE_ISA that is unknown or that this processor lacks, and a start by
/// mpirun as one of several processes, which would all do the same (InputError).
void check_environment();

}  // namespace fiberfate
