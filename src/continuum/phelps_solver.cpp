// Drives the Phelps-Tucker kernels over points: breakage rates, weights of the series, blocks of eight.
#include "continuum/phelps_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <new>

#include "base/error.hpp"
#include "base/kernels.hpp"
#include "base/number_checks.hpp"
#include "base/threads.hpp"
#include "continuum/phelps_block.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t lanes = 8;
/// Share of the breakage events that the series may leave out, each part of a step.
constexpr double series_tolerance = 1e-14;
/// Events Qt a fiber may meet in one part of a step: more cost more parts, fewer waste the series' start.
constexpr double largest_exposure = 32;
/// Parts of a step after which a flow counts as impossible: fibers would break three million times.
constexpr double most_parts = 1e5;
/// Parts after which a long step is looked at: it ends where nothing that can break is left.
constexpr double parts_between_looks = 64;
/// Enough for the tolerance at the largest exposure (the rest is below 1e-14 after 84 terms).
constexpr std::size_t most_terms = 96;

class AlignedDoubles {
 public:
  explicit AlignedDoubles(std::size_t size)
      : data_(static_cast<double*>(::operator new[](size * sizeof(double), alignment))), size_(size) {
    std::fill(data_, data_ + size, 0.0);
  }
  ~AlignedDoubles() { ::operator delete[](data_, alignment); }
  AlignedDoubles(const AlignedDoubles&) = delete;
  AlignedDoubles& operator=(const AlignedDoubles&) = delete;
  [[nodiscard]] double* data() { return data_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  double& operator[](std::size_t i) { return data_[i]; }

 private:
  static constexpr std::align_val_t alignment{64};
  double* data_;
  std::size_t size_;
};

void advance_phelps(const PhelpsBlock& block) {
  return FIBERFATE_KERNEL(advance_phelps)(block);
}

/// How many terms leave less than the tolerance of the Poisson weights of this exposure.
std::size_t terms_for(double exposure) {
  double weight = std::exp(-exposure);
  double rest = -std::expm1(-exposure);
  std::size_t terms = 0;
  while (rest > series_tolerance && terms < most_terms) {
    ++terms;
    weight *= exposure / static_cast<double>(terms);
    rest -= weight;
    // Past the peak the rest is below a geometric series, which subtraction can no longer resolve.
    const double ratio = exposure / static_cast<double>(terms + 1);
    if (ratio < 1) rest = std::min(rest, weight * ratio / (1 - ratio));
  }
  return terms;
}

void check_constants(const PhelpsConstants& c) {
  for (const double number :
       {c.breakage_coefficient, c.drag_coefficient, c.spread, c.modulus, c.diameter, c.unbreakable_length})
    if (!std::isfinite(number))
      throw InputError("the Phelps model has a constant that is not finite", "give finite numbers");
  const bool rates = c.breakage_coefficient >= 0 && std::isfinite(c.breakage_coefficient);
  const bool given = c.unbreakable_length > 0 && std::isfinite(c.unbreakable_length);
  const bool computed = c.drag_coefficient > 0 && c.modulus > 0 && c.diameter > 0;
  if (!rates || !(given || computed))
    throw InputError("the Phelps model has a constant that is not positive",
                     "give C_B, S and either zeta, E_f and d_f or L_ub as positive numbers");
}

/// Numbers of the packed children: four rows at a time, from their first column on.
std::size_t packed_size(std::size_t bins) {
  std::size_t size = 0;
  for (std::size_t row = 0; row < bins; row += 4) size += 4 * (bins - row - 1);
  return size;
}

std::vector<double> packed_children(std::size_t bins, double spread) {
  require_child_bins(bins, spread);
  std::vector<double> packed(packed_size(bins), 0.0);
  std::vector<double> column(bins);
  for (std::size_t k = 1; k < bins; ++k) {
    fill_children(k + 1, spread, std::span(column).first(k));
    double* rows = packed.data();
    for (std::size_t row = 0; row < k; row += 4) {
      double* place = rows + 4 * (k - row - 1);
      for (std::size_t i = row; i < std::min(row + 4, k); ++i) place[i - row] = column[i];
      rows += 4 * (bins - row - 1);
    }
  }
  return packed;
}

}  // namespace

void LengthBins::check() const {
  if (!(largest_length > 0) || !std::isfinite(largest_length))
    throw InputError("the bins of a length distribution have no length", "give the largest length");
  if (bins < 2 || bins > most_bins) require_child_bins(bins, 1);
}

std::vector<double> LengthBins::lengths() const {
  std::vector<double> result(bins);
  for (std::size_t i = 0; i < bins; ++i) result[i] = length(i);
  return result;
}

std::vector<double> sort_into_bins(const LengthClasses& classes, const LengthBins& bins) {
  classes.check();
  bins.check();
  std::vector<double> numbers(bins.bins, 0.0);
  for (std::size_t j = 0; j < classes.lengths.size(); ++j) {
    // A length computed as a multiple of the width may miss its bin by a few last digits: such a length is
    // the bin's.
    const double exact = classes.lengths[j] / bins.width();
    const double nearest = std::round(exact);
    const double place = std::abs(exact - nearest) < 1e-12 * exact ? nearest : exact;
    if (place > static_cast<double>(bins.bins))
      throw InputError("the initial distribution has fibers longer than the last bin",
                       "raise the largest length of the bins");
    if (place <= 1) {
      numbers[0] += classes.numbers[j] * place;
      continue;
    }
    const auto below = static_cast<std::size_t>(place);
    const double part = place - static_cast<double>(below);
    numbers[below - 1] += classes.numbers[j] * (1 - part);
    if (part > 0) numbers[below] += classes.numbers[j] * part;
  }
  return numbers;
}

struct PhelpsSolver::Scratch {
  explicit Scratch(std::size_t bins)
      : share(bins * lanes),
        numbers(bins * lanes),
        power(bins * lanes),
        broken(bins * lanes),
        integral(bins * lanes),
        weights((most_terms + 1) * lanes),
        tails((most_terms + 1) * lanes) {}

  /// Fills Poisson weights of every lane, scaled so that those kept sum to one, and the sums of the later
  /// ones.
  void fill_weights(std::size_t terms, double duration) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double exposure = largest_rate[lane] * duration;
      double weight = std::exp(-exposure);
      double sum = weights[lane] = weight;
      for (std::size_t j = 1; j <= terms; ++j) {
        weight *= exposure / static_cast<double>(j);
        sum += weights[j * lanes + lane] = weight;
      }
      double tail = 0;
      for (std::size_t j = terms + 1; j-- > 0;) {
        tails[j * lanes + lane] = tail;
        tail += weights[j * lanes + lane] /= sum;
      }
    }
  }

  /// Whether any fiber that can break is left.
  [[nodiscard]] bool can_break() {
    for (std::size_t i = first_row * lanes; i < share.size(); ++i)
      if (share[i] > 0 && numbers[i] > 0) return true;
    return false;
  }

  AlignedDoubles share, numbers, power, broken, integral, weights, tails;
  std::array<double, lanes> largest_rate{};  ///< Q of every lane, 1/s
  std::size_t first_row = 0;
};

PhelpsSolver::PhelpsSolver(const PhelpsConstants& constants, const LengthBins& bins)
    : constants_(constants), bins_(bins), padded_bins_((bins.bins + 3) / 4 * 4) {
  check_constants(constants);
  bins.check();
  children_ = packed_children(bins.bins, constants.spread);
  for (const double length : bins.lengths()) fourth_powers_.push_back((length * length) * (length * length));
}

double PhelpsSolver::memory_bytes(std::size_t bins) {
  // Also for numbers of bins that are refused, whose packed size would overflow.
  const double count = static_cast<double>(bins);
  return sizeof(double) * (0.5 * count * count + 3 * count);
}

double PhelpsSolver::scratch_bytes(std::size_t bins) {
  return sizeof(double) * lanes * (5 * static_cast<double>(bins) + 2 * (most_terms + 1.0));
}

double PhelpsSolver::fill_shares(const LengthFlows& flows, std::size_t first_point, Scratch& scratch) const {
  const std::size_t count = std::min(lanes, flows.size() - first_point);
  std::size_t first_broken = bins_.bins;
  double largest = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const LengthFlow flow = lane < count ? flows[first_point + lane] : LengthFlow{};
    const double coefficient = buckling_coefficient(constants_, flow);
    const auto share_of = [&](std::size_t i) {
      return i == 0 ? 0.0 : breakage_share(constants_, coefficient * fourth_powers_[i]);
    };
    // Both rates rise with the length, so the last bin's is the largest.
    const double top = share_of(bins_.bins - 1);
    scratch.largest_rate[lane] = constants_.breakage_coefficient * flow.rate * top;
    largest = std::max(largest, scratch.largest_rate[lane]);
    const double scale = top > 0 ? 1 / top : 0.0;
    std::size_t i = bins_.bins;
    while (i-- > 0) {
      const double share = share_of(i);
      scratch.share[i * lanes + lane] = std::min(1.0, share * scale);
      if (!(share > 0)) break;
      first_broken = std::min(first_broken, i);
    }
    for (++i; i-- > 0;) scratch.share[i * lanes + lane] = 0;
  }
  scratch.first_row = first_broken / 4 * 4;
  return largest;
}

bool PhelpsSolver::advance_block(const LengthFlows& flows, double duration, std::size_t first_point,
                                 std::span<double> numbers, Scratch& scratch) const {
  const double exposure = fill_shares(flows, first_point, scratch) * duration;
  if (!(exposure > 0)) return true;
  const double parts = std::ceil(exposure / largest_exposure);
  if (!(parts <= most_parts)) return false;
  const std::size_t terms = terms_for(exposure / parts);
  scratch.fill_weights(terms, duration / parts);

  const std::size_t points = flows.size();
  const std::size_t count = std::min(lanes, points - first_point);
  for (std::size_t i = 0; i < bins_.bins; ++i)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      scratch.numbers[i * lanes + lane] = lane < count ? numbers[i * points + first_point + lane] : 0.0;
  const PhelpsBlock block = {children_.data(),
                             bins_.bins,
                             padded_bins_,
                             scratch.first_row,
                             terms,
                             scratch.share.data(),
                             scratch.weights.data(),
                             scratch.tails.data(),
                             scratch.numbers.data(),
                             scratch.power.data(),
                             scratch.broken.data(),
                             scratch.integral.data()};
  for (double part = 1; part <= parts; ++part) {
    advance_phelps(block);
    if (std::fmod(part, parts_between_looks) == 0 && !scratch.can_break()) break;
  }
  for (std::size_t i = 0; i < bins_.bins; ++i)
    for (std::size_t lane = 0; lane < count; ++lane)
      numbers[i * points + first_point + lane] = scratch.numbers[i * lanes + lane];
  return true;
}

void PhelpsSolver::advance(const LengthFlows& flows, double duration, std::span<double> numbers) const {
  const std::size_t points = flows.size();
  require_number("duration", duration, not_negative);
  flows.check();
  require_same_size("numbers", numbers.size(), points * bins_.bins);
  require_numbers("numbers", numbers, not_negative);
  std::atomic<bool> arrived = true;
  const auto blocks = static_cast<std::ptrdiff_t>((points + lanes - 1) / lanes);
  const std::ptrdiff_t shares = std::min<std::ptrdiff_t>(blocks, thread_count());
  const auto advance_share = [&](std::ptrdiff_t share) {
    Scratch scratch(padded_bins_);
    for (std::ptrdiff_t block = blocks * share / shares; block < blocks * (share + 1) / shares; ++block)
      if (!advance_block(flows, duration, static_cast<std::size_t>(block) * lanes, numbers, scratch))
        arrived = false;
  };
  if (shares > 1)
    parallel_for(shares, advance_share);
  else if (shares == 1)
    advance_share(0);
  if (!arrived)
    throw SimulationFailure(
        fmt::format(
            "fibers would break more than {:.0g} times in {:g} s: the shear rate or the time is too large",
            most_parts * largest_exposure, duration),
        {});
}

void PhelpsSolver::advance(const LengthFlow& flow, double duration, std::span<double> numbers) const {
  advance({{&flow.rate, 1}, {&flow.viscosity, 1}, {&flow.compression, 1}}, duration, numbers);
}

std::vector<double> PhelpsSolver::breakage_rates(const LengthFlow& flow) const {
  std::vector<double> rates(bins_.bins);
  breakage_rates({{&flow.rate, 1}, {&flow.viscosity, 1}, {&flow.compression, 1}}, rates);
  return rates;
}

void PhelpsSolver::breakage_rates(const LengthFlows& flows, std::span<double> rates) const {
  const std::size_t points = flows.size();
  flows.check();
  require_same_size("rates", rates.size(), points * bins_.bins);
  for (std::size_t point = 0; point < points; ++point) {
    const LengthFlow flow = flows[point];
    const double coefficient = buckling_coefficient(constants_, flow);
    rates[point] = 0;
    for (std::size_t i = 1; i < bins_.bins; ++i)
      rates[i * points + point] = constants_.breakage_coefficient * flow.rate *
                                  breakage_share(constants_, coefficient * fourth_powers_[i]);
  }
}

}  // namespace fiberfate
