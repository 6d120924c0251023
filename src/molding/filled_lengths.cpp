// Averages lengths over gap, samples and part.
#include "molding/filled_lengths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fiberfate {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void append(LengthClasses& all, const LengthClasses& some, double weight) {
  all.lengths.insert(all.lengths.end(), some.lengths.begin(), some.lengths.end());
  for (const double number : some.numbers) all.numbers.push_back(weight * number);
  all.width = some.width;
}

MeanLengths means_of(const LengthClasses& population) {
  return population.lengths.empty() ? MeanLengths{nan, nan} : mean_lengths(population);
}

}  // namespace

LengthClasses FilledLengths::population(std::size_t set, std::size_t node, std::size_t layer) const {
  LengthClasses population;
  if (!is_wet(node) || reading_ == LengthReading::means) return population;
  const std::span<const double> fields = filling_.lengths(set, node, layer);
  const std::span<const double> bins = filling_.bin_lengths(set);
  if (!bins.empty()) {
    population.lengths.assign(bins.begin(), bins.end());
    population.numbers.assign(fields.begin(), fields.end());
    population.width = bins.front();  // the first bin is one width long
    return population;
  }
  const MoldingFibers& fibers = filling_.params().fibers;
  const std::span<const double> amounts = filling_.amounts(node, layer);
  population.lengths.assign(fields.begin(), fields.end());
  for (std::size_t c = 0; c < fields.size(); ++c) {
    const bool keeps_length = fibers.class_weight == ClassWeight::length;
    const double amount = !amounts.empty() ? amounts[c]
                          : keeps_length   ? fibers.class_numbers[c] * fibers.class_lengths[c]
                                           : fibers.class_numbers[c];
    population.numbers.push_back(keeps_length ? amount / fields[c] : amount);
  }
  return population;
}

LengthClasses FilledLengths::population(std::size_t set, std::size_t node) const {
  LengthClasses all;
  const std::span<const double> widths = filling_.layers().widths();
  for (std::size_t layer = 0; layer < widths.size(); ++layer)
    append(all, population(set, node, layer), widths[layer]);
  return all;
}

MeanLengths FilledLengths::means(std::size_t set, std::size_t node, std::size_t layer) const {
  if (!is_wet(node)) return {nan, nan};
  if (reading_ == LengthReading::population) return means_of(population(set, node, layer));
  const std::span<const double> both = filling_.lengths(set, node, layer);
  return {both[0], both[1]};
}

MeanLengths FilledLengths::means(std::size_t set, std::size_t node) const {
  const Index one[] = {static_cast<Index>(node)};
  return means(set, one);
}

MeanLengths FilledLengths::means(std::size_t set, std::span<const Index> nodes) const {
  return reading_ == LengthReading::population ? sample_means(set, nodes) : gap_means(set, nodes);
}

template <class Body>
double FilledLengths::visit_wet(std::span<const Index> nodes, const Body& body) const {
  double volumes = 0;
  for (const Index index : nodes) {
    const std::size_t node = index;
    if (!is_wet(node)) continue;
    const double volume = filling_.mesh().volume(node) * filling_.state().filled[node];
    volumes += volume;
    body(node, volume);
  }
  return volumes;
}

MeanLengths FilledLengths::gap_means(std::size_t set, std::span<const Index> nodes) const {
  const std::span<const double> widths = filling_.layers().widths();
  MeanLengths sum;
  const double volumes = visit_wet(nodes, [&](std::size_t node, double volume) {
    for (std::size_t layer = 0; layer < widths.size(); ++layer) {
      const MeanLengths one = means(set, node, layer);
      sum.number_average += volume * widths[layer] * one.number_average;
      sum.weight_average += volume * widths[layer] * one.weight_average;
    }
  });
  if (volumes <= 0) return {nan, nan};
  return {sum.number_average / volumes, sum.weight_average / volumes};
}

LengthClasses FilledLengths::population(std::size_t set, std::span<const Index> nodes) const {
  LengthClasses all;
  visit_wet(nodes, [&](std::size_t node, double volume) { append(all, population(set, node), volume); });
  return all;
}

MeanLengths FilledLengths::sample_means(std::size_t set, std::span<const Index> nodes) const {
  if (reading_ == LengthReading::population) return means_of(population(set, nodes));
  const std::span<const double> widths = filling_.layers().widths();
  double numbers = 0, weighted = 0;
  const double volumes = visit_wet(nodes, [&](std::size_t node, double volume) {
    for (std::size_t layer = 0; layer < widths.size(); ++layer) {
      const MeanLengths one = means(set, node, layer);
      numbers += volume * widths[layer] / one.number_average;
      weighted += volume * widths[layer] * one.weight_average;
    }
  });
  if (volumes <= 0) return {nan, nan};
  return {volumes / numbers, weighted / volumes};
}

LengthClasses FilledLengths::inlet_population() const {
  if (reading_ == LengthReading::means) return {};
  return {filling_.params().fibers.class_lengths, filling_.params().fibers.class_numbers};
}

MeanLengths FilledLengths::inlet_means() const {
  const std::vector<double>& lengths = filling_.params().fibers.class_lengths;
  if (reading_ == LengthReading::means) return {lengths[0], lengths[1]};
  return means_of(inlet_population());
}

std::vector<Index> sample_nodes(const ShellMesh& mesh, const Vec3& place, double radius) {
  std::vector<Index> nodes;
  for (std::size_t i = 0; i < mesh.node_count(); ++i)
    if ((mesh.shell().nodes[i] - place).norm() <= radius) nodes.push_back(static_cast<Index>(i));
  if (nodes.empty()) nodes.push_back(static_cast<Index>(mesh.nearest_node(place)));
  return nodes;
}

}  // namespace fiberfate
