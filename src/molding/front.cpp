// Fills control volumes and keeps account of every volume that moves.
#include "molding/front.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "molding/weld_lines.hpp"

namespace fiberfate {
namespace {

/// Nodes of the smallest pocket of air that is told from the unevenness of fronts that meet: more than a node
/// and the ring around it.
constexpr std::size_t least_pocket = 8;
/// Filled share from which on a node is full that a gate fills to the brim.
constexpr double as_good_as_primed = 1 - 1e-14;

void record_fill_times(const FillingState& state, const std::vector<double>& before, const StepFlow& step,
                       std::vector<double>& fill_time) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double change = state.filled[i] - before[i];
    if (!(before[i] < 0.5) || !(state.filled[i] >= 0.5)) continue;
    fill_time[i] = state.time + step.duration * (0.5 - before[i]) / change;
  }
}

void record_directions(const ShellMesh& mesh, const StepFlow& step, FillingState& state) {
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    if (step.at_front[i] == 0) continue;
    for (const ShellNeighbour& from : mesh.neighbours(i)) {
      const double volume = step.inflow(i, from);
      if (volume > 0) state.inflow[i] -= volume * from.direction;
    }
  }
}

/// Passes on what is above a full control volume; nodes that overflow in turn follow in the queue.
void pass_overflow(const FlowSolver& solver, StepFlow& step, FillingState& state) {
  const ShellMesh& mesh = solver.mesh();
  std::vector<double>& content = step.new_content;
  std::vector<Index> queue;
  for (std::size_t i = 0; i < content.size(); ++i)
    if (step.at_front[i] != 0 && content[i] > mesh.volume(i)) queue.push_back(static_cast<Index>(i));
  std::vector<char> queued(content.size(), 0);
  for (const Index node : queue) queued[node] = 1;
  for (std::size_t place = 0; place < queue.size(); ++place) {
    const std::size_t node = queue[place];
    const double overflow = content[node] - mesh.volume(node);
    const auto takes = [&](const ShellNeighbour& to) {
      return step.at_front[to.node] != 0 && queued[to.node] == 0;
    };
    double weight = 0;
    for (const ShellNeighbour& to : mesh.neighbours(node))
      if (takes(to)) weight += solver.edge_weight(to.edge);
    if (!(weight > 0)) continue;
    for (const ShellNeighbour& to : mesh.neighbours(node)) {
      if (!takes(to)) continue;
      const double volume = overflow * solver.edge_weight(to.edge) / weight;
      step.edge_volume[to.edge] += static_cast<Index>(node) < to.node ? volume : -volume;
      content[to.node] += volume;
    }
    content[node] = mesh.volume(node);
    for (const ShellNeighbour& to : mesh.neighbours(node))
      if (takes(to) && content[to.node] > mesh.volume(to.node)) {
        queue.push_back(to.node);
        queued[to.node] = 1;
      }
  }
  for (std::size_t i = 0; i < content.size(); ++i) {
    state.filled[i] = std::min(1.0, content[i] / mesh.volume(i));
    // Round-off must not keep a full node at the front, nor one that its gate has just filled.
    const double full = step.gate_volume[i] > 0 ? as_good_as_primed : 1;
    if (content[i] >= full * mesh.volume(i) || step.at_front[i] == 0) state.filled[i] = 1;
    state.excess[i] = state.filled[i] == 1 ? content[i] - mesh.volume(i) : 0;
  }
}

/// Whether a full node was the last of a pocket that melt had closed in: going back in time from it, the
/// pocket grows over `least_pocket` nodes before it meets one that was reached later.
bool ends_a_pocket(const ShellMesh& mesh, const FillingState& state, std::size_t node) {
  const auto earlier = [&state](Index a, Index b) { return state.fill_time[a] < state.fill_time[b]; };
  std::priority_queue<Index, std::vector<Index>, decltype(earlier)> rim(earlier);
  std::vector<Index> seen = {static_cast<Index>(node)};
  for (std::size_t last = node, size = 1; size < least_pocket; ++size) {
    for (const ShellNeighbour& next : mesh.neighbours(last)) {
      if (std::ranges::find(seen, next.node) != seen.end()) continue;
      if (!state.is_full(next.node) || !(state.fill_time[next.node] < state.fill_time[node])) return false;
      seen.push_back(next.node);
      rim.push(next.node);
    }
    if (rim.empty()) return false;
    last = rim.top();
    rim.pop();
  }
  return true;
}

}  // namespace

double volume_at_front(const ShellMesh& mesh, const FlowField& field) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    if (field.wet[i] != 0) continue;
    const auto neighbours = mesh.neighbours(i);
    const bool reached = std::any_of(neighbours.begin(), neighbours.end(),
                                     [&](const ShellNeighbour& from) { return field.wet[from.node] != 0; });
    if (reached) volume += mesh.volume(i);
  }
  return volume;
}

void advance_front(const FlowSolver& solver, const FlowField& field, StepFlow& step, FillingState& state) {
  const ShellMesh& mesh = solver.mesh();
  const std::size_t n = mesh.node_count();
  step.content.resize(n);
  for (std::size_t i = 0; i < n; ++i) step.content[i] = mesh.volume(i) * state.filled[i] + state.excess[i];
  std::vector<double>& content = step.new_content;
  content = step.content;
  for (std::size_t e = 0; e < step.edge_volume.size(); ++e) {
    step.edge_volume[e] = field.edge_flux[e] * step.duration;
    content[mesh.edges()[e].first] -= step.edge_volume[e];
    content[mesh.edges()[e].second] += step.edge_volume[e];
  }
  for (std::size_t i = 0; i < n; ++i) {
    // A full gate gives its nodes what they pass on, but for what comes of their own excess.
    if (step.gate[i] >= 0 && step.at_front[i] == 0)
      step.gate_volume[i] = step.content[i] - content[i] - field.source[i] * step.duration;
    content[i] += step.gate_volume[i];
  }
  const std::vector<double> before = state.filled;
  pass_overflow(solver, step, state);
  record_fill_times(state, before, step, state.fill_time);
  record_directions(mesh, step, state);
}

void mark_front(const ShellMesh& mesh, const StepFlow& step, FillingState& state) {
  for (std::size_t i = 0; i < mesh.node_count(); ++i) {
    if (step.at_front[i] == 0 || !state.is_full(i)) continue;
    for (const ShellNeighbour& other : mesh.neighbours(i)) {
      if (!state.is_full(other.node) || !fronts_met_between(state, i, other)) continue;
      state.mark[i] = NodeMark::weld_line;
      state.mark[other.node] = NodeMark::weld_line;
    }
    if (fronts_met_in(mesh, state, i)) state.mark[i] = NodeMark::weld_line;
    if (ends_a_pocket(mesh, state, i)) state.mark[i] = NodeMark::air_trap;
  }
}

void mark_last(FillingState& state) {
  const auto last = std::max_element(state.fill_time.begin(), state.fill_time.end());
  state.mark[last - state.fill_time.begin()] = NodeMark::last_filled;
}

}  // namespace fiberfate
