// Translates the choices about the fibers at the start for the packing.
#include "studies/sample/case.hpp"

#include <algorithm>

namespace fiberfate {
namespace {

constexpr double single_fiber_cell = 4;  ///< edge of the cell of a lone fiber, in fiber lengths

bool knows_densities(const SampleCase& sample) {
  const auto& more = sample.fibers.more_kinds;
  return sample.matrix.density && sample.fibers.density &&
         std::all_of(more.begin(), more.end(),
                     [](const FurtherKind& kind) { return kind.density.has_value(); });
}

}  // namespace

std::vector<FiberSpecies> species(const SampleCase& sample) {
  const auto one = [](const FiberKind& kind, double share) {
    return FiberSpecies{material(kind), length_law(kind), kind.rod_length.value_or(0), share};
  };
  std::vector<FiberSpecies> kinds = {one(sample.fibers, 1)};
  for (const FurtherKind& kind : sample.fibers.more_kinds) kinds.push_back(one(kind, kind.volume_share));
  return kinds;
}

std::vector<FiberMaterial> materials(const SampleCase& sample) {
  std::vector<FiberMaterial> all;
  for (const FiberSpecies& kind : species(sample)) all.push_back(kind.material);
  return all;
}

ConcentrationRequest concentration(const SampleCase& sample) {
  return {sample.fibers.count, sample.fibers.volume_fraction, sample.fibers.weight_fraction, sample.cell.size,
          sample.matrix.density.value_or(0)};
}

PackingRequest packing_request(const SampleCase& sample, const ContactParameters& contact,
                               std::uint64_t seed) {
  const ClusterChoices& cluster = sample.cluster;
  PackingRequest request;
  request.orientation.tensor = cluster.orientation;
  request.orientation.law = cluster.law;
  for (const std::vector<double>& row : cluster.directions)
    request.orientation.directions.emplace_back(row[0], row[1], row[2]);
  request.start = cluster.start;
  request.bundle = cluster.bundle;
  request.weights = cluster.weights;
  request.swelling = cluster.swelling;
  request.minimum_radius = cluster.minimum_radius;
  request.overlap_tolerance = cluster.overlap_tolerance;
  request.orientation_tolerance = cluster.orientation_tolerance;
  request.rest = contact;
  request.step_limit = cluster.step_limit;
  request.seed = seed;
  return request;
}

FiberState single_fiber(const SampleCase& sample) {
  const double length = sample.fibers.length.value_or(0);
  const Vec3 size = sample.cell.size.value_or(Vec3::Constant(single_fiber_cell * length));
  const Vec3 direction = sample.cluster.direction.value_or(Vec3::UnitX()).normalized();
  const int rods = rods_for(length, sample.fibers.rod_length.value_or(length));
  FiberState state;
  state.materials = {material(sample.fibers)};
  state.cell = rectangular_cell(size);
  std::vector<Vec3> nodes;
  for (int i = 0; i <= rods; ++i) nodes.push_back(size / 2 + (i - rods / 2.0) * (length / rods) * direction);
  append_fiber(state, {nodes, 0});
  return state;
}

std::optional<SamplePlan> plan_sample(const SampleCase& sample, std::uint64_t seed) {
  if (sample.cluster.source == ClusterSource::file) return {};
  SamplePlan plan;
  if (sample.cluster.source == ClusterSource::fiber) {
    const FiberState state = single_fiber(sample);
    plan = {1, state.rod_count(), state.cell.lattice.diagonal(), volume_fraction(state), {}};
  } else {
    const Population population = plan_population(species(sample), concentration(sample), seed);
    plan.fibers = static_cast<std::int64_t>(population.fibers.size());
    for (const FiberBlank& fiber : population.fibers) plan.rods += fiber.rods;
    plan.cell_size = population.cell_size;
    plan.volume_fraction = population.volume_fraction;
  }
  if (knows_densities(sample))
    plan.weight_fraction = weight_from_volume_fraction(plan.volume_fraction, mean_density(species(sample)),
                                                       *sample.matrix.density);
  return plan;
}

}  // namespace fiberfate
