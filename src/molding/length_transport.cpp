// Mixes and decays the lengths of every layer, down the flow.
#include "molding/length_transport.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "continuum/length_classes.hpp"

namespace fiberfate {
namespace {

/// Share of all fibers that a class has at least where a gate lacks it, so that its length stays defined.
constexpr double least_amount = 1e-12;

/// Whether some gate has numbers of its own.
bool numbers_differ(const MoldingFibers& fibers) {
  return !fibers.inlet.numbers.empty() ||
         std::any_of(fibers.gate_inlets.begin(), fibers.gate_inlets.end(),
                     [](const auto& inlet) { return inlet && !inlet->numbers.empty(); });
}

}  // namespace

/// What the layers of one node do to lengths.
struct LengthTransport::NodeScratch {
  std::array<double, most_half_layers> rate, viscosity, duration;
  std::vector<double> survival;  ///< [set][layer]: exp(-k_f tau) - 1
  std::vector<double> limit;     ///< [set][layer]: L_inf, m
  std::vector<double> sum;       ///< of all fields of a point
};

LengthTransport::LengthTransport(const ShellMesh& mesh, const FillingParams& params, const GapLayers& layers)
    : mesh_(&mesh), params_(&params), layers_(&layers), field_begin_{0} {
  const MoldingFibers& fibers = params.fibers;
  double longest = 0;
  for (const double length : fibers.class_lengths) longest = std::max(longest, length);
  for (const auto& inlet : fibers.gate_inlets)
    if (inlet)
      for (const double length : inlet->lengths) longest = std::max(longest, length);
  for (const double length : fibers.inlet.lengths) longest = std::max(longest, length);
  for (const LengthSet& set : fibers.length_sets) {
    const PhelpsConstants* constants = set.law->fragmentation();
    phelps_.push_back(
        constants ? std::make_unique<PhelpsSolver>(*constants, LengthBins{fibers.phelps_bins, longest})
                  : nullptr);
    bin_lengths_.push_back(constants ? phelps_.back()->bins().lengths() : std::vector<double>());
    field_begin_.push_back(field_begin_.back() +
                           (constants ? fibers.phelps_bins : fibers.class_lengths.size()));
  }
  if (!fibers.length_sets.empty() && numbers_differ(fibers)) amount_count_ = fibers.class_lengths.size();
  for (std::size_t g = 0; g < params.gates.size(); ++g) {
    const bool own = g < fibers.gate_inlets.size() && fibers.gate_inlets[g];
    inlets_.emplace_back(field_count());
    write_inlet(own ? *fibers.gate_inlets[g] : fibers.inlet, inlets_.back());
  }
}

void LengthTransport::write_inlet(const InletFibers& inlet, std::span<double> fields) const {
  const MoldingFibers& fibers = params_->fibers;
  const std::vector<double>& lengths = inlet.lengths.empty() ? fibers.class_lengths : inlet.lengths;
  LengthClasses classes = {lengths, inlet.numbers.empty() ? fibers.class_numbers : inlet.numbers};
  if (!classes.numbers.empty()) {
    const double scale = total_length({fibers.class_lengths, fibers.class_numbers}) / total_length(classes);
    for (double& number : classes.numbers) number *= scale;
  }
  for (std::size_t s = 0; s < phelps_.size(); ++s) {
    const std::vector<double> values = phelps_[s] ? sort_into_bins(classes, phelps_[s]->bins()) : lengths;
    std::copy(values.begin(), values.end(), fields.begin() + static_cast<std::ptrdiff_t>(field_begin_[s]));
  }
  const auto amounts = fields.subspan(field_begin_.back());
  double sum = 0;
  for (std::size_t c = 0; c < amounts.size(); ++c) {
    amounts[c] = classes.numbers[c] * (fibers.class_weight == ClassWeight::length ? lengths[c] : 1);
    sum += amounts[c];
  }
  for (double& amount : amounts) amount = std::max(amount, least_amount * sum);
}

/// Adds to `sum` what a volume of melt with the fields `from` brings.
void LengthTransport::take(const double* from, double volume, double* sum) const {
  if (amount_count_ == 0) {
    for (std::size_t f = 0; f < field_count(); ++f) sum[f] += volume * from[f];
    return;
  }
  const double* const amounts = from + field_begin_.back();
  for (std::size_t s = 0; s < phelps_.size(); ++s)
    for (std::size_t f = field_begin_[s], c = 0; f < field_begin_[s + 1]; ++f, ++c)
      sum[f] += volume * (phelps_[s] ? 1 : amounts[c]) * from[f];
  for (std::size_t f = field_begin_.back(); f < field_count(); ++f) sum[f] += volume * from[f];
}

/// Makes of such a sum the mean of all that came together.
void LengthTransport::divide(double volume, double* sum) const {
  if (amount_count_ == 0) {
    for (std::size_t f = 0; f < field_count(); ++f) sum[f] /= volume;
    return;
  }
  const double* const amounts = sum + field_begin_.back();
  for (std::size_t s = 0; s < phelps_.size(); ++s)
    for (std::size_t f = field_begin_[s], c = 0; f < field_begin_[s + 1]; ++f, ++c)
      sum[f] /= phelps_[s] ? volume : amounts[c];
  for (std::size_t f = field_begin_.back(); f < field_count(); ++f) sum[f] /= volume;
}

void LengthTransport::prepare_decay(std::size_t node, const MeltMotion& motion, const FillingState& state,
                                    NodeScratch& scratch) const {
  const std::size_t count = layers_->count(), begin = node * count;
  const StepFlow& step = motion.step;
  const std::optional<FiberCoupling>& coupling = params_->fibers.coupling;
  const bool takes_matrix = !motion.stretching.empty() && coupling && coupling->drag == DragViscosity::matrix;
  for (std::size_t k = 0; k < count; ++k) {
    const double content = step.content[node] * layers_->widths()[k];
    const double mixed = content + step.layer_inflow[begin + k];
    const double inverse = motion.field.inverse_viscosity[begin + k];
    const bool flows = inverse > 0 && state.rate[begin + k] > 0 && mixed > 0;
    scratch.duration[k] = flows ? step.duration * content / mixed : 0;
    scratch.rate[k] = flows ? state.rate[begin + k] : 0;
    const double stretched = takes_matrix ? motion.stretching[begin + k] : 1;
    scratch.viscosity[k] = flows ? 1 / (inverse * stretched) : 0;
  }
  const LengthFlows flows{std::span(scratch.rate).first(count), std::span(scratch.viscosity).first(count)};
  for (std::size_t s = 0; s < phelps_.size(); ++s) {
    if (phelps_[s]) continue;
    const auto survival = std::span(scratch.survival).subspan(s * count, count);
    params_->fibers.length_sets[s].law->relaxation()->evaluate(
        flows, survival, std::span(scratch.limit).subspan(s * count, count));
    for (std::size_t k = 0; k < count; ++k)
      survival[k] = scratch.duration[k] > 0 ? std::expm1(-survival[k] * scratch.duration[k]) : 0;
  }
}

void LengthTransport::mix(LayerOfNode at, const MeltMotion& motion, std::span<double> sum,
                          FillingState& state) const {
  const auto [node, layer] = at;
  const StepFlow& step = motion.step;
  const std::size_t count = layers_->count(), fields = field_count(), point = node * count + layer;
  double* const value = &state.lengths[point * fields];
  const double content = step.content[node] * layers_->widths()[layer];
  const double total = content + step.layer_inflow[point];
  if (!(total > 0)) return;
  std::fill(sum.begin(), sum.end(), 0.0);
  take(value, content, sum.data());
  for (const ShellNeighbour& from : mesh_->neighbours(node)) {
    const double volume = step.inflow(node, from);
    if (!(volume > 0)) continue;
    const std::size_t there = from.node;
    take(&state.lengths[(there * count + layer) * fields], volume * motion.share(there, node, layer),
         sum.data());
  }
  const double gate = step.gate_volume[node];
  if (gate > 0) take(inlets_[step.gate[node]].data(), gate * motion.gate_share(node, layer), sum.data());
  for (const LayerTransfer& t : step.transfers_of(node, count))
    if (t.to == layer) take(&state.lengths[(node * count + t.from) * fields], t.volume, sum.data());
  divide(total, sum.data());
  std::copy(sum.begin(), sum.end(), value);
}

void LengthTransport::decay(LayerOfNode at, FillingState& state, const NodeScratch& scratch) const {
  const auto [node, layer] = at;
  const std::size_t count = layers_->count();
  double* const value = &state.lengths[(node * count + layer) * field_count()];
  for (std::size_t s = 0; s < phelps_.size(); ++s) {
    const std::size_t first = field_begin_[s], last = field_begin_[s + 1];
    if (phelps_[s]) {
      if (scratch.duration[layer] > 0)
        phelps_[s]->advance(LengthFlow{scratch.rate[layer], scratch.viscosity[layer], 1},
                            scratch.duration[layer], std::span(value + first, last - first));
      continue;
    }
    const double survival = scratch.survival[s * count + layer], limit = scratch.limit[s * count + layer];
    if (survival == 0) continue;
    for (std::size_t f = first; f < last; ++f)
      if (value[f] > limit) value[f] = std::max(limit, value[f] + (value[f] - limit) * survival);
  }
}

void LengthTransport::advance_node(std::size_t node, const MeltMotion& motion, FillingState& state,
                                   NodeScratch& scratch) const {
  const std::size_t count = layers_->count();
  prepare_decay(node, motion, state, scratch);
  const auto transfers = motion.step.transfers_of(node, count);
  std::uint64_t waiting = 0, done = 0;
  for (std::size_t k = 0; k < count; ++k) waiting |= std::uint64_t{1} << k;
  // A layer follows those that it takes melt from; transfers never run in a ring.
  while (waiting != 0) {
    for (std::size_t k = 0; k < count; ++k) {
      if ((waiting >> k & 1) == 0) continue;
      const bool ready = std::all_of(transfers.begin(), transfers.end(), [&](const LayerTransfer& t) {
        return t.to != k || (done >> t.from & 1) != 0;
      });
      if (!ready) continue;
      mix({node, k}, motion, scratch.sum, state);
      decay({node, k}, state, scratch);
      waiting &= ~(std::uint64_t{1} << k);
      done |= std::uint64_t{1} << k;
    }
  }
}

void LengthTransport::advance(std::span<const Index> nodes, const MeltMotion& motion,
                              FillingState& state) const {
  if (field_count() == 0) return;
  NodeScratch scratch;
  scratch.survival.resize(phelps_.size() * layers_->count());
  scratch.limit.resize(phelps_.size() * layers_->count());
  scratch.sum.resize(field_count());
  for (const Index node : nodes) advance_node(node, motion, state, scratch);
}

}  // namespace fiberfate
