// Makes the fibers with which a study starts: packed on the spot, one alone, or read from a file.
#pragma once

#include <cstdint>
#include <optional>

#include "fibers/state.hpp"
#include "microstructure/flow_history.hpp"
#include "packing/packing_statistics.hpp"
#include "studies/sample/case.hpp"
#include "studies/session.hpp"

namespace fiberfate {

inline constexpr const char* packing_stopped = "stopped while packing; resuming will pack again";

/// What the fibers are made for.
struct StartRequest {
  const ContactParameters& contact;  ///< under which a packing comes to rest
  Boundary boundary_y = Boundary::periodic;
  std::uint64_t seed = 1;
  /// That the cell has to follow; without one it is a box.
  const FlowHistory* flow = nullptr;
};

/// Fibers at time zero, at rest.
struct StartingFibers {
  FiberState state;
  std::optional<PackingReport> packing;  ///< where they were packed
};

/// Makes the fibers of a valid sample. Raises InputError when they cannot exist or be read, and NoOutcome
/// when the session is asked to stop meanwhile.
[[nodiscard]] StartingFibers make_fibers(const SampleCase& sample, const StartRequest& request,
                                         const Session& session);

/// Warns when the fibers of a packing press so hard that they would sink into each other under the contact
/// law, by more than 2 % of a diameter.
void warn_of_sinking_in(const PackingReport& packing, Recorder& log);

}  // namespace fiberfate
