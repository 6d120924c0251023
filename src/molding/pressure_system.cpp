// Numbers, assembles and solves the network of conductances.
#include "molding/pressure_system.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace fiberfate {
namespace {

/// Nodes that the pattern covers ahead of the front, as a share of those behind it, and at least so many.
constexpr double ahead_share = 0.15;
constexpr std::size_t ahead_least = 30;

}  // namespace

void PressureSystem::set_gates(std::vector<GateLink> open_gates) {
  gates_ = std::move(open_gates);
  covered_.clear();
}

void PressureSystem::cover(std::span<const char> wet, std::vector<char>& covered) const {
  covered.assign(wet.begin(), wet.end());
  std::vector<Index> ring, next;
  for (std::size_t i = 0; i < wet.size(); ++i)
    if (wet[i] != 0) ring.push_back(static_cast<Index>(i));
  const auto behind = static_cast<double>(ring.size());
  const auto wanted = ahead_least + static_cast<std::size_t>(ahead_share * behind);
  for (std::size_t ahead = 0; ahead < wanted && !ring.empty(); std::swap(ring, next)) {
    next.clear();
    for (const Index i : ring)
      for (const ShellNeighbour& neighbour : mesh_->neighbours(i)) {
        if (covered[neighbour.node] != 0) continue;
        covered[neighbour.node] = 1;
        next.push_back(neighbour.node);
      }
    ahead += next.size();
  }
}

void PressureSystem::number_unknowns() {
  unknown_of_.assign(mesh_->node_count(), -1);
  gate_unknowns_.assign(gates_.size(), 0);
  sprue_ = 0;
  Index count = 1;
  for (std::size_t g = 0; g < gates_.size(); ++g) {
    if (gates_[g].front == GateFront::inside) continue;
    gate_unknowns_[g] = gates_[g].resistance > 0 ? count++ : sprue_;
    for (const Index node : gates_[g].nodes) unknown_of_[node] = gate_unknowns_[g];
  }
  for (std::size_t i = 0; i < covered_.size(); ++i)
    if (covered_[i] != 0 && unknown_of_[i] < 0) unknown_of_[i] = count++;
  diagonal_slots_.assign(count, 0);
}

std::vector<PressureSystem::Link> PressureSystem::find_links() {
  std::vector<Link> links;
  node_edges_.clear();
  for (std::size_t e = 0; e < mesh_->edges().size(); ++e) {
    const Index a = unknown_of_[mesh_->edges()[e].first], b = unknown_of_[mesh_->edges()[e].second];
    if (a < 0 || b < 0 || a == b) continue;
    node_edges_.push_back(static_cast<Index>(e));
    links.push_back({a, b, static_cast<Index>(e), -1});
  }
  for (std::size_t g = 0; g < gates_.size(); ++g)
    if (gate_unknowns_[g] != sprue_) links.push_back({gate_unknowns_[g], sprue_, -1, static_cast<Index>(g)});
  return links;
}

void PressureSystem::order_unknowns(std::vector<Link>& links) {
  const auto count = static_cast<Index>(diagonal_slots_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const Link& link : links) {
    entries.emplace_back(link.row, link.column, 1.0);
    entries.emplace_back(link.column, link.row, 1.0);
  }
  for (Index i = 0; i < count; ++i) entries.emplace_back(i, i, 1.0);
  Matrix pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
  Permutation elimination;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Upper>(), elimination);
  // AMD tells which unknown comes when; wanted is when each unknown comes.
  const Permutation place = elimination.inverse();
  for (Index& unknown : unknown_of_)
    if (unknown >= 0) unknown = place.indices()[unknown];
  for (Index& unknown : gate_unknowns_) unknown = place.indices()[unknown];
  sprue_ = place.indices()[sprue_];
  for (Link& link : links) {
    const Index a = place.indices()[link.row], b = place.indices()[link.column];
    link.row = std::min(a, b);
    link.column = std::max(a, b);
  }
}

void PressureSystem::analyse() {
  number_unknowns();
  std::vector<Link> links = find_links();
  order_unknowns(links);
  const auto count = static_cast<Index>(diagonal_slots_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const Link& link : links) entries.emplace_back(link.row, link.column, 1.0);
  for (Index i = 0; i < count; ++i) entries.emplace_back(i, i, 1.0);
  matrix_.resize(count, count);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  const auto slot = [&](Index row, Index column) {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return static_cast<Index>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr());
  };
  edge_slots_.assign(mesh_->edges().size(), -1);
  gate_slots_.assign(gates_.size(), -1);
  for (const Link& link : links)
    (link.edge >= 0 ? edge_slots_[link.edge] : gate_slots_[link.gate]) = slot(link.row, link.column);
  for (Index i = 0; i < count; ++i) diagonal_slots_[i] = slot(i, i);
  factor_.analyzePattern(matrix_);
}

void PressureSystem::assemble(const Network& network) {
  double* const value = matrix_.valuePtr();
  std::fill(value, value + matrix_.nonZeros(), 0.0);
  for (const Index e : node_edges_) {
    const auto [a, b] = mesh_->edges()[e];
    if (network.wet[a] == 0 || network.wet[b] == 0) continue;
    const double c = network.conductances[e];
    value[edge_slots_[e]] -= c;
    value[diagonal_slots_[unknown_of_[a]]] += c;
    value[diagonal_slots_[unknown_of_[b]]] += c;
  }
  for (std::size_t i = 0; i < network.wet.size(); ++i)
    if (network.wet[i] != 0) value[diagonal_slots_[unknown_of_[i]]] += network.to_front[i];
  for (std::size_t g = 0; g < gates_.size(); ++g) {
    if (!(gates_[g].resistance > 0)) continue;
    const double c = 1 / gates_[g].resistance;
    value[diagonal_slots_[sprue_]] += c;
    if (gate_slots_[g] < 0) continue;
    value[gate_slots_[g]] -= c;
    value[diagonal_slots_[gate_unknowns_[g]]] += c;
  }
  // Nodes that are not wet yet stand alone with p = 0.
  for (const Index slot : diagonal_slots_)
    if (value[slot] == 0) value[slot] = 1;
}

void PressureSystem::back_substitute(Eigen::VectorXd& right, std::vector<double>& by_node,
                                     double& sprue) const {
  right = factor_.solve(right).eval();
  by_node.resize(unknown_of_.size());
  for (std::size_t i = 0; i < by_node.size(); ++i)
    by_node[i] = unknown_of_[i] >= 0 ? right[unknown_of_[i]] : 0.0;
  sprue = right[sprue_];
}

void PressureSystem::solve(const Network& network, std::vector<char>& covered, PressureParts& parts) {
  bool covers = !covered.empty();
  for (std::size_t i = 0; i < network.wet.size() && covers; ++i) covers = covered[i] >= network.wet[i];
  if (!covers) cover(network.wet, covered);
  if (covered != covered_) {
    covered_ = covered;
    analyse();
  }
  assemble(network);
  factor_.factorize(matrix_);
  const bool positive = factor_.info() == Eigen::Success && factor_.vectorD().minCoeff() > 0;
  if (!positive)
    throw SimulationFailure("the pressure equation has no solution: no melt leads to the front", {});
  right_.setZero(matrix_.rows());
  right_[sprue_] = 1;
  back_substitute(right_, parts.of_unit_rate, parts.sprue_of_unit_rate);
  const bool fed =
      std::any_of(network.sources.begin(), network.sources.end(), [](double q) { return q != 0; });
  parts.of_sources.assign(network.wet.size(), 0);
  parts.sprue_of_sources = 0;
  if (!fed) return;
  right_.setZero(matrix_.rows());
  for (std::size_t i = 0; i < network.sources.size(); ++i)
    if (network.sources[i] != 0) right_[unknown_of_[i]] += network.sources[i];
  back_substitute(right_, parts.of_sources, parts.sprue_of_sources);
}

}  // namespace fiberfate
