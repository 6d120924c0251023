// How the threads of the program wait for each other.
#pragma once

namespace fiberfate {

/// Starts the program anew with threads that sleep while they wait, unless its environment says how they wait
/// (OMP_WAIT_POLICY, GOMP_SPINCOUNT, KMP_BLOCKTIME). OpenMP reads that only when a program is loaded; its
/// default is to spin, which keeps a core from whoever is waited for where others want it too. Does nothing
/// where the program cannot be started anew.
void let_waiting_threads_sleep(char** arguments);

}  // namespace fiberfate
