// Makes the fibers with which a study starts.
#include "studies/sample/start.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "dynamics/simulable.hpp"
#include "fibers/lattice_choice.hpp"
#include "results/fiber_file.hpp"

namespace fiberfate {
namespace {

/// The cell of a size that follows the flow.
Cell cell_of(const StartRequest& start, const Vec3& size) {
  Cell cell = start.flow != nullptr ? cell_for(*start.flow, size) : rectangular_cell(size);
  cell.boundary[1] = start.boundary_y;
  return cell;
}

StartingFibers pack_fibers(const SampleCase& sample, const StartRequest& start, const Session& session) {
  Population population = plan_population(species(sample), concentration(sample), start.seed);
  PackingRequest request = packing_request(sample, start.contact, start.seed);
  request.materials = std::move(population.materials);
  request.fibers = std::move(population.fibers);
  request.cell = cell_of(start, population.cell_size);
  PackingResult result = pack(request, [&session](const PackingProgress& now) {
    session.end_if_stopped(packing_stopped);
    session.show([&now] {
      return fmt::format(
          "packing, {}: step {}, largest overlap {:.3g} diameters, smallest radius {:.4g} um, "
          "orientation off by {:.2g}",
          now.stage, now.step, now.largest_overlap, 1e6 * now.minimum_radius, now.orientation_error);
    });
  });
  session.end_progress();
  result.state.cell = request.cell;
  number_by_height(result.state);
  return {std::move(result.state), std::move(result.report)};
}

/// Reads the fibers of a file; what is wrong with them is told with its name.
FiberState read_fibers(const SampleCase& sample, const StartRequest& start) {
  FiberState state = read_fiber_file(sample.cluster.file, materials(sample), sample.cell.size);
  try {
    require_simulable(state);
    if (start.flow != nullptr) require_follows(state.cell, *start.flow);
  } catch (const InputError& error) {
    std::vector<InputProblem> problems = error.problems();
    for (InputProblem& problem : problems) {
      problem.file = sample.cluster.file;
      problem.line = problem.column = 1;  // the file as a whole
    }
    throw InputError(std::move(problems));
  }
  return state;
}

}  // namespace

void warn_of_sinking_in(const PackingReport& packing, Recorder& log) {
  constexpr double harmless = 0.02;
  if (packing.overlap_at_rest < harmless) return;
  log.warn(
      fmt::format("bent fibers press each other: under the contact law they sink in by up to {:.2g} "
                  "diameters where nothing "
                  "flows; less concentrated ones do not, nor bundles of seven and more (cluster.start = "
                  "\"bundles\"), nor "
                  "fibers under a larger contact.force_constant",
                  packing.overlap_at_rest));
}

StartingFibers make_fibers(const SampleCase& sample, const StartRequest& request, const Session& session) {
  if (sample.cluster.source == ClusterSource::generate) return pack_fibers(sample, request, session);
  StartingFibers fibers;
  if (sample.cluster.source == ClusterSource::fiber) {
    fibers.state = single_fiber(sample);
    fibers.state.cell = cell_of(request, fibers.state.cell.lattice.diagonal());
    wrap_fibers(fibers.state);
    return fibers;
  }
  fibers.state = read_fibers(sample, request);
  fibers.state.cell.boundary[1] = request.boundary_y;
  return fibers;
}

}  // namespace fiberfate
