// Solves the network of conductances between nodes, gates and sprue for the pressure.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Where the front stands that starts at a gate.
enum class GateFront {
  inside,  ///< control volumes of the gate are not full: p = 0 at the end of its runner
  passed   ///< all of them are: the gate feeds what lies around it
};

/// An open gate's place in the network.
struct GateLink {
  std::span<const Index> nodes;  ///< at one pressure, once the front has passed
  double resistance = 0;         ///< to the sprue, Pa s/m³; 0 puts the nodes at the sprue's pressure
  GateFront front = GateFront::passed;

  [[nodiscard]] bool operator==(const GateLink& other) const {
    return nodes.data() == other.nodes.data() && front == other.front;
  }
};

/// The coefficients of one solution.
struct Network {
  std::span<const char> wet;             ///< by node: takes part
  std::span<const double> conductances;  ///< by edge, m³/(Pa s)
  std::span<const double> to_front;      ///< by node: sum of conductances to the front, where p = 0
  std::span<const double> sources;       ///< by node, m³/s
};

/// The two parts of the solution, which is linear: p = rate · p_sprue_rate + p_sources.
struct PressureParts {
  std::vector<double> of_unit_rate;  ///< by node, Pa per m³/s through the sprue
  std::vector<double> of_sources;    ///< by node, Pa
  double sprue_of_unit_rate = 0;
  double sprue_of_sources = 0;
};

/// Assembles and factorises A p = f: A symmetric positive definite, one unknown a wet node, gate or sprue
/// (nodes of a gate share one; gates without resistance share the sprue's; a runner whose gate is not full
/// leads from the sprue to p = 0). The order of elimination and the
/// pattern are analysed for the wet nodes and some ahead of the front, and again when the front leaves them
/// or a gate opens or closes.
class PressureSystem {
 public:
  explicit PressureSystem(const ShellMesh& mesh) : mesh_(&mesh) {}

  /// Sets which gates are open; the next solution analyses the pattern.
  void set_gates(std::vector<GateLink> open_gates);
  /// Solves. `covered` are the nodes of the pattern: they are chosen anew when a wet node is not among them
  /// (or there are none), and part of the state, since round-off depends on them. Raises SimulationFailure
  /// when the network is singular (nothing wet leads to the front).
  void solve(const Network& network, std::vector<char>& covered, PressureParts& parts);

 private:
  using Matrix = Eigen::SparseMatrix<double>;
  /// Couples two unknowns, for an edge or for a gate (-1 for the other).
  struct Link {
    Index row, column;
    Index edge, gate;
  };
  void cover(std::span<const char> wet, std::vector<char>& covered) const;
  void number_unknowns();
  [[nodiscard]] std::vector<Link> find_links();
  void order_unknowns(std::vector<Link>& links);
  void analyse();
  void assemble(const Network& network);
  void back_substitute(Eigen::VectorXd& right, std::vector<double>& by_node, double& sprue) const;

  const ShellMesh* mesh_;
  std::vector<GateLink> gates_;
  std::vector<char> covered_;         ///< what the present pattern covers; empty when it must be analysed
  std::vector<Index> unknown_of_;     ///< by node; -1 where not covered
  std::vector<Index> gate_unknowns_;  ///< by gate; the sprue's for those that have none of their own
  Index sprue_ = 0;
  std::vector<Index> edge_slots_;      ///< by edge: place in the values of the matrix; -1 for none
  std::vector<Index> diagonal_slots_;  ///< by unknown
  std::vector<Index> gate_slots_;      ///< by gate: coupling to the sprue; -1 for none
  std::vector<Index> node_edges_;      ///< edges between covered nodes
  Matrix matrix_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> factor_;
  Eigen::VectorXd right_;
};

}  // namespace fiberfate
